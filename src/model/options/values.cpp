#include <algorithm>
#include <charconv>
#include <cmath>

#include "model/options/field.hpp"
#include "model/rotation_samples.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/orientations.hpp"

namespace spectralpack {
namespace {

/// The whole of `text`, which may start with a plus sign, as a number.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    Number number{};
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The same as it was, in as few characters as can be.
std::string number_text(double number) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, number).ptr;
    return {text, end};
}

std::optional<std::int64_t> parse_bytes(std::string_view text) {
    double value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    std::string_view unit(parsed.ptr, static_cast<std::size_t>(text.data() + text.size() - parsed.ptr));
    if (unit.ends_with('B')) unit.remove_suffix(1);
    const bool binary = unit.ends_with('i');
    if (binary) unit.remove_suffix(1);
    constexpr std::string_view kPrefixes = "KMGT";
    const std::size_t power = unit.empty() ? 0 : kPrefixes.find(unit) + 1;
    const double bytes = value * std::pow(binary ? 1024.0 : 1000.0, static_cast<double>(power));
    const bool known = unit.empty() ? !binary : unit.size() == 1 && power > 0;
    if (parsed.ec != std::errc{} || !known || !(value >= 0) || !(bytes < 9e18)) return std::nullopt;
    return static_cast<std::int64_t>(bytes);
}

/// "a, b, c".
std::string joined(std::span<const std::string_view> words) {
    std::string list;
    for (const std::string_view word : words) {
        list += (list.empty() ? "" : ", ") + std::string(word);
    }
    return list;
}

/// " from 1 to 8", " above 0", " of at least 0 and at most 1"; empty for any. What an int cannot hold is not worth
/// saying.
std::string range_text(const Option& option) {
    if (option.type == OptionType::bytes) return "";
    constexpr double kMost = std::numeric_limits<int>::max();
    const bool below = std::abs(option.least) < kMost, over = std::abs(option.most) < kMost;
    const auto bound = [&](double value) {
        return option.type == OptionType::number ? number_text(value)
                                                 : std::to_string(static_cast<std::int64_t>(value));
    };
    if (below && over && !option.above) return " from " + bound(option.least) + " to " + bound(option.most);
    std::string text;
    if (below) text = (option.above ? " above " : " of at least ") + bound(option.least);
    if (over) text += (below ? " and at most " : " of at most ") + bound(option.most);
    return text;
}

bool in_range(const Option& option, double value) {
    return std::isfinite(value) && value <= option.most &&
           (option.above ? value > option.least : value >= option.least);
}

bool is_path(const std::string& text) { return !text.empty() && text.find('\0') == std::string::npos; }

bool is_rotations(const std::string& text) {
    try {
        const RotationSpec spec = parse_rotations(text);
        if (spec.sampling == RotationSpec::Sampling::euler) require_step(spec.step, "it");
        return spec.subdivisions >= 0 && spec.subdivisions <= kMostSubdivisions;
    } catch (const UsageError&) {
        return false;
    }
}

bool is_size(const Vec3& size) {
    const double least = std::min(size.x, size.y);
    return least > 0 && size.z >= 0 && std::isfinite(size.x + size.y + size.z);
}

bool accepts_text(const Option& option, const std::string& text) {
    switch (option.type) {
        case OptionType::word:
            return std::ranges::find(option.words, text) != option.words.end();
        case OptionType::rotations:
            return is_rotations(text);
        case OptionType::verify:
            return parse_verify(text).has_value();
        case OptionType::text:
            return true;
        case OptionType::file:
        case OptionType::folder:
            return is_path(text);
        default:
            return false;
    }
}

/// What the text says, whether or not the option accepts that; none where it says nothing of the option's type.
std::optional<OptionValue> read_text(const Option& option, std::string_view text) {
    const auto as_value = [](const auto& parsed) -> std::optional<OptionValue> {
        if (!parsed) return std::nullopt;
        return OptionValue(*parsed);
    };
    switch (option.type) {
        case OptionType::flag:
            if (text == "true") return true;
            if (text == "false") return false;
            return std::nullopt;
        case OptionType::integer:
            return as_value(parse_number<std::int64_t>(text));
        case OptionType::natural:
            return as_value(parse_number<std::uint64_t>(text));
        case OptionType::bytes:
            return as_value(parse_bytes(text));
        case OptionType::number:
            return as_value(parse_number<double>(text));
        case OptionType::size:
            return as_value(parse_size(text));
        case OptionType::files:
            return std::vector{std::string(text)};
        default:
            return std::string(text);
    }
}

std::string plain_text(const OptionValue& value) {
    struct Visitor {
        std::string operator()(std::monostate) const { return ""; }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(std::uint64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const { return number_text(number); }
        std::string operator()(const Vec3& size) const {
            const std::string base = number_text(size.x) + "x" + number_text(size.y);
            return size.z == 0 ? base : base + "x" + number_text(size.z);
        }
        std::string operator()(const std::string& text) const { return text; }
        std::string operator()(const std::vector<std::string>& list) const {
            std::string text;
            for (const std::string& element : list) {
                text += (text.empty() ? "" : " ") + element;
            }
            return text;
        }
    };
    return std::visit(Visitor{}, value);
}

}  // namespace

std::string text_of(const VerifyWith& verify) {
    const std::string engine(to_string(verify.engine));
    return verify.sample > 0 ? engine + ":" + std::to_string(verify.sample) : engine;
}

