#pragma once
/// Scenes of copies made in code, and a plan's replay on their meshes: small steps and plain crossing tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/random.hpp"
#include "disassembly/disassembler.hpp"
#include "geometry/mesh_distance.hpp"
#include "search/cpu/cpu_search.hpp"
#include "support/shapes.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack::test {

inline Mesh placed(const Mesh& mesh, const Vec3& offset) { return transformed(mesh, {Mat3{}, offset}); }

/// Axes exchanged: z becomes `axis`.
inline Mesh lying(const Mesh& mesh, int axis) {
    Mat3 turn;
    if (axis == 0) turn.rows = {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
    if (axis == 1) turn.rows = {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}};
    return transformed(mesh, {turn, {}});
}

/// An axis-parallel ring of square section around z: outer box from the origin to (size, size, height).
inline Mesh frame_mesh(double size, double width, double height) {
    Mesh mesh = box_mesh({0, 0, 0}, {size, width, height});
    mesh = merged(mesh, box_mesh({0, size - width, 0}, {size, size, height}));
    mesh = merged(mesh, box_mesh({0, 0, 0}, {width, size, height}));
    return merged(mesh, box_mesh({size - width, 0, 0}, {size, size, height}));
}

/// A closed box with walls, its lid included unless `open`.
inline Mesh chest_mesh(double size, double wall, bool open) {
    Mesh mesh = frame_mesh(size, wall, size);
    mesh = merged(mesh, box_mesh({0, 0, 0}, {size, size, wall}));
    return open ? mesh : merged(mesh, box_mesh({0, 0, size - wall}, {size, size, size}));
}

/// A C open towards +x, in the plane of x and z.
inline Mesh hook_mesh() {
    Mesh mesh = box_mesh({0, 0, 0}, {12, 4, 3});
    mesh = merged(mesh, box_mesh({0, 0, 0}, {3, 4, 12}));
    mesh = merged(mesh, box_mesh({0, 0, 9}, {12, 4, 12}));
    return merged(mesh, box_mesh({9, 0, 7}, {12, 4, 12}));
}

class AssemblyScene {
  public:
    explicit AssemblyScene(const Vec3& size, double voxel = 1) {
        setup_.grid.size = size;
        setup_.grid.voxel_size = voxel;
        setup_.ray_spacing = voxel / 2;
        search_ = make_cpu_search({}, setup_.workers);
        setup_.search = search_.get();
        setup_.on_grid = [this](int i) {
            return std::make_shared<const BitGrid>(
                voxelize(meshes_[static_cast<std::size_t>(i)], setup_.grid.voxel_size, setup_.workers));
        };
    }

    /// `mesh` where it stands. Returns its index.
    int add(Mesh mesh, bool fixed = false) {
        const Box box = bounding_box(mesh);
        StandingVoxels voxels = voxelize_at(mesh, box.min, setup_.grid.voxel_size, setup_.workers);
        parts_.push_back({std::make_shared<const Bvh>(mesh),
                          {},
                          {std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, 0, fixed}});
        meshes_.push_back(std::move(mesh));
        return static_cast<int>(parts_.size()) - 1;
    }

    const DisassemblyOptions& setup() const { return setup_; }
    DisassemblyOptions& setup() { return setup_; }
    const std::vector<Body>& parts() const { return parts_; }

    struct Answer {
        std::vector<RemovalStep> steps;
        std::vector<std::vector<int>> stuck;
        InterlockCounts counts;
        std::vector<int> through_walls = {};
        std::optional<std::size_t> walls = {};  ///< that gave way in those steps

        bool complete() const { return stuck.empty(); }
    };
    Answer disassemble(const std::vector<RemovalStep>* told = nullptr) const { return disassemble({.told = told}); }
    Answer disassemble(const Disassembler::Rules& rules) const {
        Disassembler disassembler(
            setup_, parts_, [](int, int) {}, rules);
        disassembler.run();
        return {disassembler.steps(), disassembler.stuck(), disassembler.counts(), disassembler.through_walls(),
                rules.walls};
    }

