#include "geometry/vessel.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace spectralpack {
namespace {

constexpr double kLeastDepth = 0.05;    // of the mesh's height
constexpr std::size_t kMostTried = 64;  // surfaces that are measured, the deepest first

class Sets {
  public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    /// The set of `into` is named by the same from now on.
    void unite(std::uint32_t into, std::uint32_t other) { parent_[other] = into; }

  private:
    std::vector<std::uint32_t> parent_;
};

/// A surface that hangs together below a height: that with `lowest` in it.
struct Basin {
    std::uint32_t lowest = 0;  // vertex
    double brim = 0;           // infinite: it ends below
    double depth = 0;
};

/// For each vertex, those that it shares an edge with, one after the other.
struct Neighbours {
    explicit Neighbours(const Mesh& mesh) : first(mesh.vertices.size() + 1, 0) {
        for (const Triangle& t : mesh.triangles) {
            for (const std::uint32_t v : t) {
                first[v + 1] += 2;
            }
        }
        std::partial_sum(first.begin(), first.end(), first.begin());
        all.resize(first.back());
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                all[next[t[i]]++] = t[(i + 1) % 3];
                all[next[t[i]]++] = t[(i + 2) % 3];
            }
        }
    }

    std::vector<std::size_t> first;
    std::vector<std::uint32_t> all;
};

/// Vertices from the lowest up join what they are next to. Where two surfaces come together, either may be a basin that
/// is full then.
std::vector<Basin> basins(const Mesh& mesh, const Neighbours& neighbours) {
    const auto height = [&](std::uint32_t v) { return mesh.vertices[v].z; };
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        if (neighbours.first[v] < neighbours.first[v + 1]) order.push_back(v);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t v) { return std::pair(height(v), v); });
    if (order.empty()) return {};
    const double least = kLeastDepth * (height(order.back()) - height(order.front()));
    std::vector<Basin> found;
    Sets sets(mesh.vertices.size());
    std::vector<bool> reached(mesh.vertices.size(), false);
    for (const std::uint32_t v : order) {
        reached[v] = true;
        for (std::size_t k = neighbours.first[v]; k < neighbours.first[v + 1]; ++k) {
            if (!reached[neighbours.all[k]]) continue;
            // A set is named by its lowest vertex.
            std::uint32_t a = sets.find(v), b = sets.find(neighbours.all[k]);
            if (a == b) continue;
            if (std::pair(height(b), b) < std::pair(height(a), a)) std::swap(a, b);
            if (height(v) - height(b) >= least) {
                found.push_back({a, height(v), height(v) - height(a)});
                found.push_back({b, height(v), height(v) - height(b)});
            }
            sets.unite(a, b);
        }
    }
    for (const std::uint32_t v : order) {
        if (sets.find(v) == v) found.push_back({v, Box::kInfinity, height(order.back()) - height(v)});
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Basin::depth);
    if (found.size() > kMostTried) found.resize(kMostTried);
    return found;
}

/// The surface of a basin below its brim, cut there and closed by a flat lid; it faces the way it did.
class Cut {
  public:
    Cut(const Mesh& mesh, const Neighbours& neighbours, const Basin& basin) : mesh_(mesh), brim_(basin.brim) {
        std::vector<bool> inside(mesh.vertices.size(), false);
        std::vector<std::uint32_t> next{basin.lowest};
        inside[basin.lowest] = true;
        while (!next.empty()) {
            const std::uint32_t v = next.back();
            next.pop_back();
            for (std::size_t k = neighbours.first[v]; k < neighbours.first[v + 1]; ++k) {
                const std::uint32_t w = neighbours.all[k];
                if (inside[w] || !(mesh.vertices[w].z < brim_)) continue;
                inside[w] = true;
                next.push_back(w);
            }
        }
        for (const Triangle& t : mesh.triangles) {
            if (inside[t[0]] || inside[t[1]] || inside[t[2]]) add(t);
        }
        close();
    }

