#pragma once
/// Options that take a number, of the commands beside pack. They are read as those of pack are (option_table.hpp): in
/// decimal, the whole text, within a range; anything else is a UsageError that names the option.

#include <CLI/CLI.hpp>
#include <concepts>
#include <limits>
#include <optional>
#include <string>

#include <spectralpack/option_table.hpp>

namespace spectralpack::cli {

struct NumberRange {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above = false;  ///< `least` itself is too small
};

inline constexpr NumberRange kAnyNumber{};
inline constexpr NumberRange kFromZero{0};
inline constexpr NumberRange kAboveZero{0, std::numeric_limits<double>::infinity(), true};
inline constexpr NumberRange kFromOne{1, std::numeric_limits<int>::max()};

template <class T>
struct NumberIn {
    using Type = T;
};
template <class T>
struct NumberIn<std::optional<T>> {
    using Type = T;
};

/// Puts what the option says into `target`, which lives as long as the command.
template <class Target>
CLI::Option* add_number(CLI::App& command, const Option& option, Target& target, const std::string& help) {
    using Number = typename NumberIn<Target>::Type;
    return command
        .add_option_function<std::string>(
            "--" + std::string(option.name),
            [&target, option](const std::string& text) {
                const OptionValue value = parse_value(option, text);
                if constexpr (std::floating_point<Number>) {
                    target = std::get<double>(value);
                } else if constexpr (std::unsigned_integral<Number>) {
                    target = std::get<std::uint64_t>(value);
                } else {
                    target = static_cast<Number>(std::get<std::int64_t>(value));
                }
            },
            help)
        ->type_name(std::string(option.placeholder));
}

/// The same for an option that pack does not have. `name` without dashes and `placeholder` are literals.
template <class Target>
CLI::Option* add_number(CLI::App& command, const char* name, const char* placeholder, const NumberRange& range,
                        Target& target, const std::string& help) {
    using Number = typename NumberIn<Target>::Type;
    Option option;
    option.name = name;
    option.placeholder = placeholder;
    option.type = std::floating_point<Number>      ? OptionType::number
                  : std::unsigned_integral<Number> ? OptionType::natural
                                                   : OptionType::integer;
    option.least = range.least;
    option.most = range.most;
    option.above = range.above;
    return add_number(command, option, target, help);
}

/// --threads, with the range that it has for pack.
template <class Target>
CLI::Option* add_threads(CLI::App& command, Target& target, const std::string& help = "threads, 0 for all") {
    return add_number(command, *find_option("threads"), target, help);
}

}  // namespace spectralpack::cli
