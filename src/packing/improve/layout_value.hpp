#pragma once
/// How good a layout on the grid is beside others of the same copies, in other orders.

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "packing/improve/prefix_packing.hpp"

namespace spectralpack {

/// Less is better, lexicographically.
struct LayoutValue {
    double missing = 0;    ///< worth of the copies that found no place
    std::int64_t top = 0;  ///< layers that the layout reaches into
    double crowd = 0;      ///< mm: by how much its copies reach into the upper fifth, summed

    auto operator<=>(const LayoutValue&) const = default;
};

class LayoutJudge {
  public:
    struct Measures {
        std::function<double(int part)> worth;
        std::function<double(const PlacedCopy&)> top;  ///< mm
        double voxel_size = 1, wall_gap = 0;           ///< mm
    };

    LayoutJudge(const std::vector<Copy>& copies, Measures measures);

    LayoutValue value(const std::vector<PackedStep>& steps) const;
    /// True once no way to go on from `steps` comes to a value as good as `limit`.
    bool exceeds(const std::vector<PackedStep>& steps, const LayoutValue& limit) const;

    double top(const PlacedCopy& placed) const { return measures_.top(placed); }
    double worth(int part) const { return measures_.worth(part); }

  private:
    double missing(const std::vector<PackedStep>& steps) const;
    std::int64_t layers(double top) const;

    Measures measures_;
    std::map<int, int> counts_;  // by part
};

}  // namespace spectralpack
