#include "api/reference_engine.hpp"
#include "search/reference/reference_search.hpp"

namespace spectralpack {
namespace {

std::unique_ptr<PlacementSearch> make(const Workers& workers) { return make_reference_search({}, workers); }

std::int64_t memory_of(const EngineNeed& need, const Workers& workers) {
    ReferenceMemory memory;
    memory.tray = need.tray;
    memory.overhang = {need.overhang, need.overhang, need.overhang};
    memory.gap_classes = need.gap_classes * part_count(need.detail);
    memory.lanes = workers.threads();
    return reference_memory(memory);
}

MetricFields fields_of(const Tray& tray, const Shape& shape, int index, const Workers& workers) {
    return make_reference_search({}, workers)->metric_fields(tray, shape, index);
}

}  // namespace

const ReferenceEngine* reference_engine() {
    static constexpr ReferenceEngine kEngine{make, memory_of, fields_of};
    return &kEngine;
}

}  // namespace spectralpack
