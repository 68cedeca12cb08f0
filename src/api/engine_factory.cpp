#include "api/engine_factory.hpp"

#include "core/error.hpp"
#include "search/cpu/cpu_search.hpp"
#ifdef SPECTRALPACK_HAS_REFERENCE
#include "search/reference/reference_search.hpp"
#endif

namespace spectralpack {
namespace {

#ifdef SPECTRALPACK_HAS_REFERENCE
std::unique_ptr<PlacementSearch> make_reference(const Workers& workers) {
    return make_reference_search({}, workers);
}

std::int64_t memory_of_reference(const EngineNeed& need, const Workers& workers) {
    ReferenceMemory memory;
    memory.tray = need.tray;
    memory.overhang = {need.overhang, need.overhang, need.overhang};
    memory.gap_classes = need.gap_classes;
    memory.lanes = workers.threads();
    return reference_memory(memory);
}

constexpr bool kHasReference = true;
#else
std::unique_ptr<PlacementSearch> make_reference(const Workers&) { return nullptr; }
std::int64_t memory_of_reference(const EngineNeed&, const Workers&) { return 0; }
constexpr bool kHasReference = false;
#endif

}  // namespace

EngineKind resolve_engine(EngineKind kind) {
    switch (kind) {
        case EngineKind::automatic:
        case EngineKind::cpu: return EngineKind::cpu;
        case EngineKind::cuda: throw UsageError("the cuda engine is not built yet");
        case EngineKind::reference: break;
    }
    if (!kHasReference) {
        throw UsageError("this build has no reference engine (it was made with SPECTRALPACK_REFERENCE=OFF)");
    }
    return kind;
}

std::unique_ptr<PlacementSearch> make_engine(EngineKind kind, std::int64_t cache_bytes,
                                             const Workers& workers) {
    if (kind == EngineKind::reference) return make_reference(workers);
    CpuOptions options;
    options.cache_bytes = cache_bytes;
    return make_cpu_search(options, workers);
}

std::int64_t engine_memory(EngineKind kind, const EngineNeed& need, const Workers& workers) {
    return kind == EngineKind::reference ? memory_of_reference(need, workers)
                                         : cpu_memory(need.tray, need.gap_classes, workers.threads());
}

const char* engine_name(EngineKind kind) {
    switch (kind) {
        case EngineKind::automatic: return "auto";
        case EngineKind::cpu: return "cpu";
        case EngineKind::cuda: return "cuda";
        case EngineKind::reference: return "reference";
    }
    return "";
}

}  // namespace spectralpack
