#include "api/engine_factory.hpp"

#include "api/reference_engine.hpp"
#include "core/checked.hpp"
#include "core/zeroed.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/cpu/free/dilated_layers.hpp"
#include "search/cpu/scan/position_state.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// The tables of search/cpu: phi and its prefix sums along three axes, fine and pooled (16 bytes a voxel; in bytes they
/// take less); bit tables; a bit of the crowd tables for 64 of those. For ways out the fine voxels' rows dilated, of
/// one tray.
std::int64_t memory_of_cpu(const EngineNeed& need) {
    const std::int64_t voxels = checked_product({need.tray.x + 64, need.tray.y + 8, need.tray.z + 1});
    const BitLayout layout = bit_layout(need.tray, need.overhang, need.detail, need.gap_classes, true);
    const auto bits = static_cast<std::int64_t>(sizeof(BitLayout::Word)) * (layout.words() + layout.spare_words());
    std::int64_t bytes = bits / 64 + (need.ways.empty() ? 0 : DilatedLayers::most_bytes(need.ways));
    for (const std::int64_t array : {2 * voxels, 6 * voxels, 6 * voxels, 2 * voxels, bits}) {
        bytes += static_cast<std::int64_t>(zeroed_size(static_cast<std::size_t>(array)));
    }
    return bytes;
}

}  // namespace

EngineKind resolve_engine(EngineKind kind) {
    switch (kind) {
        case EngineKind::automatic:
        case EngineKind::cpu:
            return EngineKind::cpu;
        case EngineKind::cuda:
            throw UsageError("--engine cuda is not built yet");
        case EngineKind::reference:
            break;
    }
    if (!reference_engine()) {
        throw UsageError("this program has no --engine reference; spectralpack-reference has (docs/dependencies.md)");
    }
    return kind;
}

std::unique_ptr<PlacementSearch> make_engine(EngineKind kind, std::int64_t cache_bytes, const Workers& workers) {
    if (kind == EngineKind::reference) return reference_engine()->make(workers);
    CpuOptions options;
    options.cache_memory = cache_bytes;
    return make_cpu_search(options, workers);
}

MetricFields reference_fields(const Tray& tray, const Shape& shape, int index, const Workers& workers) {
    resolve_engine(EngineKind::reference);
    return reference_engine()->fields(tray, shape, index, workers);
}

std::int64_t engine_memory(EngineKind kind, const EngineNeed& need, const Workers& workers) {
    if (kind == EngineKind::reference) return reference_engine()->memory(need, workers);
    return memory_of_cpu(need) + part_memory(kind, need);
}

std::int64_t part_memory(EngineKind kind, const EngineNeed& need) {
    if (kind == EngineKind::reference) return 0;
    // Its positions, and lists of runs and look-ups, which follow its surface: on the benchmark's sets, at 1 and 2 mm,
    // they take 4 to 23 bytes for a voxel of the box's faces, with s = 2 3 to 12 for a fine one.
    const double lists = (16 + 8 * need.detail * need.detail) * need.surface;
    return static_cast<std::int64_t>(need.orientations) *
           (PositionState::bytes_for(need.tray, need.copies) + static_cast<std::int64_t>(lists));
}

}  // namespace spectralpack
