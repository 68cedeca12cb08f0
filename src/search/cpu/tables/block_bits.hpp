#pragma once
/// Positions along x as bits, and blocks of four of them as bits: 64 and 16 to a word of positions.

#include <cstdint>

namespace spectralpack {

/// Each of 16 bits four times: blocks as positions.
inline std::uint64_t widened(std::uint32_t blocks) {
    std::uint64_t bits = blocks & 0xFFFFu;
    bits = (bits | bits << 24) & 0x000000FF000000FFu;
    bits = (bits | bits << 12) & 0x000F000F000F000Fu;
    bits = (bits | bits << 6) & 0x0303030303030303u;
    bits = (bits | bits << 3) & 0x1111111111111111u;
    return bits * 15;
}

/// Every fourth bit, from the lowest on.
inline std::uint32_t every_fourth(std::uint64_t bits) {
    bits &= 0x1111111111111111u;
    bits = (bits | bits >> 3) & 0x0303030303030303u;
    bits = (bits | bits >> 6) & 0x000F000F000F000Fu;
    bits = (bits | bits >> 12) & 0x000000FF000000FFu;
    return static_cast<std::uint32_t>((bits | bits >> 24) & 0xFFFFu);
}

/// The lowest bit of each block: something in the block is set.
inline std::uint64_t any_of_block(std::uint64_t bits) {
    bits |= bits >> 1;
    bits |= bits >> 2;
    return bits & 0x1111111111111111u;
}

}  // namespace spectralpack
