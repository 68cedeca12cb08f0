#include "voxel/winding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "voxel/bit_rows.hpp"

namespace spectralpack {
namespace {

/// Least i >= 0 with i + 0.5 >= value.
int first_centre(double value) {
    return value <= 0.5 ? 0 : static_cast<int>(std::ceil(value - 0.5));
}

/// The value at `at` of the line through (a, from) and (b, to), a <= at < b; never outside
/// from..to.
double between(double a, double from, double b, double to, double at) {
    const double value = from + (to - from) * ((at - a) / (b - a));
    return std::clamp(value, std::min(from, to), std::max(from, to));
}

}  // namespace

void Crossings::add(const GridTriangle& triangle) {
    const auto [least, most] = std::minmax({triangle[0].z, triangle[1].z, triangle[2].z});
    for (int z = first_centre(least); z < extent_.z && z + 0.5 < most; ++z) {
        add_layer(triangle, z);
    }
}

void Crossings::add_layer(const GridTriangle& triangle, int z) {
    const double height = z + 0.5;
    // One edge leads up through the plane, one leads down.
    double up_x = 0, up_y = 0, down_x = 0, down_y = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = triangle[i], &to = triangle[i == 2 ? 0 : i + 1];
        if (from.z <= height && height < to.z) {
            up_x = between(from.z, from.x, to.z, to.x, height);
            up_y = between(from.z, from.y, to.z, to.y, height);
        } else if (to.z <= height && height < from.z) {
            down_x = between(to.z, to.x, from.z, from.x, height);
            down_y = between(to.z, to.y, from.z, from.y, height);
        }
    }
    const int sign = up_y > down_y ? 1 : -1;
    const auto [low_x, low_y] = sign > 0 ? std::pair(down_x, down_y) : std::pair(up_x, up_y);
    const auto [high_x, high_y] = sign > 0 ? std::pair(up_x, up_y) : std::pair(down_x, down_y);
    for (int y = first_centre(low_y); y < extent_.y && y + 0.5 < high_y; ++y) {
        const int x = first_centre(between(low_y, low_x, high_y, high_x, y + 0.5));
        if (x < extent_.x) crossings_.push_back({std::int64_t{z} * extent_.y + y, x, sign});
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
        BitGrid::Word* words =
            grid.words().data() + row * static_cast<std::size_t>(grid.words_per_row());
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
