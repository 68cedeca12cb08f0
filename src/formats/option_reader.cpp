#include "formats/option_reader.hpp"

#include <fmt/format.h>

namespace spectralpack {
namespace {

[[noreturn]] void refuse(const Node& node, const Option& option) { node.fail("must be " + values_of(option)); }

/// A number of trays may be said as text, too.
OptionValue integer_in(const Node& node, const Option& option) {
    if (option.zero_word.empty()) return node.integer<std::int64_t>();
    if (node.is_text()) {
        try {
            return parse_value(option, node.text());
        } catch (const UsageError&) {
            refuse(node, option);
        }
    }
    const auto number = node.integer<std::int64_t>();
    if (number == 0) refuse(node, option);
    return number;
}

std::vector<std::string> texts_in(const Node& node) {
    if (node.is_text()) return {node.text()};
    std::vector<std::string> texts;
    node.for_each([&](const Node& element) { texts.push_back(element.text()); });
    return texts;
}

OptionValue value_in(const Node& node, const Option& option) {
    if (!option.none_word.empty() && node.is_text() && node.text() == option.none_word) return std::monostate{};
    switch (option.type) {
        case OptionType::flag:
            return node.boolean();
        case OptionType::integer:
            return integer_in(node, option);
        case OptionType::natural:
            return node.integer<std::uint64_t>();
        case OptionType::bytes:
            return node.integer<std::int64_t>();
        case OptionType::number:
            return node.number();
        case OptionType::size:
            return size_of(node);
        case OptionType::rotations:
            return node.is_text() ? node.text() : fmt::format("{:g}", node.number());
        case OptionType::files:
            return texts_in(node);
        case OptionType::word:
        case OptionType::verify:
        case OptionType::text:
        case OptionType::file:
        case OptionType::folder:
            return node.text();
    }
    return {};
}

}  // namespace

OptionValue read_value(const Node& node, const Option& option) {
    OptionValue value = value_in(node, option);
    if (!accepts(option, value)) refuse(node, option);
    return value;
}

void read_options(const Node& node, PackOptions& options) {
    for (const Option& option : option_table()) {
        if (!option.in_pack.set) continue;
        if (const auto said = node.find(option.name)) option.in_pack.set(options, read_value(*said, option));
    }
}

}  // namespace spectralpack
