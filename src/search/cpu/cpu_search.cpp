#include "search/cpu/cpu_search.hpp"

#include <atomic>
#include <optional>
#include <vector>

#include "search/cpu/free_rows.hpp"
#include "search/cpu/orientation_search.hpp"

namespace spectralpack {
namespace {

constexpr int kLayersPerTask = 8;  // brick layers

class CpuSearch final : public PlacementSearch {
  public:
    CpuSearch(const CpuOptions& options, const Workers& workers)
        : workers_(workers), positions_(options.cache_memory) {}

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        if (stop.stopped()) return {std::nullopt, true};
        const bool covers = covers_solid(shape);
        tables_.follow(tray, overhang(shape, tray.detail()), covers && tray.detail() == 1, workers_);
        PositionCache::Entry& entry = positions_.at(shape, tray, tables_);
        SearchContext context{tables_, model, tray.reference_layers(), {}};

        // Runs and plans of every orientation that has candidates.
        const std::size_t count = shape.orientations.size();
        std::vector<OrientationRuns>& runs = entry.runs;
        std::vector<std::optional<OrientationTask>> searches(count);
        workers_.for_each(static_cast<std::int64_t>(count), [&](std::int64_t i) {
            const auto k = static_cast<std::size_t>(i);
            if (entry.states[k].count().empty()) return;
            const OrientedShape& oriented = shape.orientations[k];
            if (runs[k].of_class.empty()) {
                runs[k] = make_runs(oriented, tray.detail(), tray.detail() == 1 ? tables_.apart() : covers, tables_);
            }
            searches[k].emplace(make_task(context, entry.states[k], runs[k], static_cast<int>(i), oriented));
        });

        // Low layers of all orientations first: with a steep height penalty they rule out the rest.
        struct Task {
            OrientationTask* search;
            int begin, end;
        };
        std::vector<Task> tasks;
        for (int begin = 0; begin < tray.extent().z; begin += kLayersPerTask) {
            for (std::size_t i = 0; i < count; ++i) {
                const int layers = entry.states[i].bricks().z;
                if (searches[i] && begin < layers) {
                    tasks.push_back(
                        {&*searches[i], begin, std::min(layers, begin + kLayersPerTask)});
                }
            }
        }
        std::atomic<std::size_t> next{0};
        std::atomic<bool> stopped{false};
        workers_.for_each(workers_.threads(), [&](std::int64_t) {
            for (std::size_t i = next++; i < tasks.size(); i = next++) {
                if (stopped || stop.stopped()) {
                    stopped = true;
                    return;
                }
                search_layers(*tasks[i].search, tasks[i].begin, tasks[i].end);
            }
        });
        if (stopped) return {std::nullopt, true};

        const std::optional<Placed> best = context.incumbent.get();
        if (!best) return {};
        const auto winner = static_cast<std::size_t>(best->index);
        return {with_neighbours(*best, runs[winner].solid,
                                shape.orientations[winner].solid->extent().z, context),
                false};
    }

    FreePositions free_positions(const Tray& tray, const Shape& shape, int index,
                                 const FreeQuery& query) override {
        const BitGrid& solid = *shape.orientations[static_cast<std::size_t>(index)].solid;
        const FreeRows rows(tray.omega_move(query.without), solid, query.padding);
        FreePositions result{rows.origin(), BitGrid(rows.extent())};
        workers_.for_ranges(rows.extent().z, 4, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t z = begin; z < end; ++z) {
                for (int y = 0; y < rows.extent().y; ++y) {
                    rows.words(y, static_cast<int>(z), 0, result.free.words_per_row(), result.free.row(y, static_cast<int>(z)));
                }
            }
        });
        return result;
    }

    std::unique_ptr<FreeRowReader> free_rows(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                             const FreeQuery& query) override {
        return std::make_unique<FreeRows>(tray.omega_move(query.without), *solid, query.padding);
    }

    const char* name() const override { return "cpu"; }
    std::int64_t memory() const override { return tables_.bytes() + positions_.bytes(); }

  private:
    BestPlacement with_neighbours(const Placed& best, const Runs& solid, int layers,
                                  const SearchContext& context) const {
        BestPlacement result{best.index, best.position, best.proximity, best.cost, {}};
        for (int i = 0; i < 6; ++i) {
            VoxelIndex q = best.position;
            q[i / 2] += i % 2 == 0 ? -1 : 1;
            result.neighbours[static_cast<std::size_t>(i)] =
                cost_of(context.model, q.z, layers, context.reference_layers,
                        proximity_at(tables_, solid, q));
        }
        return result;
    }

    Workers workers_;
    TrayTables tables_;
    PositionCache positions_;
};

}  // namespace

std::unique_ptr<PlacementSearch> make_cpu_search(const CpuOptions& options,
                                                 const Workers& workers) {
    return std::make_unique<CpuSearch>(options, workers);
}

}  // namespace spectralpack
