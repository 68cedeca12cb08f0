#include "geometry/mesh_repair.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/stopped.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_shells.hpp"
#include "geometry/mesh_weld.hpp"

namespace spectralpack {
namespace {

/// Relative to a length: less than this is nothing. Generous beside the rounding of single
/// precision files (6e-8).
constexpr double kFlatMesh = 1e-6;
/// Corners that belong together but were rounded apart, for example by transforms or by text with
/// few digits.
constexpr double kCrack = 1e-5;
/// |volume| / (area * diagonal) of a closed mesh that encloses nothing; a sheet of 1e-6 of its size
/// has 5e-7.
constexpr double kHollow = 1e-9;
/// |normal| / (longest edge)^2 of a facet without area.
constexpr double kZeroArea = 1e-12;
/// Beyond this, volumes and products of coordinates leave what a double holds.
constexpr double kLargestCoordinate = 1e30;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string shown(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4);
    return {text, end.ptr};
}

double largest_coordinate(const Box& box) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(box.min[axis]), std::abs(box.max[axis])});
    }
    return largest;
}

/// Normal of the length of twice the facet's area.
Vec3 normal_of(const Mesh& mesh, const Triangle& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
}

bool has_area(const Mesh& mesh, const Triangle& t, const Vec3& normal) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double longest = std::max({dot(ab, ab), dot(bc, bc), dot(ca, ca)});
    return dot(normal, normal) > kZeroArea * kZeroArea * longest * longest;
}

bool has_area(const Mesh& mesh, const Triangle& t) { return has_area(mesh, t, normal_of(mesh, t)); }

/// All vertices within kFlatMesh of one plane: that of the largest facet.
bool is_planar(const Mesh& mesh, double size) {
    Vec3 normal, origin;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 candidate = normal_of(mesh, t);
        if (dot(candidate, candidate) > dot(normal, normal)) {
            normal = candidate;
            origin = mesh.vertices[t[0]];
        }
    }
    const double scale = length(normal);
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& vertex) {
        return std::abs(dot(vertex - origin, normal)) <= kFlatMesh * size * scale;
    });
}

class Repairer {
  public:
    Repairer(Mesh& mesh, bool welded, const StopToken& stop) : mesh_(mesh), welded_(welded), stop_(stop) {}

    MeshRepair run() {
        if (weld() && check_extent() && drop_flat_facets()) {
            find_edges();
            if (count_.crowded > 0) drop_duplicates();
            if (!count_.closed && close_cracks() && count_.crowded > 0) drop_duplicates();
            if (!count_.closed && count_.misdirected > 0) orient();
            if (facets_dropped_) drop_unused_vertices();
            result_.closed = count_.closed;
            if (count_.closed ? finish_closed() : finish_open()) describe_edges();
        }
        return std::move(result_);
    }

  private:
    bool unusable(const std::string& why) {
        result_.unusable = why;
        return false;
    }

    void find_edges() {
        edges_.emplace(mesh_, stop_);
        count_ = count_edges(*edges_);
    }

    /// Step 1.
    bool weld() {
        if (mesh_.triangles.empty()) {
            return unusable("there are no triangles");
        }
        if (welded_) return true;
        const std::size_t merged = weld_equal_vertices(mesh_, stop_);
        if (merged > 0) {
            result_.repairs.push_back("merged " + counted(merged, "vertex", "vertices") +
                                      " with the coordinates of another");
        }
        return true;
    }

    bool check_extent() {
        StopPoll poll(stop_);
        for (const Vec3& vertex : mesh_.vertices) {
            poll.step();
            result_.box.add(vertex);
        }
        const Vec3 extent = result_.box.size();
        const double coordinate = largest_coordinate(result_.box);
        size_ = std::max({extent.x, extent.y, extent.z});
        tolerance_ = std::max(kCrack * size_, 0x1p-22 * coordinate);
        if (coordinate > kLargestCoordinate) {
            return unusable("coordinates of " + shown(coordinate) + " are beyond what can be computed with");
        }
        const std::string hint = size_ < 0x1p-20 * coordinate ? " (at coordinates near " + shown(coordinate) +
                                                                    " single precision cannot hold its shape)"
                                                              : "";
        for (int axis = 0; axis < 3; ++axis) {
            if (extent[axis] > 1e-9 * size_) continue;
            return unusable(std::string("it is flat: it has no extent along ") + "xyz"[axis] + hint);
        }
        return true;
    }

