#include "packing/job/trays_packer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "packing/job/tray_choice.hpp"

namespace spectralpack {
namespace {

/// Parts that are the same mesh at the same size with the same gap and orientations share an id, and so the engines'
/// caches.
std::vector<std::uint64_t> shape_ids_of(const std::vector<JobPart>& parts) {
    std::map<std::tuple<const Mesh*, double, double, const void*>, std::uint64_t> ids;
    std::vector<std::uint64_t> by_part;
    for (const JobPart& part : parts) {
        const auto key =
            std::tuple(part.mesh.get(), part.to_mm, part.gap, static_cast<const void*>(part.orientations.get()));
        by_part.push_back(ids.emplace(key, ids.size() + 1).first->second);
    }
    return by_part;
}

/// By part, how many of the copies have its shape.
std::vector<int> copies_of_shapes(const std::vector<Copy>& copies, const std::vector<std::uint64_t>& shape_ids) {
    std::unordered_map<std::uint64_t, int> counts;
    for (const Copy& copy : copies) {
        ++counts[shape_ids[static_cast<std::size_t>(copy.part)]];
    }
    std::vector<int> by_part;
    for (const std::uint64_t id : shape_ids) {
        by_part.push_back(counts[id]);
    }
    return by_part;
}

/// In the order in which the parts come first.
std::vector<PartShare> shares_of(const PackingJob& job) {
    std::vector<PartShare> shares;
    std::set<int> seen;
    for (const Copy& copy : job.copies) {
        if (!seen.insert(copy.part).second) continue;
        shares.push_back({copy.part, job.parts[static_cast<std::size_t>(copy.part)].count});
    }
    return shares;
}

/// Tells how far one packing is.
class SearchProgress {
  public:
    SearchProgress(const PackingJob& job, const PackingPass& pass, bool one_tray)
        : job_(job), pass_(pass), one_tray_(one_tray), container_(volume_of(pass.fill.container)) {
        for (const Copy& copy : pass.copies) {
            efforts_.push_back(efforts_.back() + effort(copy));
        }
        pass_.tell({Phase::search, 0, static_cast<std::int64_t>(pass.copies.size()), 0, 0});
    }

    /// `tray` is filled as the last of `trays`, perhaps anew.
    void copy_done(const FilledTray& tray, std::size_t done, const TraysResult& trays) {
        if (tray_ != &tray || number_ != trays.trays.size()) begin_tray(tray, trays);
        for (; placed_ < tray.placed.size(); ++placed_) {
            settle(tray.placed[placed_].copy);
        }
        std::optional<double> density;
        if (pass_.fill.tray.ceiling == Ceiling::closed) density = volume_ / (container_ * static_cast<double>(number_));
        // What one tray leaves over the next one tries again.
        const std::int64_t sure = one_tray_ ? static_cast<std::int64_t>(done) : settled_;
        // How many copies will fill the tray is not known before.
        const std::int64_t total = job_.in_shares ? sure : static_cast<std::int64_t>(pass_.copies.size());
        const double work =
            job_.in_shares ? density.value_or(0) : (one_tray_ ? efforts_[done] : settled_effort_) / efforts_.back();
        pass_.tell({Phase::search, sure, total, density, std::min(work, 1.0), job_.verified ? job_.verified() : 0});
    }

  private:
    /// Only what earlier trays hold is settled.
    void begin_tray(const FilledTray& tray, const TraysResult& trays) {
        tray_ = &tray;
        number_ = trays.trays.size();
        placed_ = 0;
        settled_ = 0;
        volume_ = settled_effort_ = 0;
        for (std::size_t i = 0; i + 1 < number_; ++i) {
            for (const PlacedCopy& placed : trays.trays[i].placed) {
                settle(placed.copy);
            }
        }
    }

    void settle(const Copy& copy) {
        ++settled_;
        volume_ += job_.parts[static_cast<std::size_t>(copy.part)].volume;
        settled_effort_ += effort(copy);
    }

    /// As measured, a search takes about as long as the faces of the copy's box are large; one that is verified takes
    /// as long as the transforms of the reference engine, which are of the tray's size whatever the copy's is.
    double effort(const Copy& copy) const {
        if (job_.verified) return 1.0;
        return std::pow(job_.parts[static_cast<std::size_t>(copy.part)].box_volume, 2.0 / 3);
    }

