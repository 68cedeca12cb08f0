/// The inner loops of the search, once for each instruction set (Highway): included by a file
/// that <hwy/foreach_target.h> includes again and again. Exact integer arithmetic, so that every
/// instruction set gives the same answers.

#if defined(SPECTRALPACK_CPU_SCAN_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPECTRALPACK_CPU_SCAN_KERNELS_INL_H
#undef SPECTRALPACK_CPU_SCAN_KERNELS_INL_H
#else
#define SPECTRALPACK_CPU_SCAN_KERNELS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "search/cpu/scan/stretches.hpp"
#include "search/cpu/shapes/cells.hpp"
#include "search/cpu/shapes/loads.hpp"
#include "search/cpu/shapes/lookups.hpp"
#include "search/cpu/tuning.hpp"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Bit i: values[i] <= limit. i in [0, kStretch).
HWY_INLINE std::uint32_t AtMost(const std::uint32_t* values, std::uint32_t limit) {
    const hn::CappedTag<std::uint32_t, kStretch> d;
    const auto bound = hn::Set(d, limit);
    std::uint32_t above = 0;
    for (std::size_t i = 0; i < kStretch; i += hn::MaxLanes(d)) {
        std::uint8_t part[8] = {};
        hn::StoreMaskBits(d, hn::Gt(hn::LoadU(d, values + i), bound), part);
        above |= (static_cast<std::uint32_t>(part[0]) | static_cast<std::uint32_t>(part[1]) << 8) << i;
    }
    return ~above & 0xFFFFu;
}

/// Bit i: i is one of `lanes`, and cells do not show that rho is above `limit` in block i of those from `minima` on. i
/// in [0, 32). Where no bit is set, `bound` falls to what rho is at least in all of `lanes`: unless the solid's depths
/// alone are above the limit, cells are asked until that is above `stop_above`, which is not below the limit.
HWY_INLINE std::uint32_t WithinLimit(const std::uint16_t* minima, const CellList& list, std::uint32_t limit,
                                     std::uint32_t stop_above, std::uint32_t lanes, std::uint32_t& bound) {
    const auto least = static_cast<std::uint32_t>(std::min<std::int64_t>(list.least, kSumLimit));
    if (least > limit) {
        bound = std::min(bound, least);
        return 0;
    }
    const std::uint32_t slack = limit - least;
    // Cells come to less than 2^31 (list_cells), so lanes that are not wanted start above the slack and stay there.
    constexpr std::uint32_t kNotWanted = 0x80000000u;
    if (slack >= kNotWanted) return lanes;
    const std::uint32_t enough = std::min(stop_above - least, kNotWanted - 1);
    alignas(64) std::uint32_t start[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        start[i] = lanes >> i & 1 ? 0 : kNotWanted;
    }
    const hn::CappedTag<std::uint32_t, kLanes> d32;
    const hn::Rebind<std::uint16_t, decltype(d32)> d16;
    constexpr std::size_t kStep = hn::MaxLanes(d32);
    constexpr std::size_t kVectors = kLanes / kStep;
    hn::Vec<decltype(d32)> sums[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) {
        sums[v] = hn::LoadU(d32, start + v * kStep);
    }
    const auto most = hn::Set(d32, slack), far = hn::Set(d32, enough);
    for (std::size_t begin = 0; begin < list.cells.size();) {
        const std::size_t end = std::min(list.cells.size(), begin + tuning::kCellsPerLook);
        for (; begin < end; ++begin) {
            const SolidCell& cell = list.cells[begin];
            const auto drop = hn::Set(d16, cell.drop);
            const auto weight = hn::Set(d32, cell.weight);
            for (std::size_t v = 0; v < kVectors; ++v) {
                const auto value = hn::SaturatedSub(hn::LoadU(d16, minima + cell.offset + v * kStep), drop);
                sums[v] = hn::Add(sums[v], hn::Mul(hn::PromoteTo(d32, value), weight));
            }
        }
        auto done = hn::MaskFromVec(hn::Not(hn::Zero(d32)));
        for (std::size_t v = 0; v < kVectors; ++v) {
            done = hn::And(done, hn::Gt(sums[v], far));
        }
        if (hn::AllTrue(d32, done)) break;
    }
    std::uint32_t above = 0;
    for (std::size_t v = 0; v < kVectors; ++v) {
        std::uint8_t part[8] = {};
        hn::StoreMaskBits(d32, hn::Gt(sums[v], most), part);
        above |= (static_cast<std::uint32_t>(part[0]) | static_cast<std::uint32_t>(part[1]) << 8) << (v * kStep);
    }
    if (above == ~0u) {
        auto nearest = sums[0];
        for (std::size_t v = 1; v < kVectors; ++v) {
            nearest = hn::Min(nearest, sums[v]);
        }
        bound = std::min(bound, least + hn::GetLane(hn::MinOfLanes(d32, nearest)));
    }
    return ~above;
}

