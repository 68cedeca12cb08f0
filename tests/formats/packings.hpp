#pragma once
/// Packings made in code, for the tests of this room.

#include <cmath>
#include <string>

#include "core/random.hpp"
#include "formats/packing_file.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

/// Two parts, three copies placed on two trays, one left over; every field set to something of its
/// own.
inline Packing small_packing() {
    Packing packing;
    packing.program = "spectralpack 0.0.0";
    packing.input_hash = "00ff";
    packing.container.size = {100, 80, 60.5};
    packing.container.open_height = true;
    packing.options.tray = packing.container.size;
    packing.options.voxel = 1.5;
    packing.options.detail = 3;
    packing.options.rotations = "45";
    packing.options.upright = true;
    packing.options.gap = 0.25;
    packing.options.wall_gap = 1;
    packing.options.refine = true;
    packing.options.interlock = Interlock::place;
    packing.options.links = Links::allow;
    packing.options.take_out = TakeOut::thinnest;
    packing.options.unpack = Unpack::top;
    packing.options.ray_spacing = 0.375;
    packing.options.height_penalty = 1e8;
    packing.options.height_at = HeightReference::top;
    packing.options.open_height = true;
    packing.options.minimise = Minimise::box;
    packing.options.fill = true;
    packing.options.max_density = 0.5;
    packing.options.max_layer_fill = 0.75;
    packing.options.order = Order::random;
    packing.options.restarts = 7;
    packing.options.beam = 4;
    packing.options.goal = Goal::value;
    packing.options.improve = 60;
    packing.options.improve_steps = 200;
    packing.options.engine = EngineKind::reference;
    packing.options.threads = 3;
    packing.options.seed = 0xffffffffffffffffu;
    packing.options.memory = std::int64_t{1} << 40;
    packing.options.verify_with = VerifyWith{EngineKind::reference, 10};
    packing.options.time_limit = 2.5;
    packing.defaults = {{"spectralpack.json", "pa12", {"gap", "voxel"}}};

    PackedPart bracket;
    bracket.name = "bracket \"left\" & <co>";
    bracket.priority = 2;
    bracket.due = "2026-12-01";
    bracket.value = 4.5;
    bracket.mesh = "/elsewhere/meshes/bracket.stl";
    bracket.count = 3;
    bracket.share = 2;
    bracket.scale = 0.5;
    bracket.gap = 0.25;
    bracket.orientations.kind = PartOrientations::Kind::axes;
    bracket.orientations.up = {{2, true}, {0, false}};
    bracket.orientations.yaw = 45;
    bracket.volume = 1000.0 / 3;
    bracket.repairs = {"turned the mesh, which was inside out"};
    bracket.due = "2026-12-01";
    bracket.order = "A-2291";
    packing.parts.push_back(bracket);
    PackedPart lid;
    lid.id = 1;
    lid.name = "Deckel äöü";
    lid.mesh = "/elsewhere/out/job.3mf";
    lid.object = "7";
    lid.numbers = {4};
    lid.item_transform = Transform{{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}}, {5, 6, 7}};
    lid.unit = 25.4;
    packing.parts.push_back(lid);

    const Mat3 turned{{Vec3{0, -0.5, 0}, Vec3{0.5, 0, 0}, Vec3{0, 0, 0.5}}};
    TrayPacking first;
    first.placements = {{0, 0, 0, false, {0.5 * Mat3{}, {1, 2, 3}}}, {1, 0, 2, true, {25.4 * Mat3{}, {40, 0.1, 0}}}};
    first.density = 0.1;
    first.density_bounding_box = 1.0 / 3;
    first.bounding_box = {{1, 0.1, 0}, {66, 27, 26}};
    first.height = 26;
    first.height_at = HeightReference::top;
    first.layers = {1.5, {12.5, 0, 3}};
    first.disassembly = Disassembly{true, {{{0}, {{0, 0, 30.5}, {-70, 0.25, 0}}}}, {}, Unpack::top, {0}};
    TrayPacking second;
    second.placements = {{0, 1, 1, false, {turned, {30, 4, 5}}}};
    second.disassembly = Disassembly{false, {}, {{0}}};
    packing.trays = {first, second};
    packing.unplaced = {{0, 2, UnplacedReason::no_place, "no position is free"}};

    packing.metrics.copies = 4;
    packing.metrics.placed = 3;
    packing.metrics.density = 0.05;
    packing.metrics.min_gap = 0.3;
    packing.metrics.seconds = {7, 1, 2, 3, 0.5, 0.25, 0.125};
    packing.metrics.interlock = InterlockCounts{2, 1, 1, 3, 2, 1, 1};
    packing.metrics.searches = 4;
    packing.metrics.orders = 9;
    packing.metrics.improvement = Improved{Improves::density, 0.04, 0.05, 200, 3, 12.5};
    packing.metrics.verified = 3;
    packing.metrics.peak_memory = 123456789;
    packing.metrics.engine = "cpu";
    packing.metrics.threads = 2;
    return packing;
}

/// The meshes of small_packing().
inline PartMeshes small_meshes() {
    return {std::make_shared<Mesh>(box_mesh({0, 0, 0}, {20.5, 10, 30})),
            std::make_shared<Mesh>(box_mesh({0, 0, 0}, {1, 0.1, 1}))};
}

/// A rotation about a random axis.
inline Mat3 random_rotation(RandomStream& random) {
    double q[4], size = 0;
    for (double& entry : q) {
        entry = 2 * random.unit() - 1;
        size += entry * entry;
    }
    for (double& entry : q) {
        entry /= std::sqrt(size);
    }
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return {{Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             Vec3{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             Vec3{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace spectralpack::test