    const PackingJob& job_;
    const PackingPass& pass_;
    bool one_tray_;
    double container_;                // volume
    std::vector<double> efforts_{0};  // of the first so many copies
    double volume_ = 0, settled_effort_ = 0;
    const FilledTray* tray_ = nullptr;  // that is being filled
    std::size_t number_ = 0;            // its, from 1
    std::size_t placed_ = 0;            // in it
    std::int64_t settled_ = 0;          // in all trays
};

}  // namespace

TraysPacker::TraysPacker(const PackingJob& job, PlacementSearch& engine, const Workers& workers, Decisions* decisions)
    : job_(job),
      engine_(engine),
      workers_(workers),
      shape_ids_(shape_ids_of(job.parts)),
      kept_(job.parts.size()),
      decisions_(decisions) {
    std::unordered_map<std::uint64_t, int> parts;
    for (const std::uint64_t id : shape_ids_) {
        ++parts[id];
    }
    for (const std::uint64_t id : shape_ids_) {
        shared_.push_back(parts[id] > 1);
    }
}

std::shared_ptr<const Shape> TraysPacker::shape_of(int part, int count, const TraySetup& tray, const Workers& workers) {
    const auto i = static_cast<std::size_t>(part);
    std::shared_ptr<const Shape> shape = kept_[i];
    if (!shape && shared_[i]) shape = last_shared_.find(shape_ids_[i]);
    if (!shape) {
        const ScaledPart scaled = job_.parts[i].scaled();
        Shape made = make_shape(shape_ids_[i], *scaled.mesh, *scaled.orientations, tray.voxel_size, tray.detail,
                                scaled.gap, tray.gap_classes, workers, job_.room);
        made.copies = job_.in_shares ? 0 : count;  // filling goes on as long as there is room
        shape = std::make_shared<const Shape>(std::move(made));
        if (shared_[i]) last_shared_.put(shape_ids_[i], shape);
        if (keeps_shapes_) kept_[i] = shape;
    }
    return shape;
}

std::shared_ptr<const Shape> TraysPacker::LastShared::find(std::uint64_t id) {
    const std::lock_guard lock(mutex_);
    return id == id_ ? shape_ : nullptr;
}

void TraysPacker::LastShared::put(std::uint64_t id, std::shared_ptr<const Shape> shape) {
    const std::lock_guard lock(mutex_);
    id_ = id;
    shape_ = std::move(shape);
}

void TraysPacker::with_filler(const FillerUse& use, const std::function<void(TrayFiller&)>& work) {
    const std::vector<int> counts = copies_of_shapes(job_.copies, shape_ids_);
    ShapeStore shapes(
        [&](int part, const Workers& workers) {
            return shape_of(part, counts[static_cast<std::size_t>(part)], use.fill.tray, workers);
        },
        workers_, job_.keep, job_.ahead);
    TrayFiller filler(use.fill, {engine_, shapes, workers_, use.stop, use.observer, use.decides ? decisions_ : nullptr},
                      [&](int part) { return job_.parts[static_cast<std::size_t>(part)].scaled(); });
    const auto note = [&] {
        seconds_.voxelize += shapes.seconds();
        seconds_.refine += filler.refine_seconds();
        seconds_.untangle += filler.untangle_seconds();
    };
    try {
        work(filler);
    } catch (...) {
        note();
        throw;
    }
    note();
}

std::shared_ptr<const Shape> TraysPacker::lasting_shape(int part) {
    Shape shape = *shape_of(part, 0, job_.fill.tray, workers_);
    shape.copies = 0;
    return std::make_shared<const Shape>(std::move(shape));
}

void TraysPacker::pack(const PackingPass& pass, TraysResult& result) {
    with_filler({pass.fill, pass.stop, pass.observer, true}, [&](TrayFiller& filler) { pack(pass, filler, result); });
}

void TraysPacker::pack(const PackingPass& pass, TrayFiller& filler, TraysResult& result) {
    TraysLimit limit = job_.limit;
    if (limit.trays > 0) limit.trays = std::max(limit.trays, filler.trays_with_fixed());
    SearchProgress progress(job_, pass, limit.trays == 1);
    const TrayCopyDone copy_done = [&](const FilledTray& tray, std::size_t done) {
        progress.copy_done(tray, done, result);
    };
    if (job_.in_shares) {
        FilledTray& tray = result.trays.emplace_back();
        filler.fill_in_shares(
            shares_of(job_), [&](std::size_t done) { copy_done(tray, done); }, tray);
        return;
    }
    std::optional<HeightChoice> choice;
    if (job_.choose_heights) choice = choose_heights(job_, pass.fill);
    const auto next_tray = [&] {
        if (trays_told_ && pass.observer) trays_told_(result);
    };
    fill_trays(pass.copies, limit, filler, choice ? &*choice : nullptr, copy_done, result, next_tray);
}

}  // namespace spectralpack
