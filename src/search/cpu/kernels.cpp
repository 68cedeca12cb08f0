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

void AddRows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* HWY_RESTRICT b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = static_cast<std::uint16_t>(a[i] + b[i]);
    }
}

void MinRows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::min(a[i], b[i]);
    }
}

void MinRowsAbove(std::uint16_t* HWY_RESTRICT out, const std::uint16_t* HWY_RESTRICT from, std::uint16_t floor,
                  std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::min(out[i], static_cast<std::uint16_t>(from[i] - floor));
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

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(LowerRow);
HWY_EXPORT(LowerBytes);
HWY_EXPORT(AddRows);
HWY_EXPORT(MinRows);
HWY_EXPORT(MinRowsAbove);
HWY_EXPORT(AndRows);
HWY_EXPORT(MaxOfRow);

bool lower_row(std::uint16_t* row, const std::uint16_t* from, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(LowerRow)(row, from, count);
}

void lower_bytes(std::uint8_t* row, const std::uint8_t* from, std::uint8_t by, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(LowerBytes)(row, from, by, count);
}

void add_rows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(AddRows)(out, a, b, count);
}

void min_rows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(MinRows)(out, a, b, count);
}

void min_rows_above(std::uint16_t* out, const std::uint16_t* from, std::uint16_t floor, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(MinRowsAbove)(out, from, floor, count);
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
