#include "json_values.hpp"

#include <fmt/format.h>

#include <spectralpack/files.hpp>

namespace spectralpack::docs {

std::string json_of(const Option& option, const OptionValue& value) {
    const std::string text = text_of(option, value);
    if (std::holds_alternative<std::monostate>(value)) return text.empty() ? "null" : json_string(text);
    if (const auto* size = std::get_if<Vec3>(&value)) {
        return size->z == 0 ? fmt::format("[{}, {}]", size->x, size->y)
                            : fmt::format("[{}, {}, {}]", size->x, size->y, size->z);
    }
    if (std::holds_alternative<std::vector<std::string>>(value) || std::holds_alternative<std::string>(value)) {
        return json_string(text);
    }
    return !option.zero_word.empty() && text == option.zero_word ? json_string(text) : text;
}

std::vector<OptionValue> examples_of(const Option& option) {
    if (option.type == OptionType::flag) return {default_of(option) != OptionValue(true)};
    std::vector<OptionValue> values;
    for (const std::string_view example : option.examples) {
        values.push_back(parse_value(option, example));
    }
    return values;
}

}  // namespace spectralpack::docs