    /// Replays the steps: exactly where meshes are made of boxes, else in moves of at most `step` mm. Fails where a
    /// copy comes to overlap another, where a path does not end outside, or where a copy has not one step of its own.
    void replay(const Answer& answer, double step = 0.1) const {
        std::vector<int> subassembly(parts_.size(), 0), single(parts_.size(), 0);
        int subassemblies = 1;
        for (std::size_t k = 0; k < answer.steps.size(); ++k) {
            const RemovalStep& removal = answer.steps[k];
            const bool through = std::ranges::count(answer.through_walls, static_cast<int>(k)) > 0;
            ASSERT_FALSE(removal.placements.empty());
            const int own = subassembly[static_cast<std::size_t>(removal.placements.front())];
            std::vector<std::size_t> others;
            Box rest;
            for (std::size_t i = 0; i < parts_.size(); ++i) {
                const bool moves =
                    std::ranges::find(removal.placements, static_cast<int>(i)) != removal.placements.end();
                if (moves) {
                    ASSERT_EQ(subassembly[i], own);
                }
                if (moves || subassembly[i] != own || (through && i == answer.walls)) continue;
                others.push_back(i);
                rest.add(parts_[i].box());
            }
            Vec3 at;
            Box box;
            for (const int i : removal.placements) {
                const Body& part = parts_[static_cast<std::size_t>(i)];
                ASSERT_FALSE(part.object.fixed);
                box.add(part.box());
                Vec3 from;
                for (const Vec3& move : removal.path) {
                    for (const std::size_t other : others) {
                        ASSERT_TRUE(of_boxes(static_cast<std::size_t>(i)) && of_boxes(other)
                                        ? boxes_pass(static_cast<std::size_t>(i), from, move, other)
                                        : surfaces_pass(static_cast<std::size_t>(i), from, move, other, step))
                            << "copy " << i << " meets " << other;
                    }
                    from = from + move;
                }
                at = from;
            }
            if (!rest.empty()) {
                box = {box.min + at, box.max + at};
                EXPECT_GT(distance(box, rest), 0);
            }
            const int next = removal.placements.size() > 1 ? subassemblies++ : -1;
            for (const int i : removal.placements) {
                subassembly[static_cast<std::size_t>(i)] = next;
                single[static_cast<std::size_t>(i)] += removal.placements.size() == 1;
            }
        }
        std::vector<bool> stuck(parts_.size(), false);
        for (const auto& set : answer.stuck) {
            for (const int i : set) {
                stuck[static_cast<std::size_t>(i)] = true;
            }
        }
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            EXPECT_EQ(single[i], parts_[i].object.fixed || stuck[i] ? 0 : 1) << "copy " << i;
        }
    }

    /// Adds frames, hooks, chests and cubes that do not meet, all between the origin and (size, size, size), moved by
    /// `corner`; on the grid or not.
    void add_heap(RandomStream& random, double size, const Vec3& corner, bool on_grid) {
        const auto across = static_cast<int>(size / 2);
        BitGrid voxels({across, across, across});
        for (int attempt = 0; attempt < 60; ++attempt) {
            Mesh mesh;
            switch (random.below(4)) {
                case 0:
                    mesh = frame_mesh(8 + 2.0 * static_cast<double>(random.below(4)), 2, 2);
                    break;
                case 1:
                    mesh = hook_mesh();
                    break;
                case 2:
                    mesh = chest_mesh(10, 2, true);
                    break;
                default:
                    mesh = cube_mesh(3 + static_cast<double>(random.below(3)));
            }
            mesh = lying(mesh, static_cast<int>(random.below(3)));
            const Box box = bounding_box(mesh);
            Vec3 to;
            for (int axis = 0; axis < 3; ++axis) {
                const auto room = static_cast<std::uint64_t>((size - box.size()[axis]) / 2);
                to[axis] = 2.0 * static_cast<double>(random.below(room + 1)) - box.min[axis];
                if (on_grid) continue;
                to[axis] += std::min(0.1 * static_cast<double>(random.below(20)),
                                     size - box.size()[axis] - box.min[axis] - to[axis]);
            }
            mesh = placed(mesh, to);
            const StandingVoxels standing = voxelize_at(mesh, bounding_box(mesh).min, 2, setup_.workers);
            if (intersects(voxels, standing.solid, standing.position)) continue;
            unite(voxels, standing.solid, standing.position);
            add(placed(mesh, corner));
        }
    }

  private:
    static constexpr double kTouching = 1e-3;

    /// Made by box_mesh() and merged(): every eight vertices are a box.
    bool of_boxes(std::size_t i) const { return 12 * meshes_[i].vertices.size() == 8 * meshes_[i].triangles.size(); }
    std::vector<Box> boxes(std::size_t i, const Vec3& offset) const {
        std::vector<Box> result;
        const std::vector<Vec3>& vertices = meshes_[i].vertices;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            if (k % 8 == 0) result.emplace_back();
            result.back().add(vertices[k] + offset);
        }
        return result;
    }

    /// Of an axis-parallel move: what a box passes then is a box.
    bool boxes_pass(std::size_t i, const Vec3& from, const Vec3& move, std::size_t other) const {
        const std::vector<Box> before = boxes(i, from), after = boxes(i, from + move), there = boxes(other, {});
        for (std::size_t k = 0; k < before.size(); ++k) {
            Box passed = before[k];
            passed.add(after[k]);
            for (const Box& box : there) {
                const Vec3 overlap = min(passed.max, box.max) - max(passed.min, box.min);
                if (std::min({overlap.x, overlap.y, overlap.z}) > kTouching) return false;
            }
        }
        return true;
    }

    bool surfaces_pass(std::size_t i, const Vec3& from, const Vec3& move, std::size_t other, double step) const {
        const int count = static_cast<int>(std::ceil(length(move) / step));
        const auto apart = [&](const Vec3& at) {
            return least_distance(*parts_[i].surface, at, *parts_[other].surface, {}, 1e-4).distance > 0;
        };
        for (int k = 1; k <= count; ++k) {
            const Vec3 here = from + static_cast<double>(k) / count * move;
            if (apart(here)) continue;
            // Touching is allowed: then they are apart a hair's breadth aside.
            bool touching = false;
            for (int axis = 0; axis < 3 && !touching; ++axis) {
                for (const double aside : {-kTouching, kTouching}) {
                    Vec3 there = here;
                    there[axis] += aside;
                    touching = touching || apart(there);
                }
            }
            if (!touching) return false;
        }
        return true;
    }

    DisassemblyOptions setup_;
    std::unique_ptr<PlacementSearch> search_;
    std::vector<Body> parts_;
    std::vector<Mesh> meshes_;
};

}  // namespace spectralpack::test
