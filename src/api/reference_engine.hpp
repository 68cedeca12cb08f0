#pragma once
/// The reference engine, which a program has or has not: it needs FFTW, whose licence (GPL) then holds for the program.
/// The definition of reference_engine() that is linked decides (with_reference.cpp, without_reference.cpp), so that
/// both kinds of program share all other code.

#include <cstdint>
#include <memory>

#include "api/engine_factory.hpp"

namespace spectralpack {

struct ReferenceEngine {
    std::unique_ptr<PlacementSearch> (*make)(const Workers& workers);
    /// As engine_memory().
    std::int64_t (*memory)(const EngineNeed& need, const Workers& workers);
    /// As reference_fields().
    MetricFields (*fields)(const Tray& tray, const Shape& shape, int index, const Workers& workers);
};

/// Null where the program has none.
const ReferenceEngine* reference_engine();

}  // namespace spectralpack
