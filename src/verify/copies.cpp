#include "verify/copies.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/remarks.hpp"
#include "spectralpack/error.hpp"
#include "verify/pose.hpp"
#include "verify/words.hpp"

namespace spectralpack {
namespace {

/// A transform as near to a rigid one as this (see PoseVerdict) is taken for one: 5e-7 mm on half a metre.
constexpr double kRigid = 1e-9;

/// A solid to make: the mesh and what is built into it.
struct Order {
    std::shared_ptr<const Mesh> mesh;
    Mat3 linear;
    std::string name;   ///< of the first part that wants it
    double volume = 0;  ///< signed, in the mesh's own unit
};

class Preparation {
  public:
    Preparation(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes, const Workers& workers)
        : packing_(packing), meshes_(meshes), workers_(workers) {
        result_.by_tray.resize(packing.trays.size());
        orders_of_.resize(packing.trays.size());
    }

    void take_in(int tray, int index) {
        const Placement& placement = placement_at(tray, index);
        const auto part_index = static_cast<std::size_t>(placement.part);
        if (placement.part < 0 || part_index >= packing_.parts.size()) return;
        const PackedPart& part = packing_.parts[part_index];
        if (part_index >= meshes_.size() || !meshes_[part_index]) {
            throw InternalError(part.name + " is placed, but its mesh is not there");
        }
        const double scale = part.to_mm();
        const PoseVerdict verdict = judge_pose(placement.transform, scale);
        if (!verdict.fault.empty()) {
            result_.findings.push_back(
                {FindingKind::transform, tray, {index}, verdict.deviation, named(tray, index) + " " + verdict.fault});
        }
        if (verdict.deviation == Box::kInfinity) return;

        JudgedCopy copy;
        copy.placement = index;
        copy.gap = part.gap;
        copy.posed.pose.translation = placement.transform.translation;
        const Mat3& linear = placement.transform.linear;
        std::size_t order = orders_.size();
        if (verdict.deviation <= kRigid && determinant(linear) > 0) {
            copy.posed.pose.linear = 1 / scale * linear;
            order = shared_.try_emplace({meshes_[part_index].get(), scale}, order).first->second;
            if (order == orders_.size()) {
                orders_.push_back({meshes_[part_index], scale * Mat3{}, part.name, 0});
            }
        } else {
            orders_.push_back({meshes_[part_index], linear, part.name, 0});
        }
        orders_of_[static_cast<std::size_t>(tray)].push_back(order);
        result_.by_tray[static_cast<std::size_t>(tray)].push_back(copy);
    }

    /// False when stopped.
    bool make_solids(Listener& listener, const StopToken& stop) {
        result_.solids.resize(orders_.size());
        constexpr std::size_t kBatch = 16;  // so that progress comes from this thread
        for (std::size_t begin = 0; begin < orders_.size(); begin += kBatch) {
            const std::size_t size = std::min(kBatch, orders_.size() - begin);
            workers_.for_each(static_cast<std::int64_t>(size), [&](std::int64_t k) {
                const std::size_t i = begin + static_cast<std::size_t>(k);
                orders_[i].volume = signed_volume(*orders_[i].mesh);
                result_.solids[i] = std::make_unique<const Solid>(*orders_[i].mesh, Transform{orders_[i].linear, {}},
                                                                  deep_enough(kCheckTolerance));
            });
            if (stop.stopped()) return false;
            listener.on_progress(
                {Phase::check, 0, 0, 0,
                 kPreparing * static_cast<double>(begin + size) / static_cast<double>(orders_.size())});
        }
        std::set<const Mesh*> told;
        Remarks open;
        for (std::size_t i = 0; i < orders_.size(); ++i) {
            if (result_.solids[i]->closed() || !told.insert(orders_[i].mesh.get()).second) continue;
            open.add(orders_[i].name, {"is not closed: only its surface is compared",
                                       "are not closed: only their surfaces are compared"});
        }
        for (const std::string& text : open.texts()) {
            listener.on_warning(text);
        }
        return true;
    }

    void measure(int tray) {
        const auto t = static_cast<std::size_t>(tray);
        std::vector<JudgedCopy>& copies = result_.by_tray[t];
        workers_.for_each(static_cast<std::int64_t>(copies.size()), [&](std::int64_t k) {
            const auto i = static_cast<std::size_t>(k);
            const std::size_t order = orders_of_[t][i];
            JudgedCopy& copy = copies[i];
            const double scale =
                packing_.parts[static_cast<std::size_t>(placement_at(tray, copy.placement).part)].to_mm();
            copy.volume = orders_[order].volume * scale * scale * scale;
            copy.posed.solid = result_.solids[order].get();
            for (const Vec3& vertex : copy.posed.solid->mesh().vertices) {
                copy.box.add(copy.posed.pose * vertex);
            }
        });
        for (const JudgedCopy& copy : copies) {
            judge_walls(tray, copy);
        }
    }

    Copies take() { return std::move(result_); }

  private:
    const Placement& placement_at(int tray, int index) const {
        return packing_.trays[static_cast<std::size_t>(tray)].placements[static_cast<std::size_t>(index)];
    }

    std::string named(int tray, int index) const {
        return tray_prefix(packing_, tray) + copy_name(packing_, placement_at(tray, index));
    }

    void judge_walls(int tray, const JudgedCopy& copy) {
        const double wall_gap = packing_.options.wall_gap;
        double worst = 0;
        std::string sides;
        for (int axis = 0; axis < 3; ++axis) {
            const double below = wall_gap - copy.box.min[axis];
            const double above = copy.box.max[axis] - (packing_.container.size[axis] - wall_gap);
            for (const auto& [amount, sign] : {std::pair(below, '-'), std::pair(above, '+')}) {
                const bool no_wall = packing_.container.open_height && axis == 2 && sign == '+';
                if (no_wall || amount <= kCheckTolerance) continue;
                worst = std::max(worst, amount);
                sides += (sides.empty() ? "" : ", ") + short_number(amount) + " mm at " + sign + "xyz"[axis];
            }
        }
        if (sides.empty()) return;
        const std::string what =
            wall_gap > 0 ? " stands too near to the walls for their gap of " + short_number(wall_gap) + " mm, by "
                         : " sticks out of the tray by ";
        result_.findings.push_back(
            {FindingKind::outside, tray, {copy.placement}, worst, named(tray, copy.placement) + what + sides});
    }

    const Packing& packing_;
    const std::vector<std::shared_ptr<const Mesh>>& meshes_;
    const Workers& workers_;
    Copies result_;
    std::vector<Order> orders_;
    std::map<std::pair<const Mesh*, double>, std::size_t> shared_;  ///< orders by mesh and scale
    std::vector<std::vector<std::size_t>> orders_of_;               ///< by tray and copy
};

}  // namespace

std::optional<Copies> prepare_copies(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                                     const Workers& workers, Listener& listener, const StopToken& stop) {
    Preparation preparation(packing, meshes, workers);
    const int trays = static_cast<int>(packing.trays.size());
    for (int tray = 0; tray < trays; ++tray) {
        const auto& placements = packing.trays[static_cast<std::size_t>(tray)].placements;
        for (int i = 0; i < static_cast<int>(placements.size()); ++i) {
            preparation.take_in(tray, i);
        }
    }
    if (!preparation.make_solids(listener, stop)) return std::nullopt;
    for (int tray = 0; tray < trays; ++tray) {
        preparation.measure(tray);
    }
    return preparation.take();
}

}  // namespace spectralpack
