#pragma once
/// Containers that are meshes, and keep-outs: do the copies stay clear of what is not free?

#include <memory>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/stop.hpp"
#include "verify/check.hpp"
#include "verify/copies.hpp"

namespace spectralpack {

class Walls {
  public:
    /// `all`: the box of every copy of every tray. Throws InternalError where a mesh has not been loaded.
    Walls(const Packing& packing, const Box& all);

    /// Findings of kind outside: copies of a tray that leave the mesh container or reach into a keep-out by more than
    /// the tolerance, or come nearer to them than the wall gap. Nothing where `stop` came first.
    std::vector<Finding> judge(int tray, const std::vector<JudgedCopy>& copies, const Workers& workers,
                               const StopToken& stop) const;

    /// What of the container is in the way of what leaves (model/physical_surfaces.hpp), for replay_plan(): of one that
    /// is physical, or where a plan says that it goes between walls (Unpack::top). Refers to this.
    std::vector<JudgedCopy> standing() const;

  private:
    struct Wall {
        std::string name;  ///< what a copy reaches into
        std::unique_ptr<const Solid> solid;
    };

    const Packing& packing_;
    std::vector<Wall> walls_;
    std::vector<std::unique_ptr<const Solid>> physical_;
};

}  // namespace spectralpack
