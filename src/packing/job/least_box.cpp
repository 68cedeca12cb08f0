#include "packing/job/least_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kSides[] = {1, 0.84, 1.19, 0.71, 1.41};
constexpr double kAspects[] = {1, 1.4, 2};
constexpr int kFirstStep = 6;  // a part of the side

class BaseSearch {
  public:
    BaseSearch(const BaseSize& least, const BaseSize& most, const PackOnBase& pack)
        : least_(least), most_(most), pack_(pack) {}

    void run(int side) {
        for (const double size : kSides) {
            for (const double aspect : kAspects) {
                const double long_side = side * size * std::sqrt(aspect), short_side = long_side / aspect;
                attempt({static_cast<int>(std::lround(long_side)), static_cast<int>(std::lround(short_side))});
            }
        }
        for (int part = kFirstStep; best_ && !stopped_; part *= 2) {
            const int dx = std::max(1, base_.x / part), dy = std::max(1, base_.y / part);
            for (bool better = true; better && !stopped_;) {
                const BoxScore before = *best_;
                const BaseSize from = base_;
                for (const auto& [x, y] : {BaseSize{-dx, 0}, BaseSize{0, -dy}, BaseSize{dx, 0}, BaseSize{0, dy}}) {
                    attempt({from.x + x, from.y + y});
                }
                better = *best_ < before;
            }
            if (dx == 1 && dy == 1) return;
        }
    }

  private:
    void attempt(BaseSize base) {
        base = {std::clamp(base.x, least_.x, most_.x), std::clamp(base.y, least_.y, most_.y)};
        if (stopped_ || !tried_.insert(base).second) return;
        const std::optional<BoxScore> score = pack_(base);
        stopped_ = !score;
        if (score && (!best_ || *score < *best_)) {
            best_ = score;
            base_ = base;
        }
    }

    BaseSize least_, most_;
    const PackOnBase& pack_;
    std::set<BaseSize> tried_;
    std::optional<BoxScore> best_;
    BaseSize base_;
    bool stopped_ = false;
};

/// About as long as the sides of a cube that holds the boxes of all copies, in voxels.
int first_side(const PackingJob& job) {
    double boxes = 0;
    for (const Copy& copy : job.copies) {
        boxes += job.parts[static_cast<std::size_t>(copy.part)].box_volume;
    }
    return std::max(1, static_cast<int>(std::cbrt(boxes) / job.fill.tray.voxel_size));
}

}  // namespace

FillOptions on_base(FillOptions options, const BaseSize& base) {
    const double wall = 2 * options.wall_gap;
    options.container.size.x = base.x * options.tray.voxel_size + wall;
    options.container.size.y = base.y * options.tray.voxel_size + wall;
    options.tray.size.x = options.container.size.x - wall;
    options.tray.size.y = options.container.size.y - wall;
    return options;
}

double box_volume(const PackingJob& job, const std::vector<PlacedCopy>& placed) {
    Box box;
    for (const PlacedCopy& copy : placed) {
        const JobPart& part = job.parts[static_cast<std::size_t>(copy.copy.part)];
        box.add(bounding_box(transformed(*part.mesh, part.transform_of(copy))));
    }
    return box.volume();
}

void search_bases(int side, const BaseSize& least, const BaseSize& most, const PackOnBase& pack) {
    BaseSearch(least, most, pack).run(side);
}

void pack_in_least_box(TraysPacker& packer, const BaseSize& most, const StopToken& stop, const TellProgress& tell,
                       TrayObserver* observer, PackedJob& packed) {
    const PackingJob& job = packer.job();
    // One base after the other wants the same voxels; the memory plan has room for so many parts'.
    if (static_cast<int>(job.parts.size()) <= job.held) packer.keep_shapes();
    std::optional<BoxScore> least;
    std::int64_t searches = 0;
    const StopToken& enough = job.fill.enough ? *job.fill.enough : stop;
    const auto keep = [&] {
        packed.trays.trays.front().searches = searches;
        if (observer) tell_of(packed.trays, 0, *observer);
    };
    const PackOnBase pack_on = [&](const BaseSize& base) -> std::optional<BoxScore> {
        TraysResult trays;
        try {
            packer.pack({job.copies, on_base(job.fill, base), stop, tell}, trays);
        } catch (const ResourceError&) {
            if (!least) throw;
            return BoxScore{std::numeric_limits<std::int64_t>::max(), 0};  // too high a packing: not this base
        }
        searches += trays.searches();
        const auto missing = static_cast<std::int64_t>(job.copies.size()) - trays.placed();
        const bool cut_short = missing > 0 && enough.stopped();
        const BoxScore score{missing, box_volume(job, trays.trays.front().placed)};
        if (!least || (!cut_short && score < *least)) {
            least = score;
            packed.trays = std::move(trays);
            packed.base = base;
        }
        if (cut_short) return std::nullopt;
        return score;
    };
    try {
        search_bases(first_side(job), {1, 1}, most, pack_on);
    } catch (...) {
        if (least) keep();
        throw;
    }
    keep();
}

}  // namespace spectralpack
