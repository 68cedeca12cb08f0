#include "search/reference/reference_search.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/stopped.hpp"
#include "search/reference/correlation.hpp"
#include "search/reference/error_bound.hpp"
#include "search/reference/tray_spectra.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

template <class Real>
class FourierSearch final : public ReferenceSearch {
  public:
    FourierSearch(const ReferenceOptions& options, const Workers& workers) : options_(options), workers_(workers) {}

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override;
    MetricFields metric_fields(const Tray& tray, const Shape& shape, int index) override;
    const char* name() const override { return "reference"; }
    std::int64_t memory() const override;

  private:
    /// What one orientation works in.
    struct Lane {
        FourierBuffer<Real> a, sum;
        BitGrid free;
    };

    void plan_for(const Tray& tray, const Shape& shape);
    void make_lanes(int orientations, const Extent& tray);
    std::optional<BestPlacement> best_of_orientation(Lane& lane, const Tray& tray, const OrientedShape& shape,
                                                     int index, const CostModel& model, const Admits& admits,
                                                     const Workers& workers) const;
    void correlate_collisions(Lane& lane, const OrientedShape& shape, int detail, const Workers& workers) const;
    void correlate_proximities(Lane& lane, const OrientedShape& shape) const;
    void find_free(Lane& lane, const Extent& candidates) const;
    std::array<Cost, 6> neighbour_costs(const Tray& tray, const OrientedShape& shape, const VoxelIndex& q,
                                        const CostModel& model) const;
    void check_rounding(const Extent& grid, double norms, int terms) const;

    ReferenceOptions options_;
    Workers workers_;
    Extent planned_tray_;  ///< of the tray that plan_ is for
    std::optional<FourierPlan<Real>> plan_;
    TraySpectra<Real> spectra_;
    std::vector<Lane> lanes_;
};

/// How far A+g reaches beyond A on its worse side, over all orientations. Positions keep A inside
/// the tray, so that is how far it can reach beyond the tray: with so many empty cells beyond the
/// tray nothing wraps onto it.
VoxelIndex overhang_of(const Shape& shape, int detail) {
    VoxelIndex most;
    for (const OrientedShape& oriented : shape.orientations) {
        const Extent& a = oriented.solid.extent();
        for (const auto& wide : oriented.widened) {
            for (int axis = 0; axis < 3; ++axis) {
                const int before = -wide.offset[axis];
                const int after = wide.voxels.extent()[axis] - detail * a[axis] - before;
                most[axis] = std::max(most[axis], (std::max(before, after) + detail - 1) / detail);
            }
        }
    }
    return most;
}

template <class Real>
void FourierSearch<Real>::plan_for(const Tray& tray, const Shape& shape) {
    Extent grid = transform_extent(tray.extent(), overhang_of(shape, tray.detail()));
    if (plan_ && planned_tray_ == tray.extent()) {
        // Fixed grids and plans (appendix A.1): they only grow, when a wider gap turns up.
        for (int axis = 0; axis < 3; ++axis) {
            grid[axis] = std::max(grid[axis], plan_->grid()[axis]);
        }
        if (grid == plan_->grid()) return;
    }
    lanes_.clear();
    spectra_ = {};
    plan_.reset();
    plan_.emplace(grid, options_.measure);
    planned_tray_ = tray.extent();
}

template <class Real>
void FourierSearch<Real>::make_lanes(int orientations, const Extent& tray) {
    const int most = options_.lanes > 0 ? options_.lanes : workers_.threads();
    while (static_cast<int>(lanes_.size()) < std::min(most, orientations)) {
        lanes_.push_back({FourierBuffer<Real>(plan_->grid()), FourierBuffer<Real>(plan_->grid()), BitGrid(tray)});
    }
}

