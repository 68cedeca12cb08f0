#include "keep_outs.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace spectralpack::cli {
namespace {

constexpr std::size_t kNumbers = 6;

/// Numbers with commas between, blanks aside; none where the text is anything else.
std::optional<std::vector<double>> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip_blanks = [&] {
        while (at != end && *at == ' ') {
            ++at;
        }
    };
    for (;;) {
        skip_blanks();
        const auto parsed = std::from_chars(at, end, numbers.emplace_back());
        if (parsed.ec != std::errc{}) return std::nullopt;
        at = parsed.ptr;
        skip_blanks();
        if (at == end) return numbers;
        if (*at++ != ',') return std::nullopt;
    }
}

}  // namespace

KeepOutSource parse_keep_out(const std::string& text, const Vec3& tray) {
    const auto numbers = numbers_in(text);
    if (!numbers) return {{}, MeshSource{text, "--keep-out"}};
    const std::vector<double>& n = *numbers;
    if (n.size() != kNumbers) {
        std::string advice;
        if (n.size() == 4 && tray.z > 0) {
            advice = fmt::format(" For the full height of the tray: {:g},{:g},0,{:g},{:g},{:g}.", n[0], n[1], n[2],
                                 n[3], tray.z);
        }
        throw UsageError(fmt::format("--keep-out {}: six numbers are wanted, x0,y0,z0,x1,y1,z1; here {} {}.{}", text,
                                     n.size() == 1 ? "is" : "are", n.size(), advice));
    }
    const Box box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] < box.max[axis]) || !std::isfinite(box.max[axis] - box.min[axis])) {
            throw UsageError(
                fmt::format("--keep-out {}: the second corner must lie beyond the first on every axis", text));
        }
    }
    return {box};
}

}  // namespace spectralpack::cli
