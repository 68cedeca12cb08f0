#include "tools/generate/implicit_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace spectralpack::tools {
namespace {

constexpr double kNearest = 0.05;  // of an edge

using Index = std::uint32_t;

class March {
  public:
    March(const Field& field, const Box& box, double step) : corner_(box.min), step_(step) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            count_[axis] = static_cast<Index>(std::ceil(box.size()[static_cast<int>(axis)] / step)) + 1;
        }
        values_.reserve(std::size_t{count_[0]} * count_[1] * count_[2]);
        for (Index z = 0; z < count_[2]; ++z) {
            for (Index y = 0; y < count_[1]; ++y) {
                for (Index x = 0; x < count_[0]; ++x) {
                    values_.push_back(field(place(point(x, y, z))));
                }
            }
        }
    }

    Mesh mesh() && {
        // Each order of the axes is a way from a cube's lowest corner to its highest, and a tetrahedron.
        constexpr std::array<std::array<int, 3>, 6> kWays{
            {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
        const std::array<Index, 3> stride{1, count_[0], count_[0] * count_[1]};
        for (Index z = 0; z + 1 < count_[2]; ++z) {
            for (Index y = 0; y + 1 < count_[1]; ++y) {
                for (Index x = 0; x + 1 < count_[0]; ++x) {
                    for (const auto& way : kWays) {
                        std::array<Index, 4> corners{point(x, y, z), 0, 0, 0};
                        for (std::size_t i = 0; i < 3; ++i) {
                            corners[i + 1] = corners[i] + stride[static_cast<std::size_t>(way[i])];
                        }
                        march(corners);
                    }
                }
            }
        }
        return std::move(mesh_);
    }

  private:
    Index point(Index x, Index y, Index z) const { return x + count_[0] * (y + count_[1] * z); }

    Vec3 place(Index point) const {
        const Index x = point % count_[0], y = point / count_[0] % count_[1], z = point / count_[0] / count_[1];
        return corner_ + step_ * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }

    bool inside(Index point) const { return values_[point] < 0; }

    Index crossing(Index a, Index b) {
        if (a > b) std::swap(a, b);
        const auto [entry, is_new] =
            vertices_.try_emplace(std::uint64_t{a} << 32 | b, static_cast<Index>(mesh_.vertices.size()));
        if (is_new) {
            const double share = std::clamp(values_[a] / (values_[a] - values_[b]), kNearest, 1 - kNearest);
            mesh_.vertices.push_back(place(a) + share * (place(b) - place(a)));
        }
        return entry->second;
    }

    /// A triangle that faces along `out`.
    void add(Index a, Index b, Index c, const Vec3& out) {
        const std::vector<Vec3>& v = mesh_.vertices;
        if (dot(cross(v[b] - v[a], v[c] - v[a]), out) < 0) std::swap(b, c);
        mesh_.triangles.push_back({a, b, c});
    }

    void march(std::array<Index, 4> corners) {
        const auto end = std::stable_partition(corners.begin(), corners.end(), [&](Index p) { return inside(p); });
        const auto in = end - corners.begin();
        const auto [a, b, c, d] = corners;
        if (in == 1) {
            add(crossing(a, b), crossing(a, c), crossing(a, d), place(b) + place(c) + place(d) - 3 * place(a));
        } else if (in == 3) {
            add(crossing(a, d), crossing(b, d), crossing(c, d), 3 * place(d) - place(a) - place(b) - place(c));
        } else if (in == 2) {
            const Vec3 out = place(c) + place(d) - place(a) - place(b);
            const Index ac = crossing(a, c), ad = crossing(a, d), bd = crossing(b, d), bc = crossing(b, c);
            add(ac, ad, bd, out);
            add(ac, bd, bc, out);
        }
    }

    Vec3 corner_;
    double step_;
    std::array<Index, 3> count_{};
    std::vector<double> values_;
    std::unordered_map<std::uint64_t, Index> vertices_;
    Mesh mesh_;
};

}  // namespace

Mesh surface_of(const Field& field, const Box& box, double step) { return March(field, box, step).mesh(); }

}  // namespace spectralpack::tools
