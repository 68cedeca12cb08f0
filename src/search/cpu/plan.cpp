#include "search/cpu/plan.hpp"

#include <algorithm>

namespace spectralpack {

OrientationPlan make_plan(const OrientationRuns& runs, const TrayTables& tables) {
    OrientationPlan plan;
    const std::vector<std::uint32_t> order = order_of_loads(runs.solid);
    tables.visit_sums([&]<class T>(const Sums<T>& sums) {
        constexpr int kRange = SumTables<T>::kRange, kMostPooled = SumTables<T>::kMostPooled;
        const int most = tables.phi().most();
        const int most_pooled = SumTables<T>::kBytes || tables.apart() ? kMostPooled : most;
        plan.fine = plan_sum(runs, order, sums.exact, kRange, std::max(most, most_pooled));
        plan.coarse = plan_sum(runs, order, sums.coarse, kRange, most_pooled);
    });
    plan.collision = plan_collision(runs, tables, plan.coarse.loads.size());
    return plan;
}

std::int64_t bytes_of(const OrientationPlan& plan) {
    return bytes_of(plan.collision) + bytes_of(plan.fine) + bytes_of(plan.coarse);
}

}  // namespace spectralpack
