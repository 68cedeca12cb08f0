#pragma once
/// Between the fields of PackOptions and JobSettings and the values of the option table.

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "spectralpack/names.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {

/// "reference:300", and back; none for anything else.
std::string text_of(const VerifyWith& verify);
std::optional<VerifyWith> parse_verify(std::string_view text);

inline OptionValue to_value(bool value) { return value; }
inline OptionValue to_value(int value) { return std::int64_t{value}; }
inline OptionValue to_value(std::int64_t value) { return value; }
inline OptionValue to_value(std::uint64_t value) { return value; }
inline OptionValue to_value(double value) { return value; }
inline OptionValue to_value(const Vec3& value) { return value; }
inline OptionValue to_value(const std::string& value) { return value; }
inline OptionValue to_value(const std::vector<std::string>& value) { return value; }
inline OptionValue to_value(const VerifyWith& value) { return text_of(value); }
template <Named Enum>
OptionValue to_value(Enum value) {
    return std::string(to_string(value));
}
template <class T>
OptionValue to_value(const std::optional<T>& value) {
    return value ? to_value(*value) : OptionValue();
}

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// The value is one that the option accepts.
template <class T>
T from_value(const OptionValue& value) {
    if constexpr (kIsOptional<T>) {
        if (std::holds_alternative<std::monostate>(value)) return std::nullopt;
        return from_value<typename T::value_type>(value);
    } else if constexpr (Named<T>) {
        return *from_string<T>(std::get<std::string>(value));
    } else if constexpr (std::is_same_v<T, VerifyWith>) {
        return *parse_verify(std::get<std::string>(value));
    } else if constexpr (std::is_same_v<T, int>) {
        return static_cast<int>(std::get<std::int64_t>(value));
    } else {
        return std::get<T>(value);
    }
}

template <auto kMember, class Settings, class T>
OptionField<Settings> field_of(T Settings::*) {
    return {[](const Settings& settings) { return to_value(settings.*kMember); },
            [](Settings& settings, const OptionValue& value) { settings.*kMember = from_value<T>(value); }};
}

}  // namespace spectralpack
