#include "search/cpu/kernels.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into vectors for each instruction set.

bool LowerRow(std::uint16_t* HWY_RESTRICT row, const std::uint16_t* HWY_RESTRICT from, std::size_t count) {
    std::uint16_t changed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto reach = static_cast<std::uint16_t>(from[i] + 1);
        const std::uint16_t lower = std::min(row[i], reach);
        changed = static_cast<std::uint16_t>(changed | (row[i] ^ lower));
        row[i] = lower;
    }
    return changed != 0;
}

void LowerBytes(std::uint8_t* HWY_RESTRICT row, const std::uint8_t* HWY_RESTRICT from, std::uint8_t by,
                std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        row[i] = std::min(row[i], static_cast<std::uint8_t>(from[i] + by));
    }
}

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

std::uint16_t MaxOfRow(const std::uint16_t* row, std::size_t count) {
    std::uint16_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        most = std::max(most, row[i]);
    }
    return most;
}

// Those that a compiler would not: short rows, lanes that change places.

namespace hn = hwy::HWY_NAMESPACE;

void AddBlocks(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t rows, std::size_t step,
               std::size_t b_step, std::size_t count) {
    const hn::ScalableTag<std::uint16_t> wide;
    const hn::CappedTag<std::uint16_t, 8> narrow;
    for (; rows > 0; --rows, out += step, a += step, b += b_step) {
        std::size_t i = 0;
        for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
            hn::StoreU(hn::Add(hn::LoadU(wide, a + i), hn::LoadU(wide, b + i)), wide, out + i);
        }
        for (; i + hn::Lanes(narrow) <= count; i += hn::Lanes(narrow)) {
            hn::StoreU(hn::Add(hn::LoadU(narrow, a + i), hn::LoadU(narrow, b + i)), narrow, out + i);
        }
        for (; i < count; ++i) {
            out[i] = static_cast<std::uint16_t>(a[i] + b[i]);
        }
    }
}

void DealLeastOfFour(std::uint16_t* HWY_RESTRICT out, std::size_t stride, const std::uint16_t* HWY_RESTRICT from,
                     std::uint16_t floor, std::uint16_t most, std::size_t count) {
    const hn::CappedTag<std::uint16_t, 8> d;
    const auto deal = [&](auto lanes, std::size_t i) {
        const auto put = [&](std::size_t k, auto value) {
            value = hn::Min(hn::SaturatedAdd(value, hn::Set(lanes, floor)), hn::Set(lanes, most));
            hn::StoreU(value, lanes, out + k * stride + i);
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

void PrefixSums(std::uint16_t* HWY_RESTRICT out, const std::uint16_t* HWY_RESTRICT from, std::size_t count) {
    std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
    // Within eight lanes by doubling, from eight to the next by the sum so far.
    const hn::FixedTag<std::uint16_t, 8> d;
    auto before = hn::Set(d, out[0]);
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        auto sums = hn::LoadU(d, from + i);
        sums = hn::Add(sums, hn::ShiftLeftLanes<1>(d, sums));
        sums = hn::Add(sums, hn::ShiftLeftLanes<2>(d, sums));
        sums = hn::Add(sums, hn::ShiftLeftLanes<4>(d, sums));
        hn::StoreU(hn::Add(sums, before), d, out + i + 1);
        before = hn::Add(before, hn::Broadcast<7>(sums));
    }
#endif
    for (; i < count; ++i) {
        out[i + 1] = static_cast<std::uint16_t>(out[i] + from[i]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(LowerRow);
HWY_EXPORT(LowerBytes);
HWY_EXPORT(AddBlocks);
HWY_EXPORT(MinRows);
HWY_EXPORT(MinOfFour);
HWY_EXPORT(DealLeastOfFour);
HWY_EXPORT(PrefixSums);
HWY_EXPORT(AndRows);
HWY_EXPORT(MaxOfRow);

bool lower_row(std::uint16_t* row, const std::uint16_t* from, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(LowerRow)(row, from, count);
}

void lower_bytes(std::uint8_t* row, const std::uint8_t* from, std::uint8_t by, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(LowerBytes)(row, from, by, count);
}

void add_blocks(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t rows, std::size_t step,
                std::size_t b_step, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(AddBlocks)(out, a, b, rows, step, b_step, count);
}

void min_rows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(MinRows)(out, a, b, count);
}

void min_of_four(std::uint16_t* out, const std::uint16_t* const (&rows)[4], std::uint16_t floor, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(MinOfFour)(out, rows, floor, count);
}

void deal_least_of_four(std::uint16_t* out, std::size_t stride, const std::uint16_t* from, std::uint16_t floor,
                        std::uint16_t most, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(DealLeastOfFour)(out, stride, from, floor, most, count);
}

void prefix_sums(std::uint16_t* out, const std::uint16_t* from, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(PrefixSums)(out, from, count);
}

void and_rows(std::uint64_t* out, const std::uint64_t* from, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(AndRows)(out, from, count);
}

std::uint16_t max_of_row(const std::uint16_t* row, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(MaxOfRow)(row, count);
}

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