/// Algorithm 1.
template <class Real>
SearchResult FourierSearch<Real>::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                                 const StopToken& stop) {
    const int orientations = static_cast<int>(shape.orientations.size());
    const Workers workers = workers_.stopping_with(stop);
    std::vector<std::optional<BestPlacement>> bests(shape.orientations.size());
    try {
        workers.check();
        plan_for(tray, shape);
        spectra_.update(tray, *plan_, workers);
        make_lanes(orientations, tray.extent());
        const int lanes = std::min(orientations, static_cast<int>(lanes_.size()));
        workers.for_each(lanes, [&](std::int64_t lane) {
            for (auto i = static_cast<std::size_t>(lane); i < bests.size(); i += static_cast<std::size_t>(lanes)) {
                bests[i] = best_of_orientation(lanes_[static_cast<std::size_t>(lane)], tray, shape.orientations[i],
                                               static_cast<int>(i), model, shape.admits, workers);
            }
        });
    } catch (const Stopped&) {  // between two transforms
        return {std::nullopt, true};
    }

    std::optional<BestPlacement> best;
    for (const auto& candidate : bests) {
        if (candidate && (!best || candidate->cost < best->cost)) best = candidate;
    }
    if (best) {
        const auto& oriented = shape.orientations[static_cast<std::size_t>(best->index)];
        best->neighbours = neighbour_costs(tray, oriented, best->position, model);
    }
    return {best, false};
}

template <class Real>
std::optional<BestPlacement> FourierSearch<Real>::best_of_orientation(Lane& lane, const Tray& tray,
                                                                      const OrientedShape& shape, int index,
                                                                      const CostModel& model, const Admits& admits,
                                                                      const Workers& workers) const {
    // Circular correlations tell of every displacement; those where the object clips out of the
    // tray are discarded (appendix A.1).
    const Extent count = tray.candidates(shape.reach);
    if (count.empty()) return std::nullopt;
    correlate_collisions(lane, shape, tray.detail(), workers);
    workers.check();
    find_free(lane, count);
    correlate_proximities(lane, shape);

    // Equation (6), ties to the least (z, y, x).
    const double scale = 1 / static_cast<double>(plan_->grid().count());
    std::optional<BestPlacement> best;
    for (int z = 0; z < count.z; ++z) {
        if (!model.allows(index, z)) continue;
        for (int y = 0; y < count.y; ++y) {
            const Real* row = lane.sum.row(y, z);
            for_each_bit(lane.free.row(y, z), lane.free.words_per_row(), [&](int x) {
                // Rounded to the nearest; rho is never negative.
                const auto rho = static_cast<std::int64_t>(row[x] * scale + 0.5);
                const Cost cost = cost_of(model, z, shape.solid.extent().z, tray.reference_layers(), rho);
                if (best && !(cost < best->cost)) return;
                if (admits && !admits(index, {x, y, z})) return;
                best = BestPlacement{index, {x, y, z}, rho, cost, {}};
            });
        }
    }
    return best;
}

