#include "left_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "summary_lines.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct PartCount {
    int part = 0;
    std::size_t copies = 0;
};

struct ReasonCount {
    UnplacedReason reason = UnplacedReason::no_place;
    std::size_t copies = 0;
    std::vector<PartCount> parts;
    std::string never_fits = {};  ///< of no_place: why there is none in an empty tray either
};

/// The largest numbers first; among equals, in the order in which they were given up.
std::vector<ReasonCount> by_reason(const Packing& packing) {
    std::vector<ReasonCount> reasons;
    std::map<std::pair<UnplacedReason, int>, std::size_t> counts;
    for (const Unplaced& copy : packing.unplaced) {
        auto known = std::ranges::find(reasons, copy.reason, &ReasonCount::reason);
        if (known == reasons.end()) known = reasons.insert(known, {copy.reason, 0, {}, {}});
        ++known->copies;
        if (copy.reason == UnplacedReason::no_place) known->never_fits = copy.detail;
        if (++counts[{copy.reason, copy.part}] == 1) known->parts.push_back({copy.part, 0});
    }
    for (ReasonCount& reason : reasons) {
        for (PartCount& part : reason.parts) {
            part.copies = counts[{reason.reason, part.part}];
        }
        std::ranges::stable_sort(reason.parts, std::ranges::greater{}, &PartCount::copies);
    }
    std::ranges::stable_sort(reasons, std::ranges::greater{}, &ReasonCount::copies);
    return reasons;
}

std::size_t lines_in(const std::string& text) {
    const std::string lines = wrapped(text, kValueWidth);
    return 1 + static_cast<std::size_t>(std::ranges::count(lines, '\n'));
}

std::string with_names(const std::string& head, const ReasonCount& reason, const Packing& packing, std::size_t lines) {
    std::string names, best = head;
    for (std::size_t i = 0; i < reason.parts.size(); ++i) {
        const auto& [part, copies] = reason.parts[i];
        const std::string name = printable(packing.parts[static_cast<std::size_t>(part)].name);
        names += (i > 0 ? ", " : "") + (copies > 1 ? fmt::format("{}{}{}", copies, kBond, name) : name);
        const std::size_t more = reason.parts.size() - i - 1;
        const std::string rest = more > 0 ? fmt::format(" and {} more part{}", more, more == 1 ? "" : "s") : "";
        const std::string text = fmt::format("{}: {}{}", head, names, rest);
        if (lines_in(text) <= lines) {
            best = text;
        } else if (lines_in(fmt::format("{}: {}", head, names)) > lines) {
            break;
        }
    }
    return best;
}

std::string reason_text(const ReasonCount& reason, const Packing& packing, StopReason stopped, std::size_t lines) {
    if (reason.reason == UnplacedReason::not_tried) {
        const char* why = stopped == StopReason::time_limit  ? " (time limit)"
                          : stopped == StopReason::cancelled ? " (interrupted)"
                                                             : "";
        return fmt::format("{}{}: {}", in_words(reason.reason), why, reason.copies);
    }
    const std::string what = reason.never_fits.empty() ? in_words(reason.reason) : reason.never_fits;
    return with_names(fmt::format("{}: {}", what, reason.copies), reason, packing, lines);
}

bool any(const Packing& packing, UnplacedReason reason) {
    return std::ranges::find(packing.unplaced, reason, &Unplaced::reason) != packing.unplaced.end();
}

}  // namespace

std::string what_takes_more(const Packing& packing) {
    const auto finds_more = [](const Unplaced& copy) {
        return copy.reason == UnplacedReason::no_place && copy.detail.empty();
    };
    const bool more_trays = packing.options.trays != 0 && !packing.options.fill && !packing.container.open_height;
    return more_trays && std::ranges::any_of(packing.unplaced, finds_more) ? "--trays all opens more trays" : "";
}

std::vector<std::string> left_over_texts(const Packing& packing, StopReason stopped, std::size_t lines) {
    std::vector<std::string> texts;
    for (const ReasonCount& reason : by_reason(packing)) {
        texts.push_back(reason_text(reason, packing, stopped, lines));
    }
    std::string helps = what_takes_more(packing);
    const auto add = [&](const char* text) { helps += (helps.empty() ? "" : "; ") + std::string(text); };
    if (any(packing, UnplacedReason::cap)) {
        add(packing.options.max_density ? "a higher --max-density takes more" : "a higher --max-layer-fill takes more");
    }
    if (any(packing, UnplacedReason::cannot_leave)) {
        add("those that cannot leave were caught in other copies and found no other place");
    }
    if (!helps.empty()) texts.push_back(helps);
    return texts;
}

}  // namespace spectralpack::cli
