#include "spectralpack/change.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

#include "api/input_hash.hpp"
#include "core/parallel.hpp"
#include "packing/tray/measure.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kSameMatrix = 1e-9;

bool is_same(const Mat3& a, const Mat3& b) {
    double most = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            most = std::max(most, std::abs(a.rows[row][column] - b.rows[row][column]));
        }
    }
    return most <= kSameMatrix;
}

class PackingChange {
  public:
    PackingChange(const Scene& scene, int threads) : scene_(scene), packing_(scene.packing), workers_(threads) {}

    void make(const CopyChange& change) {
        if (change.tray < 0 || change.tray >= static_cast<int>(packing_.trays.size())) {
            throw UsageError("the build has no tray " + std::to_string(change.tray + 1));
        }
        if (change.part < 0 || change.part >= static_cast<int>(packing_.parts.size()) || change.copy < 0 ||
            change.copy >= packing_.parts[static_cast<std::size_t>(change.part)].count) {
            throw UsageError("the build has no such copy");
        }
        Placement placement{change.part, change.copy, 0, false, {}};
        const auto tray = static_cast<std::size_t>(change.tray);
        const Found found = find(change);
        if (found.placement) placement = *found.placement;
        if (placement.fixed && !placement.before)
            throw UsageError(name_of(change) + " is fixed: the job says where it stands");
        if (change.transform) {
            placement.orientation = orientation_of(placement, change);
            placement.transform = *change.transform;
        }
        if (found.placement && change.transform && found.tray == tray) {
            *found.placement = placement;
        } else {
            if (!found.placement && !change.transform) throw UsageError(name_of(change) + " stands in no tray");
            if (found.placement) take_out(found);
            if (change.transform) {
                put_in(tray, placement);
            } else {
                packing_.unplaced.push_back({change.part, change.copy, UnplacedReason::not_tried, kTakenOutByHand});
            }
        }
        changed_.insert(tray);
        trace_ += " " + std::to_string(change.tray) + " " + std::to_string(change.part) + " " +
                  std::to_string(change.copy) + " " + text_of(change.transform);
    }

    Packing finish() {
        if (packing_.container.open_height) {
            double height = 0;
            for (const TrayPacking& tray : packing_.trays) {
                height = std::max(height, reached_height(tray, scene_.meshes));
            }
            if (height > 0) packing_.container.size.z = height;
        }
        Metrics& metrics = packing_.metrics;
        metrics.density = 0;
        metrics.placed = 0;
        for (std::size_t i = 0; i < packing_.trays.size(); ++i) {
            TrayPacking& tray = packing_.trays[i];
            if (changed_.contains(i)) {
                tray.disassembly.reset();
                measure_tray(tray, packing_.container, packing_.parts, scene_.meshes, tray.layers.thickness, workers_);
            }
            metrics.placed += static_cast<std::int64_t>(tray.placements.size());
            metrics.density += tray.density / static_cast<double>(packing_.trays.size());
        }
        metrics.min_gap.reset();
        metrics.interlock.reset();
        metrics.improvement.reset();
        packing_.input_hash = chained_hash(packing_.input_hash, trace_);
        return std::move(packing_);
    }

  private:
    /// Where a copy stands; null: nowhere.
    struct Found {
        std::size_t tray = 0;
        Placement* placement = nullptr;
    };

    Found find(const CopyChange& change) {
        for (std::size_t i = 0; i < packing_.trays.size(); ++i) {
            for (Placement& placement : packing_.trays[i].placements) {
                if (placement.part == change.part && placement.copy == change.copy) return {i, &placement};
            }
        }
        return {};
    }

    void take_out(const Found& found) {
        std::vector<Placement>& placements = packing_.trays[found.tray].placements;
        placements.erase(placements.begin() + (found.placement - placements.data()));
        changed_.insert(found.tray);
    }

    void put_in(std::size_t tray, const Placement& placement) {
        packing_.trays[tray].placements.push_back(placement);
        std::erase_if(packing_.unplaced,
                      [&](const Unplaced& left) { return left.part == placement.part && left.copy == placement.copy; });
    }

    /// Its index in the part's orientation set; 0 where it is none of those.
    int orientation_of(const Placement& placement, const CopyChange& change) const {
        const PackedPart& part = packing_.parts[static_cast<std::size_t>(change.part)];
        const double mm = part.to_mm();
        const auto rotation = as_rotation(1 / mm * change.transform->linear);
        if (!rotation) throw UsageError(name_of(change) + ": its transform is not a rotation times its scale");
        if (is_same(change.transform->linear, placement.transform.linear)) return placement.orientation;
        const std::vector<Mat3> set =
            orientation_set(parse_rotations(packing_.options.rotations.value_or("90")), part.orientations);
        const auto known = std::ranges::find_if(set, [&](const Mat3& turn) { return is_same(turn, *rotation); });
        return known == set.end() ? 0 : static_cast<int>(known - set.begin());
    }

    std::string name_of(const CopyChange& change) const {
        return packing_.parts[static_cast<std::size_t>(change.part)].name + ", copy " + std::to_string(change.copy + 1);
    }

    static std::string text_of(const std::optional<Transform>& transform) {
        if (!transform) return "out";
        std::string text;
        char number[32];
        for (const Vec3& v : {transform->linear.rows[0], transform->linear.rows[1], transform->linear.rows[2],
                              transform->translation}) {
            for (const double value : {v.x, v.y, v.z}) {
                std::snprintf(number, sizeof number, "%.17g ", value);
                text += number;
            }
        }
        return text;
    }

    const Scene& scene_;
    Packing packing_;
    Workers workers_;
    std::set<std::size_t> changed_;
    std::string trace_;
};

}  // namespace

Packing changed(const Scene& scene, const std::vector<CopyChange>& changes, int threads) {
    PackingChange change(scene, threads);
    for (const CopyChange& one : changes) {
        change.make(one);
    }
    return change.finish();
}

}  // namespace spectralpack