/// Equation (2): leaves zeta, times the number of cells, in lane.sum and A's spectrum in lane.a.
template <class Real>
void FourierSearch<Real>::correlate_collisions(Lane& lane, const OrientedShape& shape, int detail,
                                               const Workers& workers) const {
    double norms = 0;
    int terms = 0;
    const auto collide = [&](const BitGrid& a, const TraySpectrum<Real>& omega) {
        add_correlation(lane.sum, lane.a, omega.buffer);
        norms += norm_of_bits(a) * omega.norm;
        ++terms;
    };
    lane.sum.clear();

    // Objects that ask for a gap are met by A+g, one transform for each part of all that ask for the same.
    std::vector<std::size_t> unwidened;
    std::vector<WidenedVoxels> done;
    for (std::size_t c = 0; c < spectra_.classes(); ++c) {
        const WidenedVoxels& wide = shape.widened[c];
        if (std::ranges::find(done, wide) != done.end()) continue;
        if (detail == 1 && wide.offset == VoxelIndex{} && *wide.voxels == *shape.solid) {
            if (spectra_.objects(c, 0)) unwidened.push_back(c);
            continue;
        }
        const SplitVoxels fine = split(*wide.voxels, wide.offset, detail);
        for (std::size_t part = 0; part < spectra_.parts(); ++part) {
            bool transformed = false;
            for (std::size_t same = c; same < spectra_.classes(); ++same) {
                if (!spectra_.objects(same, part) || shape.widened[same] != wide) continue;
                workers.check();
                if (!transformed) put_spectrum(lane.a, *plan_, fine.parts[part], fine.offset);
                transformed = true;
                collide(fine.parts[part], *spectra_.objects(same, part));
            }
        }
        done.push_back(wide);
    }

    put_spectrum(lane.a, *plan_, *shape.solid, {});
    if (spectra_.walls()) collide(*shape.solid, *spectra_.walls());
    for (const std::size_t c : unwidened) {
        collide(*shape.solid, *spectra_.objects(c, 0));
    }
    workers.check();
    plan_->inverse(lane.sum);
    check_rounding(plan_->grid(), norms, terms);
}

/// Equation (4): rho = IFFT(conj(FFT(s_A)) FFT(phi)), times the number of cells, in lane.sum; A's spectrum is in
/// lane.a.
template <class Real>
void FourierSearch<Real>::correlate_proximities(Lane& lane, const OrientedShape& shape) const {
    lane.sum.clear();
    add_correlation(lane.sum, lane.a, spectra_.phi_spectrum().buffer);
    plan_->inverse(lane.sum);
    check_rounding(plan_->grid(), norm_of_bits(*shape.solid) * spectra_.phi_spectrum().norm, 1);
}

/// Sets lane.free where zeta = 0 among the candidates.
template <class Real>
void FourierSearch<Real>::find_free(Lane& lane, const Extent& candidates) const {
    const Real half = static_cast<Real>(0.5 * static_cast<double>(plan_->grid().count()));
    lane.free.fill(false);
    for (int z = 0; z < candidates.z; ++z) {
        for (int y = 0; y < candidates.y; ++y) {
            const Real* row = lane.sum.row(y, z);
            BitGrid::Word* words = lane.free.row(y, z);
            for (int x = 0; x < candidates.x; ++x) {
                words[x / BitGrid::kWordBits] |= BitGrid::Word{row[x] < half} << (x % BitGrid::kWordBits);
            }
        }
    }
}

template <class Real>
MetricFields FourierSearch<Real>::metric_fields(const Tray& tray, const Shape& shape, int index) {
    plan_for(tray, shape);
    spectra_.update(tray, *plan_, workers_);
    make_lanes(1, tray.extent());
    Lane& lane = lanes_.front();
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(index)];
    const Extent count = tray.candidates(oriented.reach);
    const double scale = 1 / static_cast<double>(plan_->grid().count());
    const auto rounded = [&] {
        Grid<std::int64_t> field(count);
        for (int z = 0; z < count.z; ++z) {
            for (int y = 0; y < count.y; ++y) {
                const Real* row = lane.sum.row(y, z);
                for (int x = 0; x < count.x; ++x) {
                    // To the nearest; neither is ever negative.
                    field.at(x, y, z) = static_cast<std::int64_t>(row[x] * scale + 0.5);
                }
            }
        }
        return field;
    };
    MetricFields fields;
    correlate_collisions(lane, oriented, tray.detail(), workers_);
    fields.collision = rounded();
    correlate_proximities(lane, oriented);
    fields.proximity = rounded();
    return fields;
}

