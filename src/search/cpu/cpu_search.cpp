#include "search/cpu/cpu_search.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/heap.hpp"
#include "search/cpu/free_tiles.hpp"
#include "search/cpu/orientation_search.hpp"

namespace spectralpack {
namespace {

/// Quads are asked about solids of that many runs at most. With more of them a sum is what takes the time, and a bound
/// takes more loads than rho itself does to pass the limit.
constexpr std::size_t kFewRuns = 128;
// Brick layers: what tables hold of few stays in the caches for all orientations. Fewer where tasks begun later may be
// spared.
constexpr int kLayersPerTask = 4, kLayersPerTaskInOrder = 2;

/// Around the candidates of orientation `index` that shape.only_near speaks of.
std::vector<VoxelBox> candidates_near(const Shape& shape, std::size_t index, int detail) {
    const Extent& a = shape.orientations[index].solid.extent();
    const int beyond = overhang(shape, detail);
    std::vector<VoxelBox> candidates;
    for (const VoxelBox& box : shape.only_near) {
        candidates.push_back({box.lo - VoxelIndex{a.x - 1 + beyond, a.y - 1 + beyond, a.z - 1 + beyond},
                              box.hi + VoxelIndex{beyond, beyond, beyond}});
    }
    return candidates;
}

class CpuSearch final : public PlacementSearch {
  public:
    CpuSearch(const CpuOptions& options, const Workers& workers)
        : options_(options),
          workers_(workers),
          tables_(options.large_from, options.bytes),
          positions_(options.cache_memory) {}

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        if (stop.stopped()) return {std::nullopt, true};
        if (dilated_ && dilated_->tray_is_gone()) dilated_ = nullptr;
        tables_.follow(tray, overhang(shape, tray.detail()), workers_);
        PositionCache::Entry& entry = positions_.at(shape, tray, tables_, model, workers_);
        SearchContext context{tables_, model, tray.reference_layers(), nullptr, {}};
        const std::vector<bool> open = open_orientations(shape, tray, entry);
        make_runs_of(shape, tray.detail(), open, entry.runs);
        const bool by_quads = tables_.narrow() && have_few(entry.runs);
        std::vector<OrientationTask> searches;
        workers_.for_each(2, [&](std::int64_t i) {
            if (i == 0) searches = plan_searches(shape, open, entry, context);
            if (i == 1 && by_quads) tables_.follow_quads(workers_);
        });
        if (by_quads) context.quads = &tables_.quads();
        sow(entry.seeds, searches);
        if (!search_all(searches, context, stop)) return {std::nullopt, true};

        const std::optional<Placed> best = context.incumbent.get();
        if (!shape.is_once()) entry.seeds = seeds_after(context.incumbent, entry.seeds);
        if (!best) return {};
        const auto winner = static_cast<std::size_t>(best->index);
        return {with_neighbours(*best, entry.runs[winner].solid, shape.orientations[winner].solid.extent().z, context),
                false};
    }

    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        FreeTiles tiles(tray, dilated(tray), query, shape.orientations[static_cast<std::size_t>(index)].solid.share());
        FreePositions result{tiles.origin(), BitGrid(tiles.extent())};
        const Extent& e = tiles.extent();
        FreeTiles::Rows all;
        all.fill(~std::uint64_t{0});
        for (int z = 0; z < e.z; ++z) {
            for (int y = 0; y < e.y; y += FreeTiles::kRows) {
                for (int i = 0; i < result.free.words_per_row(); ++i) {
                    const FreeTiles::Told told = tiles.tell(i, y / FreeTiles::kRows, z, all);
                    for (int row = y; row < std::min(e.y, y + FreeTiles::kRows); ++row) {
                        result.free.row(row, z)[i] = told.free[static_cast<std::size_t>(row - y)];
                    }
                }
            }
        }
        return result;
    }

