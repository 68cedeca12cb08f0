#include "search/cpu/cpu_search.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "core/heap.hpp"
#include "search/cpu/free/free_positions.hpp"
#include "search/cpu/scan/orientation_search.hpp"
#include "search/cpu/scan/proximity.hpp"
#include "search/cpu/shape_cache.hpp"
#include "search/cpu/shapes/shape_runs.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

class CpuSearch final : public PlacementSearch {
  public:
    CpuSearch(const CpuOptions& options, const Workers& workers)
        : options_(options),
          workers_(workers),
          tables_(options.large_from, options.bytes),
          shapes_(options.cache_memory) {}

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        if (stop.stopped()) return {std::nullopt, true};
        free_.drop_gone();
        const int margin = overhang(shape, tray.detail());
        tables_.follow(tray, margin, workers_);
        ShapeCache::Entry& known = shapes_.at(shape, tray, tables_, model, workers_);
        const std::vector<bool> open = open_orientations(shape, margin, known.states);
        make_missing_runs(shape, tray.detail(), open, tables_, workers_, known.runs);
        shapes_.make_lists(known, open, tables_, workers_);

        SearchContext context{tables_, model, tray.reference_layers(), nullptr, {}};
        if (tables_.in_bytes() && have_few(known.runs)) {
            tables_.follow_quads(workers_);
            context.quads = &tables_.quads();
        }
        std::vector<OrientationTask> searches = searches_of(shape, open, known, context);
        offer(known.seeds, searches);
        if (!search_all(searches, context, stop)) return {std::nullopt, true};
        if (!shape.is_once()) known.seeds = seeds_after(context.incumbent, known.seeds);
        const std::optional<ScoredPosition> best = context.incumbent.get();
        if (!best) return {};
        const auto winner = static_cast<std::size_t>(best->index);
        return {BestPlacement{
                    best->index, best->position, best->proximity, best->cost,
                    neighbours_of(best->position, known.runs[winner].solid, shape.orientations[winner].solid.extent().z,
                                  tables_, model, tray.reference_layers())},
                false};
    }

    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return free_.all(tray, shape.orientations[static_cast<std::size_t>(index)].solid.share(), query);
    }
    std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                               const FreeQuery& query) override {
        return free_.tiles(tray, std::move(solid), query);
    }

    const char* name() const override { return "cpu"; }
    std::int64_t memory() const override { return tables_.bytes() + shapes_.bytes() + free_.bytes(); }
    void forget() override {
        tables_ = TrayTables(options_.large_from, options_.bytes);
        shapes_ = ShapeCache(options_.cache_memory);
        free_.forget();
        give_back_freed();
    }

  private:
    /// True when quads are worth asking.
    static bool have_few(const std::vector<OrientationRuns>& runs) {
        return std::ranges::all_of(runs,
                                   [](const OrientationRuns& of) { return of.solid.runs.size() <= tuning::kFewRuns; });
    }

    /// A task for each open orientation.
    static std::vector<OrientationTask> searches_of(const Shape& shape, const std::vector<bool>& open,
                                                    ShapeCache::Entry& known, SearchContext& context) {
        std::vector<OrientationTask> searches;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (!open[i]) continue;
            searches.push_back({.context = context,
                                .state = known.states[i],
                                .runs = known.runs[i],
                                .lists = known.lists[i],
                                .index = static_cast<int>(i),
                                .layers = shape.orientations[i].solid.extent().z,
                                .for_copy = known.known,
                                .admits = shape.admits ? &shape.admits : nullptr});
        }
        return searches;
    }

    /// Offers the seeds that are still free, so that there is something to beat from the start.
    static void offer(const std::vector<ScoredPosition>& seeds, std::vector<OrientationTask>& searches) {
        for (const ScoredPosition& seed : seeds) {
            const auto search = std::ranges::find(searches, seed.index, &OrientationTask::index);
            if (search != searches.end()) search_position(*search, seed.position);
        }
    }

    /// Searches brick layer after brick layer of all orientations, as far up as the answer can lie: with a steep height
    /// penalty low layers rule out the rest, for which the tables need not follow the tray. False: stopped.
    bool search_all(std::vector<OrientationTask>& searches, const SearchContext& context, const StopToken& stop) {
        std::vector<int> searched(searches.size(), 0);  // brick layers
        for (;;) {
            const std::vector<int> before = searched;
            for (std::size_t i = 0; i < searches.size(); ++i) {
                searched[i] = std::max(searched[i], layers_below(tables_.top(), searches[i]));
            }
            if (!search_between(searches, before, searched, stop)) return false;
            int top = 0;
            for (std::size_t i = 0; i < searches.size(); ++i) {
                top = std::max(top, top_for(searches[i], searched[i], context));
            }
            if (top == 0) return true;
            tables_.raise(top, workers_);
        }
    }

    /// How many of the orientation's brick layers ask nothing of sums above layer `top`.
    int layers_below(int top, const OrientationTask& search) const {
        const int bricks = search.state.bricks().z;
        if (top >= tables_.phi().extent().z) return bricks;
        return std::clamp((top - search.layers + 1) / kBrickZ, 0, bricks);
    }

    /// The top of the sums that the answer can take, if it lies in the orientation's brick layers from `searched` on; 0
    /// if it cannot.
    int top_for(const OrientationTask& search, int searched, const SearchContext& context) const {
        const int count = search.state.count().z;
        const std::optional<ScoredPosition> best = context.incumbent.get();
        if (kBrickZ * searched >= count) return 0;
        if (!best) return std::max(2 * tables_.top(), search.layers + kBrickZ - 1);
        // The cost grows with height.
        int below = kBrickZ * searched, above = count;
        const auto can_win = [&](int z) {
            return proximity_limit(context.model, z, search.layers, context.reference_layers, best, search.index) >= 0;
        };
        if (!can_win(below)) return 0;
        while (above - below > 1) {
            const int middle = (below + above) / 2;
            (can_win(middle) ? below : above) = middle;
        }
        return kBrickZ * (below / kBrickZ + 1) - 1 + search.layers;
    }

    /// True where the height decides, so that what is found in low layers rules out those above: over these brick
    /// layers the cost rises by more than 1 for each voxel of the solid, about the least that rho comes to.
    static bool is_steep(const OrientationTask& search, int begin, int end) {
        const SearchContext& context = search.context;
        if (context.model.height_at == HeightAt::top) return true;
        const auto height = [&](int layer) {
            return height_penalty_at(context.model, kBrickZ * layer, context.reference_layers);
        };
        return height(end) - height(begin) > static_cast<double>(search.runs.solid.voxels);
    }

    /// The brick layers from `begin` to `end` of each orientation. False: stopped.
    bool search_between(std::vector<OrientationTask>& searches, const std::vector<int>& begin,
                        const std::vector<int>& end, const StopToken& stop) const {
        struct Task {
            OrientationTask* search;
            int begin, end;
        };
        std::vector<std::size_t> order;
        bool in_order = tables_.large();  // where a range of a thread's own is far more than its cache holds
        for (std::size_t i = 0; i < searches.size(); ++i) {
            if (begin[i] >= end[i]) continue;
            order.push_back(i);
            in_order = in_order || is_steep(searches[i], begin[i], end[i]);
        }
        // Those that read the same sums one after the other.
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return searches[i].runs.solid.axis; });
        std::vector<Task> tasks;
        const int most = searches.empty() ? 0 : *std::ranges::max_element(end);
        const int layers = in_order ? tuning::kLayersPerTaskInOrder : tuning::kLayersPerTask;
        for (int first = 0; first < most; first += layers) {
            for (const std::size_t i : order) {
                const int from = std::max(begin[i], first), to = std::min(end[i], first + layers);
                if (from < to) tasks.push_back({&searches[i], from, to});
            }
        }
        std::atomic<bool> stopped{false};
        const auto search = [&](std::int64_t i) {
            if (stopped || stop.stopped()) {
                stopped = true;
                return;
            }
            const Task& task = tasks[static_cast<std::size_t>(i)];
            search_layers(*task.search, task.begin, task.end);
        };
        if (in_order) {
            workers_.for_each_in_order(std::ssize(tasks), search);
        } else {
            workers_.for_each_apart(std::ssize(tasks), search);
        }
        return !stopped;
    }

    CpuOptions options_;
    Workers workers_;
    TrayTables tables_;
    ShapeCache shapes_;
    FreePositionSearch free_;
};

}  // namespace

std::unique_ptr<PlacementSearch> make_cpu_search(const CpuOptions& options, const Workers& workers) {
    return std::make_unique<CpuSearch>(options, workers);
}

}  // namespace spectralpack
