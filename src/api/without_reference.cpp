#include "api/reference_engine.hpp"

namespace spectralpack {

const ReferenceEngine* reference_engine() { return nullptr; }

}  // namespace spectralpack
