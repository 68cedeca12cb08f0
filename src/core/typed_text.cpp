#include "spectralpack/typed_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace spectralpack {
namespace {

constexpr std::size_t kLettersPerSlip = 3;  // of a word for each that may be wrong
constexpr std::size_t kLeastAbbreviation = 3;

/// Damerau and Levenshtein's, without edits of what was swapped.
std::size_t distance_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

}  // namespace

std::string lower_case(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

std::string ending_of(const std::filesystem::path& path) { return lower_case(path.extension().string()); }

std::optional<std::string> nearest_word(std::string_view typed, std::span<const std::string> words) {
    const std::string wanted = lower_case(std::string(typed));
    const std::string* nearest = nullptr;
    std::size_t least = 0;
    for (const std::string& word : words) {
        const std::string candidate = lower_case(word);
        const bool begun = wanted.size() >= kLeastAbbreviation && candidate.starts_with(wanted);
        const std::size_t distance = begun ? 1 : distance_between(wanted, candidate);
        const std::size_t most = std::max<std::size_t>(1, std::min(wanted.size(), candidate.size()) / kLettersPerSlip);
        if (distance > most || (nearest && distance >= least)) continue;
        nearest = &word;
        least = distance;
    }
    if (!nearest && wanted.size() >= kLeastAbbreviation) {
        const auto holds = [&](const std::string& word) { return lower_case(word).find(wanted) != std::string::npos; };
        const auto found = std::ranges::find_if(words, holds);
        if (found != words.end()) return *found;
    }
    return nearest ? std::optional(*nearest) : std::nullopt;
}

}  // namespace spectralpack
