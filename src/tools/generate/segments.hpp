#pragma once
/// Cutting a body into pieces.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

struct SegmentRules {
    std::optional<Vec3> room = {};  ///< mm; every piece fits into a box of that size, its sides turned as need be
    int pieces = 1;                 ///< at least
    std::uint64_t seed = 0;         ///< of what chance decides where more pieces are wanted than the room demands
};

/// The pieces of a closed mesh, each closed and in its place; together they are the whole. Where it does not fit the
/// room it is cut along the axes, as seldom as that goes; then the largest piece is cut across its longest extent,
/// somewhat aslant, until there are enough. A cut may leave more than two pieces. Planes keep clear of vertices and,
/// where they can, of places where crumbs would be left. Throws UsageError where more than kMostSegments would be left.
std::vector<Mesh> cut_into_segments(const Mesh& whole, const SegmentRules& rules);

/// What pieces of the set `segments` are named by.
inline constexpr const char *kBunny = "bunny", *kMolecule = "molecule";

inline constexpr int kMostSegments = 1000;

/// "bunny-01", from 1.
std::string segment_name(const std::string& whole, std::size_t number);

}  // namespace spectralpack::tools
