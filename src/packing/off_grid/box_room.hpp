#pragma once
/// Room for boxes between boxes, off any grid. Millimetres.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// Boxes whose sides differ by less are of one size, mm.
inline constexpr double kSameSize = 1e-6;

/// A box that others keep a gap from, along every axis by itself (so at least as far as the gap).
struct StandingBox {
    Box box;
    double gap = 0;     ///< two boxes keep the larger of their gaps
    bool wall = false;  ///< who comes near keeps this gap, not its own
};

class BoxRoom {
  public:
    /// `room`: for all boxes; its walls may be touched. `most_work`: box tests in all, so that time is bounded; what
    /// would take more finds no place.
    explicit BoxRoom(const Box& room, std::int64_t most_work = kMostWork);

    void add(const StandingBox& standing) { standing_.push_back(standing); }

    /// Whether a box with its lower corner there may be taken.
    using Accepts = std::function<bool(const Vec3& corner)>;

    /// The least (z, y, x) where the lower corner of a box of this size may stand. There is one whenever the box has
    /// room anywhere, but for what `accepts` turns down: of places that can be slid into each other only the least is
    /// asked about. Touching is allowed, and overlap for rounding.
    std::optional<Vec3> lowest(const Vec3& size, double gap, const Accepts& accepts);

    /// Whether the box stands free there.
    bool is_free(const Box& box, double gap) const;

    /// The lower corners of a plain lattice of boxes of this size from the room's lower corner on, in the order of z,
    /// y, x; those that do not stand free left out, and those after the first `most`.
    std::vector<Vec3> lattice(const Vec3& size, double gap, std::int64_t most) const;

    static constexpr std::int64_t kMostWork = 300'000'000;

  private:
    Box room_;
    std::int64_t work_left_;
    std::vector<StandingBox> standing_;
};

}  // namespace spectralpack
