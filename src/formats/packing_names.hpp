#pragma once
/// The words that packing files use for enumerated values; those of options are the command line's.

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "spectralpack/options.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

template <class Value, std::size_t N>
using Names = std::array<std::pair<std::string_view, Value>, N>;

inline constexpr Names<Interlock, 3> kInterlockNames{
    {{"off", Interlock::off}, {"place", Interlock::place}, {"post", Interlock::post}}};
inline constexpr Names<Links, 2> kLinksNames{{{"allow", Links::allow}, {"avoid", Links::avoid}}};
inline constexpr Names<TakeOut, 3> kTakeOutNames{
    {{"smallest", TakeOut::smallest}, {"lightest", TakeOut::lightest}, {"thinnest", TakeOut::thinnest}}};
inline constexpr Names<Order, 5> kOrderNames{{{"size", Order::size},
                                              {"input", Order::input},
                                              {"random", Order::random},
                                              {"volume", Order::volume},
                                              {"mixed", Order::mixed}}};
inline constexpr Names<EngineKind, 4> kEngineNames{{{"auto", EngineKind::automatic},
                                                    {"cpu", EngineKind::cpu},
                                                    {"cuda", EngineKind::cuda},
                                                    {"reference", EngineKind::reference}}};
inline constexpr Names<HeightReference, 2> kHeightNames{
    {{"bottom", HeightReference::bottom}, {"top", HeightReference::top}}};
inline constexpr Names<Minimise, 2> kMinimiseNames{{{"none", Minimise::none}, {"box", Minimise::box}}};
inline constexpr Names<UnplacedReason, 5> kReasonNames{{{"tray_full", UnplacedReason::tray_full},
                                                        {"too_large", UnplacedReason::too_large},
                                                        {"interlocked", UnplacedReason::interlocked},
                                                        {"unusable", UnplacedReason::unusable},
                                                        {"stopped", UnplacedReason::stopped}}};

template <class Value, std::size_t N>
constexpr std::string_view name_of(const Names<Value, N>& names, Value value) {
    for (const auto& [name, named] : names) {
        if (named == value) return name;
    }
    return {};
}

template <class Value, std::size_t N>
constexpr std::optional<Value> value_of(const Names<Value, N>& names, std::string_view wanted) {
    for (const auto& [name, named] : names) {
        if (name == wanted) return named;
    }
    return std::nullopt;
}

}  // namespace spectralpack
