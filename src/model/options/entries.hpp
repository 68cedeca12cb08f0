#pragma once
/// The entries of the option table, in pieces that are joined in this order (table.cpp).

#include <limits>
#include <vector>

#include "model/options/field.hpp"

namespace spectralpack {

std::vector<Option> output_options();
std::vector<Option> input_options();
std::vector<Option> container_options();
std::vector<Option> grid_options();
std::vector<Option> gap_options();
std::vector<Option> placing_options();
std::vector<Option> filling_options();
std::vector<Option> order_options();
std::vector<Option> run_options();
std::vector<Option> program_options();

inline constexpr int kMostInt = std::numeric_limits<int>::max();

template <class T>
struct WithoutOptional {
    using Type = T;
};
template <class T>
struct WithoutOptional<std::optional<T>> {
    using Type = T;
};

/// `entry` for a field of PackOptions or JobSettings. Of an enum it takes the words.
template <auto kMember, class Settings, class T>
Option kept_at(T Settings::*, Option entry) {
    using Value = typename WithoutOptional<T>::Type;
    if constexpr (Named<Value>) {
        entry.type = OptionType::word;
        entry.words = words_of<Value>();
    }
    entry.optional = kIsOptional<T>;
    if constexpr (std::is_same_v<Settings, PackOptions>) {
        entry.in_pack = field_of<kMember>(kMember);
    } else {
        entry.in_job = field_of<kMember>(kMember);
    }
    return entry;
}

template <auto kMember>
Option kept_in(Option entry) {
    return kept_at<kMember>(kMember, std::move(entry));
}

}  // namespace spectralpack
