#pragma once
/// The fast exact engine: the same answers as the definition in search/placement_search.hpp,
/// without transforms. Collisions by bits, rho by prefix sums, positions ruled out by bounds
/// (docs/algorithm/fast-engine.md tells why each bound is one). Integers throughout, so the answers do not
/// depend on threads, instruction set or memory.

#include <cstdint>
#include <memory>

#include "core/parallel.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

struct CpuOptions {
    /// Bytes for what is remembered of shapes between searches, so that further copies are cheap.
    /// What the tray itself takes comes on top.
    std::int64_t cache_memory = std::int64_t{1} << 28;
    /// From how many voxels on a tray is large: crowd tables are kept of it, solids are cut into small cells too,
    /// and threads take its layers in order.
    /// In smaller ones either takes as much time as it spares.
    std::int64_t large_from = 4'000'000;
    /// Sums are kept in bytes as soon as phi is small everywhere; else always in 16 bits.
    bool bytes = true;
};

/// What best_placement() keeps follows one tray at a time: alternating between trays costs a fresh
/// start each time.
std::unique_ptr<PlacementSearch> make_cpu_search(const CpuOptions& options, const Workers& workers);

}  // namespace spectralpack
