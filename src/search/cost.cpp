#include "search/cost.hpp"

namespace spectralpack {

double height_penalty_at(const CostModel& model, int z, int reference_layers) {
    const double t = static_cast<double>(z) / static_cast<double>(reference_layers);
    return model.height_penalty * t * t * t;  // Equation (5)
}

Cost cost_of(const CostModel& model, int z, int layers, int reference_layers, std::int64_t rho) {
    if (model.height_at == HeightAt::top) return {static_cast<double>(z + layers), rho};
    return {static_cast<double>(rho) + height_penalty_at(model, z, reference_layers), 0};
}

}  // namespace spectralpack