    bool open() const { return open_; }
    Mesh take() { return std::move(cut_); }

  private:
    bool below(std::uint32_t v) const { return mesh_.vertices[v].z < brim_; }

    std::uint32_t kept(std::uint32_t v) {
        const auto [entry, fresh] = kept_.try_emplace(v, static_cast<std::uint32_t>(cut_.vertices.size()));
        if (fresh) cut_.vertices.push_back(mesh_.vertices[v]);
        return entry->second;
    }

    /// Where the edge from `low` to `high` reaches the brim.
    std::uint32_t at_brim(std::uint32_t low, std::uint32_t high) {
        const Vec3 &a = mesh_.vertices[low], &b = mesh_.vertices[high];
        if (b.z == brim_) return kept(high);
        const auto [entry, fresh] =
            crossings_.try_emplace(std::pair(low, high), static_cast<std::uint32_t>(cut_.vertices.size()));
        if (fresh) {
            Vec3 point = a + (brim_ - a.z) / (b.z - a.z) * (b - a);
            point.z = brim_;
            cut_.vertices.push_back(point);
        }
        return entry->second;
    }

    /// What of the triangle is below; its edge along the brim is one of the lid.
    void add(const Triangle& t) {
        std::vector<std::uint32_t> corners;
        std::uint32_t up = 0, down = 0;
        bool cut = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (below(a)) corners.push_back(kept(a));
            if (below(a) == below(b)) continue;
            const std::uint32_t point = below(a) ? at_brim(a, b) : at_brim(b, a);
            corners.push_back(point);
            (below(a) ? up : down) = point;
            cut = true;
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
            if (corners[i] != corners[i - 1] && corners[i] != corners[0]) {
                cut_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
            }
        }
        if (cut && up != down) brim_edges_.emplace_back(up, down);
    }

    /// A fan over each loop at the brim. Its triangles may lie on one another where the loop is not convex: what they
    /// are worth together is what is within.
    void close() {
        open_ = !brim_edges_.empty();
        std::multimap<std::uint32_t, std::uint32_t> next(brim_edges_.begin(), brim_edges_.end());
        while (!next.empty()) {
            std::vector<std::uint32_t> loop;
            for (auto edge = next.begin(); edge != next.end(); edge = next.find(loop.back())) {
                if (loop.empty()) loop.push_back(edge->first);
                loop.push_back(edge->second);
                next.erase(edge);
            }
            Vec3 middle;
            for (std::size_t i = 1; i < loop.size(); ++i) {
                middle = middle + cut_.vertices[loop[i]];
            }
            middle = 1 / static_cast<double>(loop.size() - 1) * middle;
            middle.z = brim_;
            const auto centre = static_cast<std::uint32_t>(cut_.vertices.size());
            cut_.vertices.push_back(middle);
            for (std::size_t i = 1; i < loop.size(); ++i) {
                // Against the surface's own edge, which runs from loop[i - 1] to loop[i].
                cut_.triangles.push_back({loop[i], loop[i - 1], centre});
            }
        }
    }

    const Mesh& mesh_;
    double brim_;
    Mesh cut_;
    std::map<std::uint32_t, std::uint32_t> kept_;  // vertices of the mesh
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> brim_edges_;
    bool open_ = false;
};

}  // namespace

std::optional<Cavity> largest_cavity(const Mesh& mesh) {
    const Neighbours neighbours(mesh);
    std::optional<Cavity> largest;
    for (const Basin& basin : basins(mesh, neighbours)) {
        Cut cut(mesh, neighbours, basin);
        Mesh surface = cut.take();
        const double volume = -signed_volume(surface);  // of what it bounds that is not the mesh
        if (!(volume > (largest ? largest->volume : 0))) continue;
        const double top = bounding_box(surface).max.z;
        largest = {inside_out(std::move(surface)), volume, top, cut.open()};
    }
    return largest;
}

}  // namespace spectralpack
