#pragma once
/// Places off the grid for copies that found none on it: where their boxes have room between the boxes of what stands.
/// A person sees at once that eight cubes of 100 mm fit into 201 mm; of the grid's positions none lets two of them in.

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "packing/off_grid/box_room.hpp"
#include "packing/tray/context.hpp"
#include "packing/tray/part_surfaces.hpp"
#include "packing/tray/refinement.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// An orientation of a part and the box that the turned mesh has there.
struct TurnedBox {
    int orientation = 0;
    Box box;
};

/// One tray, of which `refinement` knows where all stands.
class OffGrid {
  public:
    /// All that is referred to outlives it. The container has a ceiling. `wall_gap` in mm.
    OffGrid(const Container& container, double wall_gap, Tray& tray, const TrayContext& context, Refinement& refinement,
            PartSurfaces& surfaces);

    /// The distinct boxes of the part, in its orientations' order.
    const std::vector<TurnedBox>& boxes_of(int part);
    /// Room between what stands in the tray from the start.
    BoxRoom room_at_start() const;

    /// Stands the copy where its box has room between those of `placed` and of what stood before, in whichever
    /// orientation lets its top come lowest, then where (z, y, x) is least. Adds it to `placed`; false where there is
    /// no room.
    bool put(const Copy& copy, std::vector<PlacedCopy>& placed);
    /// Stands it with the lower corner of its box there.
    void put_at(const Copy& copy, const TurnedBox& turned, const Vec3& corner, std::vector<PlacedCopy>& placed);
    /// Stands it as it stood before clear().
    void put_again(const PlacedCopy& copy, std::vector<PlacedCopy>& placed);
    /// Whether a copy may stand there, as far as container meshes, keep-outs and caps are concerned.
    bool may_stand(int part, const TurnedBox& turned, const Vec3& corner) const;

    /// Takes out all that is `placed`. The room is then that of the start.
    void clear(std::vector<PlacedCopy>& placed);

  private:
    int gap_class(int part) const;
    struct Refused {
        Vec3 size;
        double gap = 0;
    };

    void follow(const std::vector<PlacedCopy>& placed);
    bool is_hopeless(const Vec3& size, double gap) const;

    const Container& container_;
    double wall_gap_;
    Tray& tray_;
    const TrayContext& context_;
    Refinement& refinement_;
    PartSurfaces& surfaces_;
    bool has_mesh_walls_ = false;
    std::map<int, std::vector<TurnedBox>> boxes_;  // by part
    BoxRoom room_;
    std::size_t followed_ = 0;      // of what is placed, in room_
    std::vector<Refused> refused_;  // no box as large as these has room any more
};

}  // namespace spectralpack