    std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                               const FreeQuery& query) override {
        std::shared_ptr<DilatedLayers> layers = query.for_readers ? dilated_for_readers(tray) : dilated(tray);
        return std::make_unique<FreeTiles>(tray, std::move(layers), query, std::move(solid));
    }

    const char* name() const override { return "cpu"; }
    std::int64_t memory() const override {
        std::int64_t bytes = tables_.bytes() + positions_.bytes();
        if (dilated_) bytes += dilated_->bytes();
        return bytes;
    }
    void forget() override {
        tables_ = TrayTables(options_.large_from, options_.bytes);
        positions_ = PositionCache(options_.cache_memory);
        dilated_ = nullptr;
        give_back_freed();
    }

  private:
    /// Which orientations have candidates left.
    static std::vector<bool> open_orientations(const Shape& shape, const Tray& tray, PositionCache::Entry& entry) {
        std::vector<bool> open(shape.orientations.size());
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (!shape.only_near.empty()) entry.states[i].leave_only(candidates_near(shape, i, tray.detail()));
            open[i] = !entry.states[i].all_dead();
        }
        return open;
    }

    /// Makes the runs of open orientations that have none yet: of those that follow by turns, of one from its voxels
    /// and of the others from it; those that are reversed first, each with what follows by exchanging its axes.
    void make_runs_of(const Shape& shape, int detail, const std::vector<bool>& open,
                      std::vector<OrientationRuns>& runs) {
        const std::size_t count = shape.orientations.size();
        const auto from = [&](std::size_t i) { return static_cast<std::size_t>(shape.orientations[i].turned_from); };
        const std::vector<OrientedShape>& all = shape.orientations;
        std::vector<bool> wanted(count, false);  // with what they follow from
        for (std::size_t i = 0; i < count; ++i) {
            if (!open[i]) continue;
            for (std::size_t k = i; runs[k].of_class.empty(); k = from(k)) {
                wanted[k] = true;
                if (!all[k].is_turned()) break;
            }
        }
        if (std::ranges::none_of(wanted, std::identity{})) return;  // as for nearly all copies
        std::vector<std::optional<Depths>> depths(count);           // of those that others are reversed from
        for (std::size_t i = 0; i < count; ++i) {
            if (!wanted[i] || all[i].is_exchanged()) continue;
            if (!all[i].is_turned()) {
                MadeRuns made = make_runs(all[i], detail, tables_, workers_);
                runs[i] = std::move(made.runs);
                depths[i] = std::move(made.depths);
            } else if (!depths[from(i)]) {
                depths[from(i)] = depths_of(all[from(i)], runs[from(i)].solid, detail);
            }
        }
        const auto turn = [&](std::size_t i) {
            runs[i] = turned(runs[from(i)], all[i].turn, all[from(i)].solid.extent(), detail, depths[from(i)], tables_);
        };
        workers_.for_each(static_cast<std::int64_t>(count), [&](std::int64_t i) {
            const auto first = static_cast<std::size_t>(i);
            if (all[first].is_exchanged()) return;
            if (wanted[first] && all[first].is_turned()) turn(first);
            for (std::size_t k = first + 1; k < count; ++k) {
                if (wanted[k] && all[k].is_exchanged() && from(k) == first) turn(k);
            }
        });
    }

    /// A task for each open orientation.
    std::vector<OrientationTask> plan_searches(const Shape& shape, const std::vector<bool>& open,
                                               PositionCache::Entry& entry, SearchContext& context) {
        const bool as_planned =
            entry.planned_classes == tables_.occupied_classes() && entry.planned_narrow == tables_.narrow();
        entry.planned_narrow = tables_.narrow();
        entry.planned_classes = tables_.occupied_classes();
        if (!as_planned) std::ranges::fill(entry.plans, OrientationPlan());
        std::vector<std::size_t> unplanned;
        for (std::size_t k = 0; k < open.size(); ++k) {
            if (open[k] && entry.plans[k].fine.loads.empty()) unplanned.push_back(k);
        }
        workers_.for_each(std::ssize(unplanned), [&](std::int64_t i) {
            const std::size_t k = unplanned[static_cast<std::size_t>(i)];
            entry.plans[k] = make_plan(entry.runs[k], tables_);
        });
        std::vector<OrientationTask> searches;
        for (std::size_t k = 0; k < open.size(); ++k) {
            if (!open[k]) continue;
            searches.push_back(make_task(context, entry.states[k], entry.runs[k], entry.plans[k], static_cast<int>(k),
                                         shape.orientations[k], entry.hits > 0, shape.admits));
        }
        positions_.count(entry);
        return searches;
    }

    /// True when quads are worth asking.
    static bool have_few(const std::vector<OrientationRuns>& runs) {
        return std::ranges::all_of(runs, [](const OrientationRuns& of) { return of.solid.runs.size() <= kFewRuns; });
    }

    /// Offers the seeds that are still free, so that there is something to beat from the start.
    static void sow(const std::vector<Placed>& seeds, std::vector<OrientationTask>& searches) {
        for (const Placed& seed : seeds) {
            const auto search = std::ranges::find(searches, seed.index, &OrientationTask::index);
            if (search != searches.end()) search_position(*search, seed.position);
        }
    }

    /// Places that the next copy may take: those that lost in this search, then earlier ones.
    static std::vector<Placed> seeds_after(const Incumbent& incumbent, const std::vector<Placed>& before) {
        std::vector<Placed> seeds = incumbent.beaten();
        for (const Placed& seed : before) {
            if (seeds.size() >= Incumbent::kMostBeaten) break;
            const auto same = [&](const Placed& s) { return s.index == seed.index && s.position == seed.position; };
            if (std::ranges::none_of(seeds, same)) seeds.push_back(seed);
        }
        return seeds;
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
        const std::optional<Placed> best = context.incumbent.get();
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
        return height(end) - height(begin) > static_cast<double>(search.solid.voxels);
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
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return searches[i].solid.axis; });
        std::vector<Task> tasks;
        const int most = searches.empty() ? 0 : *std::ranges::max_element(end);
        const int layers = in_order ? kLayersPerTaskInOrder : kLayersPerTask;
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

    /// Those of the tray asked about last.
    std::shared_ptr<DilatedLayers> dilated(const Tray& tray) {
        if (dilated_ && dilated_->instance() == tray.instance()) {
            dilated_->follow(tray);
        } else {
            dilated_ = nullptr;  // makes room first
            dilated_ = std::make_shared<DilatedLayers>(tray);
        }
        return dilated_;
    }

    /// Those that readers of the tray as it is have, or new ones.
    std::shared_ptr<DilatedLayers> dilated_for_readers(const Tray& tray) {
        const auto known = lent_.find(tray.instance());
        if (known != lent_.end()) {
            std::shared_ptr<DilatedLayers> layers = known->second.lock();
            if (layers && layers->version() == tray.version()) return layers;
        }
        std::erase_if(lent_, [](const auto& lent) { return lent.second.expired(); });
        auto layers = std::make_shared<DilatedLayers>(tray);
        lent_[tray.instance()] = layers;
        return layers;
    }

    BestPlacement with_neighbours(const Placed& best, const Runs& solid, int layers,
                                  const SearchContext& context) const {
        BestPlacement result{best.index, best.position, best.proximity, best.cost, {}};
        for (int i = 0; i < 6; ++i) {
            VoxelIndex q = best.position;
            q[i / 2] += i % 2 == 0 ? -1 : 1;
            result.neighbours[static_cast<std::size_t>(i)] =
                cost_of(context.model, q.z, layers, context.reference_layers, proximity_at(tables_, solid, q));
        }
        return result;
    }

    CpuOptions options_;
    Workers workers_;
    TrayTables tables_;
    PositionCache positions_;
    std::shared_ptr<DilatedLayers> dilated_;
    std::map<std::uint64_t, std::weak_ptr<DilatedLayers>> lent_;  // by the tray's instance
};

}  // namespace

std::unique_ptr<PlacementSearch> make_cpu_search(const CpuOptions& options, const Workers& workers) {
    return std::make_unique<CpuSearch>(options, workers);
}

}  // namespace spectralpack
