#include "voxel/winding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "voxel/bit_rows.hpp"

namespace spectralpack {
namespace {

/// Least i >= 0 with i + 0.5 >= value.
int first_centre(double value) { return value <= 0.5 ? 0 : static_cast<int>(std::ceil(value - 0.5)); }

/// The value a share of the way along; never beyond the ends, whatever the rounding.
double between(double from, double to, double share) {
    return std::clamp(from + (to - from) * share, std::min(from, to), std::max(from, to));
}

}  // namespace

/// An edge, lower end first, and where it passes a height low.z <= z < high.z.
class Crossings::Edge {
  public:
    Edge(const Vec3& low, const Vec3& high) : low_(low), high_(high), per_z_(1 / (high.z - low.z)) {}

    double x_at(double z) const { return between(low_.x, high_.x, (z - low_.z) * per_z_); }
    double y_at(double z) const { return between(low_.y, high_.y, (z - low_.z) * per_z_); }

  private:
    Vec3 low_, high_;
    double per_z_;
};

void Crossings::add(const GridTriangle& triangle) {
    const auto [least_y, most_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    if (first_centre(least_y) + 0.5 >= most_y) return;

    // Corners by height, and whether that order is the triangle's own way round.
    std::size_t low = 0, middle = 1, high = 2;
    bool forward = true;
    const auto order = [&](std::size_t& a, std::size_t& b) {
        if (triangle[a].z <= triangle[b].z) return;
        std::swap(a, b);
        forward = !forward;
    };
    order(low, middle);
    order(middle, high);
    order(low, middle);

    const Edge whole(triangle[low], triangle[high]);
    int z = first_centre(triangle[low].z);
    for (const auto& [from, to] : {std::pair(low, middle), std::pair(middle, high)}) {
        const double top = triangle[to].z;
        if (z >= extent_.z || z + 0.5 >= top) continue;
        const Edge side(triangle[from], triangle[to]);
        for (; z < extent_.z && z + 0.5 < top; ++z) {
            // The edges that lead up through the plane and down again.
            add_chord(forward ? side : whole, forward ? whole : side, z);
        }
    }
}

void Crossings::add_chord(const Edge& up, const Edge& down, int z) {
    const double height = z + 0.5;
    const double up_y = up.y_at(height), down_y = down.y_at(height);
    const bool positive = up_y > down_y;
    const double low_y = positive ? down_y : up_y, high_y = positive ? up_y : down_y;
    int y = first_centre(low_y);
    if (y >= extent_.y || y + 0.5 >= high_y) return;
    const double low_x = (positive ? down : up).x_at(height), high_x = (positive ? up : down).x_at(height);
    const double per_y = 1 / (high_y - low_y);
    for (; y < extent_.y && y + 0.5 < high_y; ++y) {
        const int x = first_centre(between(low_x, high_x, (y + 0.5 - low_y) * per_y));
        if (x < extent_.x) {
            crossings_.push_back({std::int64_t{z} * extent_.y + y, x, positive ? 1 : -1});
        }
    }
}

void Crossings::append(Crossings other) {
    if (crossings_.empty()) {
        crossings_ = std::move(other.crossings_);
    } else {
        crossings_.insert(crossings_.end(), other.crossings_.begin(), other.crossings_.end());
    }
}

void Crossings::set_wound(BitGrid& grid) const {
    // Sorted by row (counting sort), then by x within the few of a row.
    std::vector<std::size_t> begin(static_cast<std::size_t>(extent_.y) * extent_.z + 1);
    for (const Crossing& crossing : crossings_) {
        ++begin[static_cast<std::size_t>(crossing.row)];
    }
    std::size_t total = 0;
    for (std::size_t& count : begin) {
        count = total += count;
    }
    std::vector<std::pair<int, int>> sorted(total);  // x, sign
    for (const Crossing& crossing : crossings_) {
        sorted[--begin[static_cast<std::size_t>(crossing.row)]] = {crossing.x, crossing.sign};
    }
    for (std::size_t row = 0; row + 1 < begin.size(); ++row) {
        const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(begin[row]);
        const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(begin[row + 1]);
        std::sort(first, last);
        BitGrid::Word* words = grid.words().data() + row * static_cast<std::size_t>(grid.words_per_row());
        int winding = 0;
        for (auto crossing = first; crossing != last; ++crossing) {
            winding += crossing->second;
            const int end = crossing + 1 == last ? extent_.x : crossing[1].first;
            if (winding == 0 || end == crossing->first) continue;
            for_run_words(words, crossing->first, end - 1,
                          [](BitGrid::Word& word, BitGrid::Word bits) { word |= bits; });
        }
    }
}

}  // namespace spectralpack
