#include "text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace spectralpack::cli {
namespace {

constexpr int kMaxPictureSide = 16384;
constexpr std::size_t kMostNamed = 12;

}  // namespace

Vec3 parse_size(const std::string& text, const char* option) {
    const auto size = spectralpack::parse_size(text);
    if (!size || size->z == 0) {
        throw UsageError(fmt::format("{} takes three lengths in mm like 480x245x200, not '{}'", option, text));
    }
    return *size;
}

double parse_unit(const std::string& text) {
    return in_mm(from_string<LengthUnit>(std::get<std::string>(parse_value(*find_option("unit"), text))).value());
}

void parse_picture_size(const std::string& text, RenderOptions& options) {
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, options.width);
    const bool separated = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, options.height) : width;
    if (!separated || height.ec != std::errc{} || height.ptr != end || options.width < 16 || options.height < 16 ||
        options.width > kMaxPictureSide || options.height > kMaxPictureSide) {
        throw UsageError(fmt::format("--size takes pixels like 1600x1200 (16 to {}), not '{}'", kMaxPictureSide, text));
    }
}

std::string printable(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool second = i > 0 && static_cast<unsigned char>(text[i - 1]) == 0xc2;
        if (byte < 0x20 || byte == 0x7f) text[i] = '?';
        if (second && byte >= 0x80 && byte < 0xa0) text[i - 1] = text[i] = '?';  // U+0080 to U+009F
    }
    return text;
}

std::string copy_names(const Packing& packing, const TrayPacking& tray, const std::vector<int>& placements) {
    std::string text;
    const CopyNumbers numbers(packing.parts);
    for (std::size_t i = 0; i < placements.size() && i < kMostNamed; ++i) {
        const Placement& placement = tray.placements[static_cast<std::size_t>(placements[i])];
        text += fmt::format("{}{} {}", i > 0 ? ", " : "", numbers.of(placement),
                            printable(packing.parts[static_cast<std::size_t>(placement.part)].name));
    }
    if (placements.size() > kMostNamed) text += fmt::format(" and {} more", placements.size() - kMostNamed);
    return text;
}

std::size_t columns_of(std::string_view text) {
    // Of a character in UTF-8, all bytes but the first are 10xxxxxx.
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string wrapped(const std::string& text, std::size_t width) {
    std::string lines;
    std::size_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        const std::size_t columns = columns_of(word);
        const bool fits = column + 1 + columns <= width;
        if (begin > 0) lines += fits ? ' ' : '\n';
        column = begin > 0 && fits ? column + 1 + columns : columns;
        lines += word;
        begin = end + 1;
    }
    std::ranges::replace(lines, kBond, ' ');
    return lines;
}

std::string duration_text(double seconds) {
    if (seconds < 0.05) return "0.1 s";
    if (seconds < 9.95) return fmt::format("{:g} s", std::round(10 * seconds) / 10);
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string bytes_text(std::int64_t bytes) {
    const auto value = static_cast<double>(bytes);
    if (value < 1e6) return fmt::format("{:.0f} kB", std::ceil(value / 1e3));
    if (value < 1e9) return fmt::format("{:.0f} MB", value / 1e6);
    return fmt::format("{:.1f} GB", value / 1e9);
}

std::string through_walls_text(std::size_t steps) {
    return steps == 0 ? "" : fmt::format("; {} of them sideways through the walls", steps);
}

std::string staying_text(std::size_t copies) {
    if (copies == 0) return "";
    return copies == 1
               ? "; 1 copy that stood there before stays: it is not part of the order"
               : fmt::format("; {} copies that stood there before stay: they are not part of the order", copies);
}

std::string percent_text(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string length_text(double mm) { return fmt::format("{:g}", std::round(mm * 1000) / 1000); }

std::string gap_number(double mm) {
    const bool tenths = std::abs(10 * mm - std::round(10 * mm)) < 1e-6;
    return tenths ? fmt::format("{:.1f}", mm) : length_text(mm);
}

}  // namespace spectralpack::cli
