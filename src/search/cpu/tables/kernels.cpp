#include "search/cpu/tables/kernels.hpp"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/tables/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

RowChange LowerRow(std::uint16_t* HWY_RESTRICT row, const std::uint16_t* HWY_RESTRICT from, std::size_t count) {
    RowChange changed;
    const auto note = [&](std::size_t begin, std::size_t end) {
        if (changed.end == 0) changed.begin = begin;
        changed.end = end;
    };
    const hn::ScalableTag<std::uint16_t> d;
    const auto one = hn::Set(d, std::uint16_t{1});
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto before = hn::LoadU(d, row + i);
        const auto after = hn::Min(before, hn::Add(hn::LoadU(d, from + i), one));
        const auto lowered = hn::Ne(before, after);
        if (hn::AllFalse(d, lowered)) continue;
        hn::StoreU(after, d, row + i);
        std::uint8_t bytes[sizeof(std::uint64_t)] = {};
        hn::StoreMaskBits(d, lowered, bytes);
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < sizeof(bits); ++k) {
            bits |= std::uint64_t{bytes[k]} << (8 * k);
        }
        note(i + static_cast<std::size_t>(std::countr_zero(bits)), i + static_cast<std::size_t>(std::bit_width(bits)));
    }
    for (; i < count; ++i) {
        const auto reach = static_cast<std::uint16_t>(from[i] + 1);
        if (reach >= row[i]) continue;
        row[i] = reach;
        note(i, i + 1);
    }
    return changed;
}

// Plain loops, which the compiler turns into vectors for each instruction set.

void MinRows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::min(a[i], b[i]);
    }
}

void MinOfFour(std::uint16_t* HWY_RESTRICT out, const std::uint16_t* const (&rows)[4], std::uint16_t floor,
               std::size_t count) {
    const std::uint16_t *HWY_RESTRICT a = rows[0], *HWY_RESTRICT b = rows[1], *HWY_RESTRICT c = rows[2],
                                      *HWY_RESTRICT d = rows[3];
    const auto above = [floor](std::uint16_t value) { return static_cast<std::uint16_t>(value - floor); };
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::min(std::min(above(a[i]), above(b[i])), std::min(above(c[i]), above(d[i])));
    }
}

void AndRows(std::uint64_t* HWY_RESTRICT out, const std::uint64_t* HWY_RESTRICT from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] &= from[i];
    }
}

void OrRows(std::uint64_t* HWY_RESTRICT out, const std::uint64_t* a, const std::uint64_t* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = a[i] | b[i];
    }
}

void OrMovedDown(std::uint64_t* HWY_RESTRICT out, const std::uint64_t* a, const std::uint64_t* low,
                 const std::uint64_t* high, int by, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = a[i] | low[i] >> by | high[i] << (64 - by);
    }
}

std::uint16_t MaxOfRow(const std::uint16_t* row, std::size_t count) {
    std::uint16_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        most = std::max(most, row[i]);
    }
    return most;
}

// Those that a compiler would not: short rows, lanes that change places.

template <bool kAdd, class T>
void CombineRows(T* out, const T* a, const T* b, std::size_t rows, std::ptrdiff_t step, std::ptrdiff_t b_step,
                 std::size_t count) {
    const hn::ScalableTag<T> wide;
    const hn::CappedTag<T, 16 / sizeof(T)> narrow;
    const auto combine = [&](auto d, std::size_t i) {
        const auto left = hn::LoadU(d, a + i), right = hn::LoadU(d, b + i);
        hn::StoreU(kAdd ? hn::Add(left, right) : hn::Sub(left, right), d, out + i);
    };
    for (; rows > 0; --rows, out += step, a += step, b += b_step) {
        std::size_t i = 0;
        for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
            combine(wide, i);
        }
        for (; i + hn::Lanes(narrow) <= count; i += hn::Lanes(narrow)) {
            combine(narrow, i);
        }
        if (i < count && count >= hn::Lanes(narrow)) {
            combine(narrow, count - hn::Lanes(narrow));  // some of them once more
            continue;
        }
        for (; i < count; ++i) {
            combine(hn::CappedTag<T, 1>(), i);
        }
    }
}

/// Lanes of 16 bits from and to elements of 16 bits or of the lower eight of them.
template <class D>
HWY_INLINE hn::Vec<D> LoadLanes(D d, const std::uint16_t* from) {
    return hn::LoadU(d, from);
}
template <class D>
HWY_INLINE void StoreLanes(D d, hn::Vec<D> v, std::uint16_t* to) {
    hn::StoreU(v, d, to);
}
template <class D>
HWY_INLINE hn::Vec<D> LoadLanes(D d, const std::uint8_t* from) {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), from));
}
template <class D>
HWY_INLINE void StoreLanes(D d, hn::Vec<D> v, std::uint8_t* to) {
    const hn::Rebind<std::uint8_t, D> bytes;
    const hn::RebindToSigned<D> as_signed;
    hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(as_signed, hn::And(v, hn::Set(d, std::uint16_t{255})))), bytes, to);
}

template <class T>
void RaiseRow(T* HWY_RESTRICT out, const std::uint16_t* HWY_RESTRICT from, std::uint16_t floor, std::uint16_t most,
              std::size_t count) {
    const auto cap = static_cast<std::uint16_t>(most - floor);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = static_cast<T>(std::min(from[i], cap) + floor);
    }
}

