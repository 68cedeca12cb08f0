#include "search/cpu/shapes/orientation_lists.hpp"

#include <algorithm>

namespace spectralpack {

OrientationLists lists_of(const OrientationRuns& runs, const TrayTables& tables) {
    OrientationLists lists;
    const std::vector<std::uint32_t> order = order_of_loads(runs.solid);
    tables.visit_sums([&]<class T>(const Sums<T>& sums) {
        constexpr int kRange = SumTables<T>::kRange, kMostPooled = SumTables<T>::kMostPooled;
        const int most = tables.phi_bound();
        const int most_pooled = SumTables<T>::kBytes || tables.disjoint() ? kMostPooled : most;
        lists.exact = list_loads(runs, order, sums.exact, kRange, std::max(most, most_pooled));
        lists.coarse = list_loads(runs, order, sums.coarse, kRange, most_pooled);
    });
    lists.lookups = list_lookups(runs, tables, lists.coarse.loads.size());
    return lists;
}

std::int64_t bytes_of(const OrientationLists& lists) {
    return bytes_of(lists.lookups) + bytes_of(lists.exact) + bytes_of(lists.coarse);
}

}  // namespace spectralpack