/// Section 3.2's discrete gradient needs sigma beside the winner, also where it collides or
/// overhangs.
template <class Real>
std::array<Cost, 6> FourierSearch<Real>::neighbour_costs(const Tray& tray, const OrientedShape& shape,
                                                         const VoxelIndex& q, const CostModel& model) const {
    const BitGrid& solid = *shape.solid;
    const Extent& a = solid.extent();
    std::array<Cost, 6> costs;
    for (int i = 0; i < 6; ++i) {
        VoxelIndex at = q;
        at[i / 2] += i % 2 == 0 ? -1 : 1;
        std::int64_t rho = 0;
        for (int z = 0; z < a.z; ++z) {
            for (int y = 0; y < a.y; ++y) {
                for (int x = 0; x < a.x; ++x) {
                    const VoxelIndex v = at + VoxelIndex{x, y, z};
                    if (solid.get(x, y, z) && tray.extent().contains(v)) {
                        rho += spectra_.phi().at(v.x, v.y, v.z);
                    }
                }
            }
        }
        costs[static_cast<std::size_t>(i)] = cost_of(model, at.z, a.z, tray.reference_layers(), rho);
    }
    return costs;
}

/// Section 4.1: a correlation padded with the object's size, so that every displacement is its own.
template <class Real>
FreePositions FourierSearch<Real>::free_positions(const Tray& tray, const Shape& shape, int index,
                                                  const FreeQuery& query) {
    const BitGrid& a = *shape.orientations[static_cast<std::size_t>(index)].solid;
    const Extent& n = tray.extent();
    const VoxelIndex more{a.extent().x - 1, a.extent().y - 1, a.extent().z - 1};
    const FourierPlan<Real> plan(transform_extent(n, more), false);
    const Extent& grid = plan.grid();
    const BitGrid omega = tray.omega_move(query.without);

    FourierBuffer<Real> moving(grid), sum(grid);
    {
        FourierBuffer<Real> standing(grid);
        put_spectrum(moving, plan, a, {});
        put_spectrum(standing, plan, omega, {});
        add_correlation(sum, moving, standing);
    }
    plan.inverse(sum);
    check_rounding(grid, norm_of_bits(a) * norm_of_bits(omega), 1);

    const int padding = query.padding;
    FreePositions result;
    result.origin = VoxelIndex{-padding, -padding, -padding} - more;
    result.free = BitGrid({n.x + more.x + 2 * padding, n.y + more.y + 2 * padding, n.z + more.z + 2 * padding});
    result.free.fill(true);  // what is beyond the positions that can overlap the grid
    const Real half = static_cast<Real>(0.5 * static_cast<double>(grid.count()));
    for (int z = -more.z; z < n.z; ++z) {
        for (int y = -more.y; y < n.y; ++y) {
            const Real* row = sum.row(wrapped(y, grid.y), wrapped(z, grid.z));
            for (int x = -more.x; x < n.x; ++x) {
                const VoxelIndex at = VoxelIndex{x, y, z} - result.origin;
                result.free.set(at.x, at.y, at.z, row[wrapped(x, grid.x)] < half);
            }
        }
    }
    return result;
}

template <class Real>
void FourierSearch<Real>::check_rounding(const Extent& grid, double norms, int terms) const {
    if (options_.single_precision) return;
    const double bound = correlation_error_bound(grid, norms, terms, 0x1p-53);
    if (bound < 0.5) return;
    throw ResourceError("the reference engine cannot answer exactly in a tray of this size: its error may reach " +
                        std::to_string(bound) + " where 0.5 is the limit");
}

template <class Real>
std::int64_t FourierSearch<Real>::memory() const {
    if (!plan_) return 0;
    std::int64_t bytes = spectra_.bytes(plan_->grid());
    for (const Lane& lane : lanes_) {
        bytes += 2 * FourierBuffer<Real>::bytes(plan_->grid()) + lane.free.bytes();
    }
    return bytes;
}

}  // namespace

std::unique_ptr<ReferenceSearch> make_reference_search(const ReferenceOptions& options, const Workers& workers) {
    if (options.single_precision) return std::make_unique<FourierSearch<float>>(options, workers);
    return std::make_unique<FourierSearch<double>>(options, workers);
}

}  // namespace spectralpack
