#include "verify/walls.hpp"

#include <algorithm>

#include "model/physical_surfaces.hpp"
#include "spectralpack/error.hpp"
#include "verify/words.hpp"

namespace spectralpack {
namespace {

void add_box(Mesh& mesh, const Box& box) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(
            {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z});
    }
    constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : kFaces) {
        mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
        mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    }
}

const Mesh& surface_of(const StandingMesh& standing) {
    if (!standing.surface) throw InternalError(standing.file + " is part of the container, but its mesh is not there");
    return *standing.surface;
}

/// What is not in the container: a box that reaches beyond every copy, with the container as a hollow in it.
Mesh outside_of(const Mesh& container, Box all) {
    all.add(bounding_box(container));
    const Vec3 margin = all.size();
    Mesh mesh;
    add_box(mesh, {all.min - margin, all.max + margin});
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), container.vertices.begin(), container.vertices.end());
    for (const Triangle& t : container.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    }
    return mesh;
}

}  // namespace

Walls::Walls(const Packing& packing, const Box& all) : packing_(packing) {
    const Container& container = packing.container;
    const auto add = [&](std::string name, const Mesh& mesh) {
        walls_.push_back(
            {std::move(name), std::make_unique<const Solid>(mesh, Transform{}, deep_enough(kCheckTolerance))});
    };
    if (container.mesh) add("the outside of the container", outside_of(surface_of(*container.mesh), all));
    for (std::size_t i = 0; i < container.keep_out.size(); ++i) {
        const KeepOut& keep_out = container.keep_out[i];
        Mesh box;
        if (!keep_out.mesh) add_box(box, keep_out.box);
        add("keep-out " + std::to_string(i), keep_out.mesh ? surface_of(*keep_out.mesh) : box);
    }
    const auto dug = [](const TrayPacking& tray) {
        return tray.disassembly && tray.disassembly->unpack == Unpack::top;
    };
    if (!container.physical && std::ranges::none_of(packing.trays, dug)) return;
    for (const Mesh& surface : physical_surfaces(container)) {
        if (surface.triangles.empty()) continue;
        physical_.push_back(std::make_unique<const Solid>(surface, Transform{}, deep_enough(kCheckTolerance)));
    }
}

std::vector<JudgedCopy> Walls::standing() const {
    std::vector<JudgedCopy> walls;
    for (const auto& solid : physical_) {
        walls.push_back({-1, {solid.get(), Transform{}}, solid->box()});
    }
    return walls;
}

std::vector<Finding> Walls::judge(int tray, const std::vector<JudgedCopy>& copies, const Workers& workers,
                                  const StopToken& stop) const {
    std::vector<Finding> findings;
    const double wall_gap = packing_.options.wall_gap;
    for (const Wall& wall : walls_) {
        std::vector<Relation> relations(copies.size());
        workers.for_each(static_cast<std::int64_t>(copies.size()), [&](std::int64_t k) {
            if (stop.stopped()) return;
            const auto i = static_cast<std::size_t>(k);
            relations[i] = compare(copies[i].posed, {wall.solid.get(), {}}, kCheckTolerance, wall_gap);
        });
        if (stop.stopped()) return {};
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const Relation& relation = relations[i];
            const auto& placements = packing_.trays[static_cast<std::size_t>(tray)].placements;
            const std::string name = tray_prefix(packing_, tray) +
                                     copy_name(packing_, placements[static_cast<std::size_t>(copies[i].placement)]);
            const double missing = wall_gap - relation.distance;
            if (relation.kind != Relation::Kind::apart) {
                findings.push_back(
                    {FindingKind::outside,
                     tray,
                     {copies[i].placement},
                     relation.depth,
                     name + " reaches into " + wall.name + ", at least " + short_number(relation.depth) + " mm deep"});
            } else if (missing > kCheckTolerance) {
                findings.push_back({FindingKind::outside,
                                    tray,
                                    {copies[i].placement},
                                    missing,
                                    name + " is " + short_number(relation.distance) + " mm from " + wall.name + ", " +
                                        short_number(missing) + " mm less than the wall gap of " +
                                        short_number(wall_gap) + " mm"});
            }
        }
    }
    return findings;
}

}  // namespace spectralpack
