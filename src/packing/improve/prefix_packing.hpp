#pragma once
/// A tray packed greedily, of which the last copies can be taken back: packing in an order that begins like the last
/// one goes on from where they part. That is what makes trying thousands of orders cheap.
///
///     packed in      a b c d e f
///     wanted         a b e c d f      undo f e d c, keep a b, search for e c d f

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "packing/job/started_tray.hpp"

namespace spectralpack {

/// A copy in its turn, and where it stands; none: it found no place.
struct PackedStep {
    Copy copy;
    std::optional<PlacedCopy> placed;
};

class PrefixPacking {
  public:
    using ShapeOf = std::function<const Shape&(int part)>;
    /// Asked after each copy: whether the packing cannot be of use any more.
    using IsHopeless = std::function<bool(const std::vector<PackedStep>& steps)>;

    enum class Outcome { packed, hopeless, stopped };

    /// `started`, in which copies stand on the grid, outlives it. Shapes stay where they are.
    PrefixPacking(StartedTray& started, ShapeOf shape_of, const StopToken& stop);

    /// Packs `order` as pack_greedily() would in a new tray. As far as it begins like `known`, which this or another
    /// PrefixPacking of the same job packed, copies stand where they stood there, without a search; those that stand so
    /// already are not touched. Copies of one part count as alike.
    Outcome pack(const std::vector<Copy>& order, const std::vector<PackedStep>& known, const IsHopeless& is_hopeless);

    /// What the last pack() came to, as far as it went.
    const std::vector<PackedStep>& steps() const { return steps_; }
    std::int64_t searches() const { return searches_; }

  private:
    void undo_to(std::size_t count);
    void stand(const PlacedCopy& placed);
    void renew();

    StartedTray& started_;
    ShapeOf shape_of_;
    TrayContext context_;
    std::vector<PackedStep> steps_;
    /// By part, steps that found no place: the tray only fills up, so none of the part's finds one later.
    std::map<int, int> failed_;
    std::int64_t searches_ = 0;
};

/// Those of the steps that stand.
std::vector<PlacedCopy> placed_of(const std::vector<PackedStep>& steps);

}  // namespace spectralpack
