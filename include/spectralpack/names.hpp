#pragma once
/// The words for enumerated values, on the command line and in files: one table for each enum, read both ways.
///
///     to_string(Order::mixed)        "mixed"
///     from_string<Order>("mixed")    Order::mixed; none for a word that stands for nothing
///     words_of<Order>()              all of them
///
/// An enum of another header gets its words by a kWords of its own there.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "spectralpack/check.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/job_settings.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/orientations.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

template <std::size_t kCount>
using Words = std::array<std::string_view, kCount>;

/// In the order of the enum's values, which start at 0. Input hashes hold positions: new values come last.
template <class Enum>
inline constexpr std::nullptr_t kWords = nullptr;

// Options.
template <>
inline constexpr Words<3> kWords<Interlock>{"off", "place", "post"};
template <>
inline constexpr Words<2> kWords<Links>{"allow", "avoid"};
template <>
inline constexpr Words<3> kWords<TakeOut>{"smallest", "lightest", "thinnest"};
template <>
inline constexpr Words<2> kWords<Unpack>{"any", "top"};
template <>
inline constexpr Words<5> kWords<Order>{"size", "input", "random", "volume", "mixed"};
template <>
inline constexpr Words<4> kWords<Goal>{"fair", "volume", "copies", "value"};
template <>
inline constexpr Words<4> kWords<EngineKind>{"auto", "cpu", "cuda", "reference"};
template <>
inline constexpr Words<2> kWords<HeightReference>{"bottom", "top"};
template <>
inline constexpr Words<2> kWords<Minimise>{"none", "box"};

// Jobs.
template <>
inline constexpr Words<3> kWords<LengthUnit>{"mm", "inch", "m"};
template <>
inline constexpr Words<4> kWords<ProgressStyle>{"auto", "bar", "json", "none"};
template <>
inline constexpr Words<2> kWords<ContainerIs>{"solid", "vessel"};
/// Axes and matrices have no word: files list them.
template <>
inline constexpr Words<3> kWords<PartOrientations::Kind>{"any", "fixed", "upright"};

// Results.
template <>
inline constexpr Words<6> kWords<UnplacedReason>{"no_place", "too_large", "cannot_leave",
                                                 "bad_file", "not_tried", "cap"};
template <>
inline constexpr Words<8> kWords<FindingKind>{"outside",   "overlap", "nested", "gap",
                                              "transform", "density", "count",  "plan"};
template <>
inline constexpr Words<9> kWords<Phase>{"load",  "voxelize", "search", "disassemble", "reinsert",
                                        "check", "render",   "write",  "improve"};
template <>
inline constexpr Words<6> kWords<Improves>{"height", "density", "copies", "value", "trays", "box"};
template <>
inline constexpr Words<6> kWords<EventKind>{"tray_begun",     "copy_placed",   "copy_moved",
                                            "copy_taken_out", "copy_put_back", "tray_finished"};
template <>
inline constexpr Words<3> kWords<StopReason>{"none", "cancelled", "time_limit"};
template <>
inline constexpr Words<4> kWords<ErrorKind>{"usage", "input", "resource", "internal"};

/// An enum that has words.
template <class Enum>
concept Named = std::is_enum_v<Enum> && !std::is_same_v<decltype(kWords<Enum>), const std::nullptr_t>;

template <Named Enum>
constexpr std::span<const std::string_view> words_of() {
    return kWords<Enum>;
}

/// Empty for a value without a word.
template <Named Enum>
constexpr std::string_view to_string(Enum value) {
    const auto position = static_cast<std::size_t>(value);
    return position < words_of<Enum>().size() ? words_of<Enum>()[position] : std::string_view();
}

template <Named Enum>
constexpr std::optional<Enum> from_string(std::string_view word) {
    for (std::size_t i = 0; i < words_of<Enum>().size(); ++i) {
        if (words_of<Enum>()[i] == word) return static_cast<Enum>(i);
    }
    return std::nullopt;
}

}  // namespace spectralpack