/// All lanes together.
template <class D>
HWY_INLINE std::uint64_t OrOfLanes(D d, hn::Vec<D> v) {
    if constexpr (hn::MaxLanes(d) == 1) {
        return hn::GetLane(v);
    } else {
        const hn::Half<D> half;
        return OrOfLanes(half, hn::Or(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
    }
}

/// Clears in the tile `live` what the look-ups of batches [begin, end) find to collide, until nothing is left: of each
/// look-up at offset o, bits (tile + o)[j] and up, shifted right by its group's shift, the bits that move in coming
/// from (tile + o + next)[j]. j in [0, kTileRows). So for kLayers tiles one above the other, `up` words disjoint, whose
/// live words lie kTileRows apart.
template <int kLayers>
HWY_INLINE void PruneTiles(const std::uint64_t* HWY_RESTRICT tile, std::ptrdiff_t next, std::ptrdiff_t up,
                           const LookupList& list, std::size_t begin, std::size_t end,
                           std::uint64_t* HWY_RESTRICT live) {
    const hn::CappedTag<std::uint64_t, kTileRows> d;
    constexpr std::size_t kStep = hn::MaxLanes(d);
    // One layer's rows all at once, however many vectors they take, so that each line is asked for once; of several
    // layers what the registers hold.
    constexpr std::size_t kAtOnce = kLayers == 1 ? kTileRows / kStep : 1;
    constexpr std::size_t kVectors = kLayers * kAtOnce;
    using V = hn::Vec<decltype(d)>;
    const LookupList::Batch* HWY_RESTRICT batches = list.batches.data();
    const LookupGroup* HWY_RESTRICT groups = list.groups.data();
    const std::int32_t* HWY_RESTRICT offsets = list.offsets.data();
    std::ptrdiff_t word[kVectors];  // of each vector, from the first one on
    for (std::size_t v = 0; v < kVectors; ++v) {
        word[v] = static_cast<std::ptrdiff_t>(v / kAtOnce) * up + static_cast<std::ptrdiff_t>(v % kAtOnce * kStep);
    }
    for (std::size_t j = 0; j < kTileRows; j += kStep * kAtOnce) {
        const auto row = [&](std::size_t v) { return live + v / kAtOnce * kTileRows + v % kAtOnce * kStep + j; };
        V left[kVectors];
        for (std::size_t v = 0; v < kVectors; ++v) {
            left[v] = hn::LoadU(d, row(v));
        }
        // Clears what a group finds in the words from `at` on alone, whose bits shifted() brings to their places.
        const auto look_up = [&](const LookupGroup& group, const std::uint64_t* at, const auto& shifted) {
            V words[kVectors];
            for (std::size_t v = 0; v < kVectors; ++v) {
                words[v] = hn::Zero(d);
            }
            for (std::int32_t i = group.begin; i < group.end; ++i) {
                for (std::size_t v = 0; v < kVectors; ++v) {
                    words[v] = hn::Or(words[v], hn::LoadU(d, at + offsets[i] + word[v]));
                }
            }
            for (std::size_t v = 0; v < kVectors; ++v) {
                left[v] = hn::AndNot(shifted(words[v]), left[v]);
            }
        };
        for (std::size_t b = begin; b < end; ++b) {
            V some = left[0];
            for (std::size_t v = 1; v < kVectors; ++v) {
                some = hn::Or(some, left[v]);
            }
            const std::uint64_t any = OrOfLanes(d, some);
            if (any == 0) break;
            const LookupGroup* HWY_RESTRICT group = groups + batches[b].begin;
            const LookupGroup* const last = groups + batches[b].end;
            // What is left is mostly a few bits close together, which one word of the two tells of.
            if (last[-1].shift <= static_cast<std::uint64_t>(std::countl_zero(any))) {
                for (; group != last; ++group) {
                    const V down = hn::Set(d, group->shift);
                    look_up(*group, tile + j, [&](V words) { return hn::Shr(words, down); });
                }
                continue;
            }
            if (group->shift >= 64 - static_cast<std::uint64_t>(std::countr_zero(any))) {
                for (; group != last; ++group) {
                    const V rest = hn::Set(d, 64 - group->shift);
                    look_up(*group, tile + next + j, [&](V words) { return hn::Shl(words, rest); });
                }
                continue;
            }
            for (; group != last; ++group) {
                if (group->shift == 0) {
                    look_up(*group, tile + j, [](V words) { return words; });
                    continue;
                }
                V low[kVectors], high[kVectors];
                for (std::size_t v = 0; v < kVectors; ++v) {
                    low[v] = hn::Zero(d);
                    high[v] = hn::Zero(d);
                }
                for (std::int32_t i = group->begin; i < group->end; ++i) {
                    const std::uint64_t* at = tile + j + offsets[i];
                    for (std::size_t v = 0; v < kVectors; ++v) {
                        low[v] = hn::Or(low[v], hn::LoadU(d, at + word[v]));
                        high[v] = hn::Or(high[v], hn::LoadU(d, at + word[v] + next));
                    }
                }
                const V down = hn::Set(d, group->shift);
                const V rest = hn::Sub(hn::Set(d, std::uint64_t{64}), down);
                for (std::size_t v = 0; v < kVectors; ++v) {
                    left[v] = hn::AndNot(hn::Or(hn::Shr(low[v], down), hn::Shl(high[v], rest)), left[v]);
                }
            }
        }
        for (std::size_t v = 0; v < kVectors; ++v) {
            hn::StoreU(left[v], d, row(v));
        }
    }
}

/// Of each of kCount vectors of kNumbers numbers the bits of its lanes, where lane k of vector w stands for bit
/// w / kPer * kPer * kNumbers + kPer * k + w % kPer.
template <std::size_t kPer, std::size_t kCount, std::size_t kNumbers>
struct LaneBits {
    alignas(64) std::uint32_t bits[kCount][kNumbers];
    constexpr LaneBits() : bits() {
        for (std::size_t w = 0; w < kCount; ++w) {
            for (std::size_t k = 0; k < kNumbers; ++k) {
                bits[w][k] = 1u << (w / kPer * kPer * kNumbers + kPer * k + w % kPer);
            }
        }
    }
};

/// Vector v of two stretches' elements, one after the other.
template <class D, class T = hn::TFromD<D> >
HWY_INLINE hn::Vec<D> LoadStretches(D d, const T* low, const T* high, std::size_t v) {
    constexpr std::size_t kStep = hn::MaxLanes(d);
    if constexpr (kStep > kStretch) {
        const hn::Half<D> half;
        return hn::Combine(d, hn::LoadU(half, high), hn::LoadU(half, low));
    } else {
        return hn::LoadU(d, (v * kStep < kStretch ? low : high) + v * kStep % kStretch);
    }
}

/// Of `lanes`, a set in [0, kLanes), i stands for `low` + i, from kStretch on for `high` + i - kStretch, and sums[i]
/// becomes `least`, what all loads come to at least, and what each load's difference of two elements, at `plus` and
/// `minus` from there, modulo what a T holds, is above the load's least, up to kSumLimit; for other i kSumLimit. Stops
/// after a batch once all lanes are above `limit`; sums are then lower bounds. kOfEach: a load may come to less than
/// its least and then counts as that; otherwise none does where the sum is to mean anything, which takes a step less
/// for each.
template <bool kOfEach, class T>
HWY_INLINE void SumLanes(const T* HWY_RESTRICT low, const T* HWY_RESTRICT high, const SumLoad* HWY_RESTRICT loads,
                         const SumBatch* HWY_RESTRICT batches, std::size_t batch_count, std::uint32_t limit,
                         std::uint32_t lanes, std::uint32_t least, std::uint32_t* HWY_RESTRICT sums) {
    // Sums stay below the lanes that they are of: a vector of 32 bits holds every second or fourth of a vector of T, so
    // that nothing moves from lane to lane before the end.
    const hn::CappedTag<T, kLanes> dt;
    const hn::Repartition<std::uint16_t, decltype(dt)> d16;
    const hn::Repartition<std::uint32_t, decltype(dt)> d32;
    constexpr bool kBytes = sizeof(T) == 1;
    constexpr std::size_t kStep = hn::MaxLanes(dt);
    constexpr std::size_t kVectors = kLanes / kStep;
    constexpr std::size_t kPer = sizeof(std::uint32_t) / sizeof(T);
    constexpr std::size_t kWide = kStep / kPer;
    using V16 = hn::Vec<decltype(d16)>;
    using V32 = hn::Vec<decltype(d32)>;
    static constexpr LaneBits<kPer, kVectors * kPer, kWide> kBits;

    const auto most = hn::Set(d32, kSumLimit);
    const auto bound = hn::Set(d32, limit);
    const auto lower_half = hn::Set(d32, 0xFFFFu);
    V32 wide[kVectors * kPer];
    for (std::size_t w = 0; w < kVectors * kPer; ++w) {
        const auto wanted = hn::TestBit(hn::Set(d32, lanes), hn::Load(d32, kBits.bits[w]));
        wide[w] = hn::IfThenElse(wanted, hn::Set(d32, least), most);
    }
    for (std::size_t b = 0; b < batch_count; ++b) {
        // Of bytes in pairs: first + 256 second, and second, both modulo 2^16, from which first follows.
        V16 pairs[kVectors], second[kVectors];
        const std::uint16_t start = kOfEach ? std::uint16_t{0} : static_cast<std::uint16_t>(-batches[b].least);
        for (std::size_t v = 0; v < kVectors; ++v) {
            pairs[v] = hn::Set(d16, static_cast<std::uint16_t>(kBytes ? 257 * start : start));
            second[v] = hn::Set(d16, start);
        }
        for (std::int32_t i = batches[b].begin; i < batches[b].end; ++i) {
            const std::ptrdiff_t plus = loads[i].plus, minus = loads[i].minus;
            const auto run_least = hn::Set(dt, static_cast<T>(loads[i].least));
            for (std::size_t v = 0; v < kVectors; ++v) {
                const auto run = hn::Sub(LoadStretches(dt, low + plus, high + plus, v),
                                         LoadStretches(dt, low + minus, high + minus, v));
                const auto above = hn::BitCast(d16, kOfEach ? hn::SaturatedSub(run, run_least) : run);
                pairs[v] = hn::Add(pairs[v], above);
                if constexpr (kBytes) second[v] = hn::Add(second[v], hn::ShiftRight<8>(above));
            }
        }
        auto done = hn::MaskFromVec(hn::Not(hn::Zero(d32)));
        const auto add = [&](std::size_t w, V32 sum) {
            wide[w] = hn::Min(most, hn::Add(wide[w], sum));
            done = hn::And(done, hn::Gt(wide[w], bound));
        };
        for (std::size_t v = 0; v < kVectors; ++v) {
            const V32 odd = hn::BitCast(d32, second[v]);
            const V32 even = hn::BitCast(d32, kBytes ? hn::Sub(pairs[v], hn::ShiftLeft<8>(second[v])) : pairs[v]);
            add(kPer * v, hn::And(even, lower_half));
            add(kPer * v + kPer / 2, hn::ShiftRight<16>(even));
            if constexpr (kBytes) {
                add(kPer * v + 1, hn::And(odd, lower_half));
                add(kPer * v + 3, hn::ShiftRight<16>(odd));
            }
        }
        if (hn::AllTrue(d32, done)) break;
    }
    for (std::size_t v = 0; v < kVectors; ++v) {
        if constexpr (kBytes) {
            hn::StoreInterleaved4(wide[4 * v], wide[4 * v + 1], wide[4 * v + 2], wide[4 * v + 3], d32,
                                  sums + v * kStep);
        } else {
            hn::StoreInterleaved2(wide[2 * v], wide[2 * v + 1], d32, sums + v * kStep);
        }
    }
}

/// SumLanes() of a list for all of some stretches, two at a time: calls each(stretch, its sums). from(stretch) is
/// the element of its table that the list's offsets count from.
template <bool kOfEach, class AnyStretch, class From, class Each>
void SumUp(const LoadList& list, std::span<const AnyStretch> stretches, const From& from, std::uint32_t stop_above,
           const Each& each) {
    alignas(64) std::uint32_t sums[kLanes];
    for (std::size_t i = 0; i < stretches.size(); i += 2) {
        const bool both = i + 1 < stretches.size();
        const AnyStretch& low = stretches[i];
        const AnyStretch& high = stretches[both ? i + 1 : i];
        SumLanes<kOfEach>(from(low), from(high), list.loads.data(), list.batches.data(), list.batches.size(),
                          stop_above, low.lanes | (both ? high.lanes << kStretch : 0), lane_limit(list.least), sums);
        each(low, sums);
        if (both) each(high, sums + kStretch);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#endif
