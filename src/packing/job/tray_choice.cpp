#include "packing/job/tray_choice.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace spectralpack {
namespace {

// Full trays hold boxes of 0.9 to 3 times their room and material of 0.2 to 0.6 times it; solid boxes hardly more than
// 0.7 of both.
constexpr double kBoxes = 1.2, kMaterial = 0.4, kSolidBoxes = 0.7;

// A floor is mostly free where the boxes come to less than this part of the room up to the height reached.
constexpr double kCrowded = 0.7;
constexpr int kAttempts = 5;          // on parts of the base
constexpr double kCloseEnough = 1.2;  // between areas that were too small and large enough
constexpr double kNested = 2;         // boxes hardly take less room than this part of theirs
constexpr double kSameHeight = 0.1;   // of a voxel: what sliding together makes of it is no reason to spread

double widened_box(const Mesh& mesh, const Transform& transform, double gap) {
    const Vec3 size = bounding_box(transformed(mesh, transform)).size();
    return (size.x + gap) * (size.y + gap) * (size.z + gap);
}

double free_room(const TraySetup& tray) {
    const BitGrid& blocked = tray.blocked;
    const double all = static_cast<double>(blocked.extent().count());
    const double share = blocked.extent().empty() ? 1 : 1 - static_cast<double>(blocked.count()) / all;
    return tray.size.x * tray.size.y * tray.size.z * share;
}

/// Packs one tray in several ways and keeps the best.
class TrayAttempts {
  public:
    TrayAttempts(const HeightChoice& choice, TrayCopies wanted, TrayFiller& filler, const TrayCopyDone& copy_done,
                 FilledTray& best)
        : choice_(choice), wanted_(std::move(wanted)), filler_(filler), copy_done_(copy_done), best_(best) {}

    void run() {
        try {
            pack();
        } catch (...) {
            finish();
            throw;
        }
        finish();
    }

  private:
    void pack() {
        const Crowd crowd = choice_.crowd(wanted_);
        const bool expected = choice_.expects_to_fit(crowd);
        if (expected) wanted_.height_at = HeightAt::top;
        fill(best_);
        if (holds_all(best_) != expected) {
            wanted_.height_at = expected ? std::nullopt : std::optional(HeightAt::top);
            attempt([&](const FilledTray& other) { return score(other) < score(best_); });
        }
        if (holds_all(best_) && best_.height_at == HeightAt::top) gather(crowd);
    }

    void finish() {
        best_.searches += other_searches_;
        if (last_is_best_ || !filler_.context().observer) return;
        tell_anew(*filler_.context().observer, wanted_.number, best_.placed);
        filler_.context().observer->tray_finished();
    }

    bool holds_all(const FilledTray& tray) const { return tray.placed.size() == wanted_.copies.size(); }
    PackingScore score(const FilledTray& tray) const {
        return score_packing(wanted_.copies, {&tray.placed}, choice_.measures);
    }

    void fill(FilledTray& tray) {
        filler_.fill(
            wanted_, [&](std::size_t done) { copy_done_(tray, done); }, tray);
    }

    /// Packs the tray as `wanted_` says now. True where that is better, and kept.
    template <class Better>
    bool attempt(const Better& better) {
        if (filler_.enough().stopped()) return false;
        FilledTray other;
        last_is_best_ = false;
        fill(other);
        last_is_best_ = better(other);
        if (last_is_best_) std::swap(best_, other);
        other_searches_ += other.searches;
        return last_is_best_;
    }

    /// The wanted area of the base lies between one that was too small and one that was enough; both sides of the base
    /// grow shorter alike.
    void gather(const Crowd& crowd) {
        if (!crowd.size || wanted_.copies.empty()) return;
        const double dx = filler_.voxel_size(), top = score(best_).top;
        const auto whole = [&](double length) { return dx * std::max(1.0, std::ceil(length / dx - 1e-9)); };
        const Vec3 all{crowd.size->x, crowd.size->y, std::min(crowd.size->z, whole(top - filler_.wall_gap()))};
        const double room = all.x * all.y * all.z;
        if (crowd.boxes > kCrowded * room) return;
        double too_small = std::max(crowd.material, crowd.boxes / kNested) / room, enough = 1;
        wanted_.height_at = HeightAt::top;
        wanted_.give_up_after = 1;
        for (int i = 0; i < kAttempts && enough > kCloseEnough * too_small; ++i) {
            const double share = std::sqrt(too_small * enough), side = std::sqrt(share);
            wanted_.within = {std::min(all.x, whole(side * all.x)), std::min(all.y, whole(side * all.y)), all.z};
            const bool better = attempt([&](const FilledTray& other) {
                return holds_all(other) && score(other).top <= top + kSameHeight * dx;
            });
            (better ? enough : too_small) = share;
        }
    }

    const HeightChoice& choice_;
    TrayCopies wanted_;
    TrayFiller& filler_;
    const TrayCopyDone& copy_done_;
    FilledTray& best_;
    std::int64_t other_searches_ = 0;  // of packings that were not kept
    bool last_is_best_ = true;         // the observer was told of it last
};

}  // namespace

bool expects_to_fit(const Crowd& crowd) {
    return crowd.boxes <= kBoxes * crowd.room &&
           (crowd.material <= kMaterial * crowd.room || crowd.boxes <= kSolidBoxes * crowd.room);
}

HeightChoice choose_heights(const PackingJob& job, const FillOptions& fill) {
    const auto boxes = std::make_shared<std::vector<double>>();  // by part
    for (const JobPart& part : job.parts) {
        boxes->push_back(part.mesh ? widened_box(*part.mesh, {part.to_mm * Mat3{}, {}}, part.gap) : 0);
    }
    const bool plain =
        fill.tray.blocked.extent().empty() && !fill.container.physical && !fill.max_density && !fill.max_layer_fill;
    const auto crowd_of = [&job, &fill, room = free_room(fill.tray), boxes, plain](const TrayCopies& wanted) {
        Crowd crowd{room, 0, 0, {}};
        if (plain) crowd.size = fill.tray.size;
        for (const Copy& copy : wanted.copies) {
            const auto part = static_cast<std::size_t>(copy.part);
            crowd.boxes += (*boxes)[part];
            crowd.material += std::max(0.0, job.parts[part].volume);
        }
        for (const FixedCopy& fixed : fill.fixed) {
            if (fixed.tray != wanted.number) continue;
            const Mesh mesh = transformed(*fixed.mesh, fixed.transform);
            crowd.boxes += widened_box(mesh, {}, fixed.gap);
            crowd.material += std::max(0.0, signed_volume(mesh));
            crowd.size.reset();
        }
        return crowd;
    };
    const double most_material = fill.max_density.value_or(1) * volume_of(fill.container);
    return {crowd_of,
            [most_material](const Crowd& crowd) { return crowd.material <= most_material && expects_to_fit(crowd); },
            measures_of(job.parts)};
}

void fill_by_choice(const HeightChoice& choice, TrayCopies wanted, TrayFiller& filler, const TrayCopyDone& copy_done,
                    FilledTray& tray) {
    TrayAttempts(choice, std::move(wanted), filler, copy_done, tray).run();
}

}  // namespace spectralpack
