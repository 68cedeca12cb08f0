#pragma once
/// Copies that stand together (spectralpack/disassembly.hpp), and what is asked of them: is a way free, by exact sweeps
/// of the true meshes; and what are the voxels that ways with corners are looked for in (disassembly/ways_out.hpp).

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "disassembly/body.hpp"
#include "disassembly/graph/blocking_graph.hpp"
#include "disassembly/standing_hull.hpp"
#include "geometry/box_index.hpp"
#include "geometry/slide.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/stop.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

// In millimetres.
inline constexpr double kClearance = 1;  ///< by which a copy that has left is clear of the box of the others
inline constexpr double kGraze = 8e-4;   ///< overlap sideways let pass: voxels are drawn in by 1e-4 dx, from both sides

struct DisassemblyOptions {
    PlacementSearch* search = nullptr;
    TraySetup grid;          ///< whose voxels the parts' objects are in
    Vec3 corner;             ///< of that grid, mm
    double ray_spacing = 1;  ///< mm
    /// Finer rays tell little that sweeps would not, and take longer.
    static constexpr double spacing_for(double voxel) { return 4 * voxel; }
    /// voxelize() of part `name`, for parts that stand off the grid.
    std::function<std::shared_ptr<const BitGrid>(int name)> on_grid;
    Workers workers;
    StopToken stop;
};

class Subassembly {
  public:
    using Path = std::vector<Vec3>;
    using Members = std::vector<std::size_t>;

    Subassembly(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts);
    /// To which nobody is added: its voxels are only those around it.
    static Subassembly closed(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts);
    /// `members` of `whole`, which become 0, 1, ..., to themselves; closed.
    Subassembly(const Subassembly& whole, const Members& members);

    double voxel_size() const { return tray_.voxel_size(); }
    const StopToken& stop() const { return options_.stop; }
    std::size_t size() const { return parts_.size(); }
    const Body& part(std::size_t i) const { return parts_[i]; }
    int name(std::size_t i) const { return names_[i]; }
    bool present(std::size_t i) const { return present_[i]; }
    bool movable(std::size_t i) const { return present_[i] && !parts_[i].object.fixed; }
    Members movable() const;

    std::size_t add(int name, Body part);
    void remove(std::size_t i);
    /// From now on that part is in nobody's way, as if it were not there; none: all are again. What flood() tells of
    /// does not change.
    void set_aside(std::optional<std::size_t> part) { aside_ = part; }
    std::optional<std::size_t> aside() const { return aside_; }

    /// A member and one of the others.
    struct Pair {
        std::size_t member, other;
    };
    /// Of a straight way: how long it is until `members` (ascending) are clear of the box of the others, or one whom
    /// they would meet on it.
    struct Straight {
        std::optional<Pair> met;
        Path path;                 ///< of one move; empty where no others are left
        std::vector<Pair> passed;  ///< pairs near the way that were swept and found to pass
    };
    /// From where they stand. Pairs that `known` (of this subassembly's indices) tells to pass are not swept again.
    /// Time grows with the triangles near to the way.
    Straight straight_way(const Members& members, AxisDirection direction, const BlockingGraph* known = nullptr) const;

    /// What may shorten a question about a move: pairs known to pass (from where all stand), and whom to ask first.
    struct Hints {
        const BlockingGraph* known = nullptr;
        std::optional<std::size_t> first;
    };
    /// The same for members that have moved by `from` before.
    Straight straight_way(const Members& members, const Vec3& from, AxisDirection direction, const Hints& hints) const;
    /// Whether members that have moved by `from` may go on by `move`, along an axis, or by all moves of a path.
    bool free_move(const Members& members, const Vec3& from, const Vec3& move) const;
    bool free_path(const Members& members, Vec3 from, const Path& path) const;

    /// What a flood fill for one copy starts from.
    struct Flood {
        std::size_t i = 0;
        std::shared_ptr<const BitGrid> solid{};   ///< its voxels on the grid
        Vec3 at;                                  ///< where it stands, from the grid's corner, mm
        VoxelIndex nearest;                       ///< the position nearest to that
        bool on_grid = true;                      ///< which is where it stands
        VoxelIndex origin;                        ///< of what `tiles` tell of, in the grid
        VoxelBox others;                          ///< around all that stands besides, from there
        std::unique_ptr<FreeTileReader> tiles{};  ///< null: nothing stands besides
    };
    /// Several threads may ask for different copies.
    Flood flood(std::size_t i) const;
    /// Whether `members` (ascending) leave by that path as one. False where a move of it does not follow an axis.
    bool leads_out(const Members& members, const Path& path) const;

  private:
    /// Part of the options' grid, and where it lies in that.
    struct Plot {
        TraySetup grid;
        VoxelIndex origin;
    };
    Subassembly(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts, const Plot& plot);
    static Plot plot_around(const TraySetup& grid, const std::vector<Body>& parts);
    ObjectId place(TrayObject object);
    std::shared_ptr<const BitGrid> voxels_on_grid(std::size_t i) const;

    /// `members`, moved by `from` before, move by `way` mm more.
    struct Move {
        const Members& members;
        Vec3 from;
        AxisDirection direction;
        double way = 0;
    };
    /// Whom they would meet. Appends whom they pass.
    std::optional<Pair> meeting(const Move& move, const Hints& hints, std::vector<Pair>& passed) const;
    Box box_of(const Members& members) const;
    Box box_of_others(const Members& members) const;

    const DisassemblyOptions& options_;
    std::vector<int> names_;
    std::vector<Body> parts_;
    std::vector<Box> boxes_;
    std::vector<bool> present_;
    std::optional<std::size_t> aside_;
    BoxIndex index_;
    StandingHull hull_, voxel_hull_;
    VoxelIndex origin_;  // of the tray, in the options' grid
    Tray tray_;
    std::vector<ObjectId> objects_;
    std::unique_ptr<std::mutex> asking_ = std::make_unique<std::mutex>();  // guards the search and what follows
    mutable std::map<std::size_t, std::shared_ptr<const BitGrid>>
        on_grid_;  ///< voxels of those off the grid, once asked for
};

}  // namespace spectralpack