    void drop_unused_vertices() {
        weld_equal_vertices(mesh_, stop_);
        result_.box = bounding_box(mesh_);
        find_edges();
    }

    /// Step 2. Facets with two equal corners add nothing to the oriented boundary; a sliver between
    /// three vertices in a line may be what joins its neighbours.
    bool drop_flat_facets() {
        std::size_t flat = 0;
        StopPoll poll(stop_);
        for (const Triangle& t : mesh_.triangles) {
            poll.step();
            const Vec3 normal = normal_of(mesh_, t);
            flat += has_area(mesh_, t, normal) ? 0 : 1;
            area_ += length(normal) / 2;
        }
        if (flat == 0) return true;
        if (flat == mesh_.triangles.size()) return unusable("every facet has zero area");
        Mesh smaller = mesh_;
        std::erase_if(smaller.triangles, [&](const Triangle& t) {
            poll.step();
            return !has_area(mesh_, t);
        });
        if (opens(smaller)) {
            smaller = mesh_;
            flat = std::erase_if(smaller.triangles,
                                 [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
        }
        if (flat == 0) return true;
        mesh_ = std::move(smaller);
        facets_dropped_ = true;
        result_.repairs.push_back("dropped " + counted(flat, "facet", "facets") + " of zero area");
        return true;
    }

    /// Whether replacing the mesh by `other` would lose its closedness.
    bool opens(const Mesh& other) const { return !is_closed(other, stop_) && is_closed(mesh_, stop_); }

    /// Step 3. Only facets at crowded edges can be there twice.
    void drop_duplicates() {
        std::vector<std::pair<Triangle, std::uint32_t>> keys;  // least corner first, then the facet's index
        std::vector<bool> listed(mesh_.triangles.size());
        edges_->for_each([&](std::uint32_t, std::span<const MeshEdges::Use> uses) {
            if (uses.size() <= 2) return;
            for (const MeshEdges::Use& use : uses) {
                if (listed[use.triangle()]) continue;
                listed[use.triangle()] = true;
                Triangle key = mesh_.triangles[use.triangle()];
                std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
                keys.emplace_back(key, use.triangle());
            }
        });
        std::sort(keys.begin(), keys.end());
        std::vector<bool> copy(mesh_.triangles.size());
        std::size_t copies = 0;
        for (std::size_t i = 1; i < keys.size(); ++i) {
            if (keys[i].first != keys[i - 1].first) continue;
            copy[keys[i].second] = true;
            ++copies;
        }
        if (copies == 0) return;
        Mesh smaller{mesh_.vertices, {}};
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (!copy[i]) smaller.triangles.push_back(mesh_.triangles[i]);
        }
        if (opens(smaller)) return;  // two solids that share a wall
        mesh_ = std::move(smaller);
        facets_dropped_ = true;
        find_edges();
        result_.repairs.push_back("dropped " + counted(copies, "facet", "facets") + " stored twice");
    }

    /// Step 4.
    bool close_cracks() {
        std::vector<bool> at_border(mesh_.vertices.size());
        edges_->for_each([&](std::uint32_t low, std::span<const MeshEdges::Use> uses) {
            if (uses.size() % 2 != 0) at_border[low] = at_border[uses.front().high] = true;
        });
        std::vector<std::uint32_t> candidates;
        for (std::size_t i = 0; i < at_border.size(); ++i) {
            if (at_border[i]) candidates.push_back(static_cast<std::uint32_t>(i));
        }
        Mesh closer = mesh_;
        const std::size_t merged = weld_near_vertices(closer, candidates, tolerance_);
        if (merged == 0) return false;
        std::erase_if(closer.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
        if (closer.triangles.empty() || count_edges(MeshEdges(closer, stop_)).border >= count_.border) {
            return false;
        }
        mesh_ = std::move(closer);
        facets_dropped_ = true;
        find_edges();
        result_.repairs.push_back("merged " + counted(merged, "border vertex", "border vertices") + " less than " +
                                  shown(tolerance_) + " from another");
        return true;
    }

    /// Step 5.
    void orient() {
        Mesh oriented = mesh_;
        const std::size_t turned = orient_consistently(oriented, *edges_);
        if (turned == 0 || !is_closed(oriented, stop_)) return;
        mesh_ = std::move(oriented);
        find_edges();
        result_.repairs.push_back("turned " + counted(turned, "facet that faced", "facets that faced") +
                                  " the wrong way");
    }

    /// Step 6 for a closed mesh. A group of shells may cancel another that is inside out, so each
    /// is judged by itself.
    bool finish_closed() {
        const ShellGroups groups = shell_groups(mesh_, *edges_);
        throw_if_stopped(stop_);
        const double nothing = kHollow * area_ * length(result_.box.size());
        if (std::all_of(groups.volume.begin(), groups.volume.end(),
                        [&](double volume) { return std::abs(volume) <= nothing; })) {
            return unusable("its volume is zero: its facets lie back to back");
        }
        const std::size_t turned = turn_outwards(mesh_, groups);
        if (turned == mesh_.triangles.size()) {
            result_.repairs.push_back("turned the mesh, which was inside out");
        } else if (turned > 0) {
            result_.repairs.push_back("turned shells that were inside out (" + counted(turned, "facet", "facets") +
                                      ")");
        }
        if (shells_overlap(mesh_, groups)) {
            result_.warnings.push_back({"has bodies that overlap; what they share counts twice in its volume",
                                        "have bodies that overlap; what they share counts twice in their volume"});
        }
        return true;
    }

    bool finish_open() {
        throw_if_stopped(stop_);
        if (is_planar(mesh_, size_)) return unusable("it is flat: all facets lie in one plane");
        if (signed_volume(mesh_) < 0) {
            mesh_ = inside_out(std::move(mesh_));
            result_.repairs.push_back("turned the open mesh, whose facets faced inwards");
        }
        const std::string why = count_.border > 0 ? counted(count_.border, "border edge", "border edges")
                                                  : "neighbouring facets face opposite ways";
        result_.warnings.push_back({"is not closed (" + why + "); its surface is packed, as if it were hollow",
                                    "are not closed; their surfaces are packed, as if they were hollow"});
        return true;
    }

    void describe_edges() {
        if (count_.crowded == 0) return;
        result_.warnings.push_back(
            {"has " + counted(count_.crowded, "edge that is", "edges that are") + " shared by more than two facets",
             "have edges that are shared by more than two facets"});
    }

    Mesh& mesh_;
    bool welded_;
    const StopToken& stop_;
    bool facets_dropped_ = false;
    MeshRepair result_;
    std::optional<MeshEdges> edges_;  ///< of mesh_ as it is, once found
    EdgeCount count_;
    double size_ = 0;
    double area_ = 0;
    double tolerance_ = 0;
};

}  // namespace

MeshRepair repair_mesh(Mesh& mesh, bool welded, const StopToken& stop) { return Repairer(mesh, welded, stop).run(); }

std::optional<Remark> size_warning(const Box& box, double mm_per_unit) {
    constexpr double kInch = 25.4, kMetre = 1000;
    const Vec3 extent = box.size();
    const double units = std::max({extent.x, extent.y, extent.z}), longest = mm_per_unit * units;
    const std::string stands = "is " + shown(longest) + " mm long as it stands. ";
    if (longest < 3) {
        const std::string inches = mm_per_unit < kInch ? "In inches it would be " + shown(kInch * units) + " mm, " : "";
        return Remark{stands + inches + (inches.empty() ? "In metres it would be " : "in metres ") +
                          shown(kMetre * units) + " mm: name its unit with --unit, or in a set file's column unit",
                      "are under 3 mm long as they stand. If they are in inches or metres, name the unit with --unit, "
                      "or in a set file's column unit"};
    }
    if (longest > 10'000) {
        const bool micrometres = units / kMetre < 10'000;
        return Remark{stands + (micrometres ? "In micrometres it would be " + shown(units / kMetre) +
                                                  " mm: name it with a scale, like FILE@0.001"
                                            : "Is its unit right?"),
                      "are over 10 m long as they stand. If they are in micrometres, name them with a scale, like "
                      "FILE@0.001"};
    }
    return std::nullopt;
}

}  // namespace spectralpack
