#include <fmt/format.h>

#include <cmath>

#include "documents.hpp"
#include "json_values.hpp"

#include <spectralpack/files.hpp>
#include <spectralpack/names.hpp>

namespace spectralpack::docs {
namespace {

/// The schema but for its options: `@NAME@` is the rule of that option, `@options@` those of all.
constexpr const char* kFrame =
#include "job_schema_frame.inc"
    ;

std::string json_list(const std::vector<std::string>& elements) {
    return fmt::format("[{}]", fmt::join(elements, ", "));
}

/// The words and null.
std::string enumerated(const Option& option) {
    std::vector<std::string> words;
    for (const std::string_view word : option.words) {
        words.push_back(json_string(std::string(word)));
    }
    if (!option.none_word.empty()) words.push_back(json_string(std::string(option.none_word)));
    words.emplace_back("null");
    return "\"enum\": " + json_list(words);
}

/// ", "minimum": 1, "maximum": 8"; whatever an int holds is no bound.
std::string bounds(const Option& option) {
    const auto is_bound = [&](double bound) {
        return std::isfinite(bound) && (option.type != OptionType::integer || std::abs(bound) < 2e9);
    };
    std::string text;
    if (is_bound(option.least)) {
        text += fmt::format(", \"{}\": {}", option.above ? "exclusiveMinimum" : "minimum", option.least);
    }
    if (is_bound(option.most)) text += fmt::format(", \"maximum\": {}", option.most);
    if (option.type == OptionType::natural) text += ", \"maximum\": 18446744073709551615";
    return text;
}

std::string number_rule(const Option& option, const char* type) {
    if (!option.zero_word.empty()) {
        return fmt::format(
            R"("anyOf": [{{"type": "{}"{}}}, {{"type": "string", "pattern": "^({}|[1-9][0-9]*)$"}}, {{"type": "null"}}])",
            type, bounds(option), option.zero_word);
    }
    if (!option.none_word.empty()) {
        return fmt::format(R"("anyOf": [{{"type": "{}"{}}}, {{"enum": ["{}", null]}}])", type, bounds(option),
                           option.none_word);
    }
    return fmt::format(R"("type": ["{}", "null"]{})", type, bounds(option));
}

std::string values_rule(const Option& option) {
    switch (option.type) {
        case OptionType::flag:
            return R"("type": ["boolean", "null"])";
        case OptionType::integer:
        case OptionType::natural:
        case OptionType::bytes:
            return number_rule(option, "integer");
        case OptionType::number:
            return number_rule(option, "number");
        case OptionType::size:
            return R"("anyOf": [{"$ref": "#/$defs/size"}, {"type": "null"}])";
        case OptionType::word:
            return enumerated(option);
        case OptionType::rotations:
            return R"("type": ["string", "number", "null"])";
        case OptionType::verify:
            return fmt::format(R"("type": ["string", "null"], "pattern": "^({})(:[0-9]+)?$")",
                               fmt::join(words_of<EngineKind>(), "|"));
        case OptionType::text:
            return R"("type": ["string", "null"])";
        case OptionType::file:
        case OptionType::folder:
            return R"("type": ["string", "null"], "minLength": 1)";
        case OptionType::files:
            return R"("anyOf": [{"type": "string", "minLength": 1}, {"type": "array", "items": {"type": "string", "minLength": 1}}, {"type": "null"}])";
    }
    return "";
}

std::string rule(const Option& option) {
    std::string description = std::string(option.line) + ".";
    if (!option.help.empty()) description += " " + std::string(option.help);
    std::vector<std::string> parts{"\"description\": " + json_string(description), values_rule(option)};
    const OptionValue by_default = default_of(option);
    if (!text_of(option, by_default).empty()) {
        parts.push_back("\"default\": " + json_of(option, by_default));
    }
    std::vector<std::string> examples;
    for (const OptionValue& value : examples_of(option)) {
        examples.push_back(json_of(option, value));
    }
    parts.push_back("\"examples\": " + json_list(examples));
    return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string all_rules() {
    std::string rules;
    for (const Option& option : option_table()) {
        if (!option.in_pack.get && !option.in_job.get) continue;
        rules += fmt::format("{}        \"{}\": {}", rules.empty() ? "" : ",\n", option.name, rule(option));
    }
    return rules;
}

}  // namespace

std::string job_schema() {
    std::string text;
    const std::string frame = kFrame + 1;  // after the line feed that opens it
    for (std::size_t at = 0; at < frame.size();) {
        const std::size_t mark = frame.find('@', at);
        text += frame.substr(at, mark - at);
        if (mark == std::string::npos) break;
        const std::size_t end = frame.find('@', mark + 1);
        const std::string name = frame.substr(mark + 1, end - mark - 1);
        text += name == "options" ? all_rules() : rule(*find_option(name));
        at = end + 1;
    }
    return text;
}

}  // namespace spectralpack::docs