template <class T>
void DealLeastOfFour(T* HWY_RESTRICT out, std::size_t stride, const std::uint16_t* HWY_RESTRICT from,
                     std::uint16_t floor, std::uint16_t most, std::size_t count) {
    const hn::CappedTag<std::uint16_t, 8> d;
    const auto deal = [&](auto lanes, std::size_t i) {
        const auto put = [&](std::size_t k, auto value) {
            value = hn::Min(hn::SaturatedAdd(value, hn::Set(lanes, floor)), hn::Set(lanes, most));
            StoreLanes(lanes, value, out + k * stride + i);
        };
        // v of the four of i, w of those after them.
        hn::Vec<decltype(lanes)> v0, v1, v2, v3, w0, w1, w2, w3;
        hn::LoadInterleaved4(lanes, from + 4 * i, v0, v1, v2, v3);
        hn::LoadInterleaved4(lanes, from + 4 * i + 4, w0, w1, w2, w3);
        const auto last = hn::Min(v2, v3), next = hn::Min(w0, w1);
        put(0, hn::Min(hn::Min(v0, v1), last));
        put(1, hn::Min(hn::Min(v1, last), w0));
        put(2, hn::Min(last, next));
        put(3, hn::Min(hn::Min(v3, next), w2));
    };
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        deal(d, i);
    }
    for (; i < count; ++i) {
        deal(hn::CappedTag<std::uint16_t, 1>(), i);
    }
}

/// Lane i: the sum of lanes 0 to i, by doubling.
template <class D>
HWY_INLINE hn::Vec<D> SumsOfEight(D d, hn::Vec<D> v) {
    v = hn::Add(v, hn::ShiftLeftLanes<1>(d, v));
    v = hn::Add(v, hn::ShiftLeftLanes<2>(d, v));
    return hn::Add(v, hn::ShiftLeftLanes<4>(d, v));
}

template <class T>
void PrefixSums(T* HWY_RESTRICT out, const T* HWY_RESTRICT from, std::size_t count) {
    std::size_t i = 0;
    const hn::FixedTag<std::uint16_t, 8> d;
    auto before = hn::Set(d, std::uint16_t{out[0]});
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto sums = SumsOfEight(d, LoadLanes(d, from + i));
        StoreLanes(d, hn::Add(sums, before), out + i + 1);
        before = hn::Add(before, hn::Broadcast<7>(sums));
    }
    for (; i < count; ++i) {
        out[i + 1] = static_cast<T>(out[i] + from[i]);
    }
}

template <class T>
T PrefixSumsDealt(T* HWY_RESTRICT out, const T* HWY_RESTRICT from, std::size_t stride, std::size_t count) {
    std::size_t i = 0;
    T sum = out[0];
    const hn::FixedTag<std::uint16_t, 8> d;
    auto before = hn::Set(d, std::uint16_t{sum});
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto v0 = LoadLanes(d, from + i), v1 = LoadLanes(d, from + stride + i),
                   v2 = LoadLanes(d, from + 2 * stride + i), v3 = LoadLanes(d, from + 3 * stride + i);
        const auto four = hn::Add(hn::Add(v0, v1), hn::Add(v2, v3));
        const auto sums = SumsOfEight(d, four);
        auto at = hn::Add(before, hn::Sub(sums, four));
        StoreLanes(d, at, out + i);
        at = hn::Add(at, v0);
        StoreLanes(d, at, out + stride + i);
        at = hn::Add(at, v1);
        StoreLanes(d, at, out + 2 * stride + i);
        StoreLanes(d, hn::Add(at, v2), out + 3 * stride + i);
        before = hn::Add(before, hn::Broadcast<7>(sums));
    }
    sum = static_cast<T>(hn::GetLane(before));
    for (; i < count; ++i) {
        for (std::size_t at = i; at < i + 4 * stride; at += stride) {
            out[at] = sum;
            sum = static_cast<T>(sum + from[at]);
        }
    }
    return sum;
}

template <class T>
constexpr SumKernels<T> SumKernelsOf() {
    return {CombineRows<true, T>, CombineRows<false, T>, RaiseRow<T>,
            DealLeastOfFour<T>,   PrefixSums<T>,         PrefixSumsDealt<T>};
}

const Kernels& AllKernels() {
    static constexpr Kernels kAll{LowerRow,
                                  MinRows,
                                  MinOfFour,
                                  MaxOfRow,
                                  AndRows,
                                  OrRows,
                                  OrMovedDown,
                                  SumKernelsOf<std::uint16_t>(),
                                  SumKernelsOf<std::uint8_t>()};
    return kAll;
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(AllKernels);

const Kernels& kernels() { return HWY_DYNAMIC_DISPATCH(AllKernels)(); }

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        names.emplace_back(hwy::TargetName(target));
    }
    return names;
}

void use_instruction_set(const std::string& name) {
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name == hwy::TargetName(target)) hwy::SetSupportedTargetsForTest(target);
    }
    hwy::GetChosenTarget().DeInit();  // the next call chooses anew
}

}  // namespace spectralpack
#endif