std::optional<VerifyWith> parse_verify(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto engine = from_string<EngineKind>(text.substr(0, colon));
    if (!engine) return std::nullopt;
    if (colon == std::string_view::npos) return VerifyWith{*engine};
    const auto sample = parse_number<int>(text.substr(colon + 1));
    if (!sample || *sample <= 0) return std::nullopt;
    return VerifyWith{*engine, *sample};
}

std::optional<Vec3> parse_size(std::string_view text) {
    Vec3 size;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int axis = 0; axis < 3; ++axis) {
        const auto parsed = std::from_chars(at, end, size[axis]);
        if (parsed.ec != std::errc{} || !(size[axis] > 0) || !std::isfinite(size[axis])) return std::nullopt;
        if (parsed.ptr == end) return axis == 0 ? std::nullopt : std::optional(size);
        if (axis == 2 || (*parsed.ptr != 'x' && *parsed.ptr != 'X')) return std::nullopt;
        at = parsed.ptr + 1;
    }
    return std::nullopt;
}

std::string values_of(const Option& option) {
    const auto kind = [&]() -> std::string {
        if (!option.takes.empty()) return std::string(option.takes);
        switch (option.type) {
            case OptionType::flag:
                return "true or false";
            case OptionType::integer:
            case OptionType::natural:
                return "a whole number" + range_text(option);
            case OptionType::bytes:
                return "a number of bytes, like 500M or 2G";
            case OptionType::number:
                return "a number" + range_text(option);
            case OptionType::size:
                return "lengths in mm like 480x245x200 or 480x245";
            case OptionType::word:
                return "one of " + joined(option.words);
            case OptionType::rotations:
                return "none, an angle in degrees of at least 6 that divides 360, or icosahedron:N; each also with +box";
            case OptionType::verify:
                return "an engine, or an engine and a number of placements, like reference:300";
            case OptionType::text:
                return "a text";
            case OptionType::file:
            case OptionType::files:
                return "the path of a file";
            case OptionType::folder:
                return "the path of a folder";
        }
        return "";
    }();
    if (!option.none_word.empty()) return kind + ", or " + std::string(option.none_word);
    return option.zero_word.empty() ? kind : kind + ", or " + std::string(option.zero_word);
}

bool accepts(const Option& option, const OptionValue& value) {
    struct Visitor {
        const Option& option;
        bool is(OptionType type) const { return option.type == type; }

        bool operator()(std::monostate) const { return option.optional; }
        bool operator()(bool) const { return is(OptionType::flag); }
        bool operator()(std::int64_t number) const {
            if (!is(OptionType::integer) && !is(OptionType::bytes)) return false;
            return (number == 0 && !option.zero_word.empty()) || in_range(option, static_cast<double>(number));
        }
        bool operator()(std::uint64_t) const { return is(OptionType::natural); }
        bool operator()(double number) const { return is(OptionType::number) && in_range(option, number); }
        bool operator()(const Vec3& size) const { return is(OptionType::size) && is_size(size); }
        bool operator()(const std::string& text) const { return accepts_text(option, text); }
        bool operator()(const std::vector<std::string>& list) const {
            return is(OptionType::files) && std::ranges::all_of(list, is_path);
        }
    };
    return std::visit(Visitor{option}, value);
}

void require_accepted(const Option& option, const OptionValue& value) {
    if (accepts(option, value)) return;
    throw UsageError("--" + std::string(option.name) + " takes " + values_of(option) + "; not '" +
                     text_of(option, value) + "'");
}

OptionValue parse_value(const Option& option, std::string_view text) {
    if (!option.none_word.empty() && text == option.none_word) return std::monostate{};
    if (!option.zero_word.empty() && text == option.zero_word) return std::int64_t{0};
    const auto value = read_text(option, text);
    // 0 has a word of its own.
    const bool zero = !option.zero_word.empty() && value == OptionValue(std::int64_t{0});
    if (value && !zero && accepts(option, *value)) return *value;
    throw UsageError("--" + std::string(option.name) + " takes " + values_of(option) + "; not '" + std::string(text) +
                     "'");
}

std::string text_of(const Option& option, const OptionValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return std::string(option.none_word);
    if (!option.zero_word.empty() && value == OptionValue(std::int64_t{0})) return std::string(option.zero_word);
    return plain_text(value);
}

OptionValue default_of(const Option& option) {
    if (option.in_pack.get) return option.in_pack.get({});
    if (option.in_job.get) return option.in_job.get({});
    return {};
}

std::string default_text(const Option& option) {
    const std::string value = text_of(option, default_of(option)), means(option.default_means);
    if (option.type == OptionType::flag) return value == "true" ? "on" : "";
    const std::string first = option.of_printer ? "the printer's, else " : "";
    return first + (value.empty() || means.empty() ? value + means : value + ": " + means);
}

std::string short_default_text(const Option& option) {
    const std::string text = default_text(option);
    if (text.starts_with("0: ")) return text.substr(3);  // a number that stands for something else
    return text.substr(0, text.find(':'));
}

void set_option(PackOptions& options, std::string_view name, std::string_view text) {
    const Option* option = find_option(name);
    if (!option || !option->in_pack.set) throw UsageError("there is no option --" + std::string(name));
    option->in_pack.set(options, parse_value(*option, text));
}

}  // namespace spectralpack
