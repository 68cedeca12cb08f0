#include "disassembly/disassembler.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "disassembly/scenes.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::lying;
using test::placed;

using Sets = std::vector<std::vector<int>>;

const Mesh kTorus = test::torus_mesh(10, 2);

/// Pairs of opposite bars along the three axes around a hollow: what is inside does not fit between them.
Mesh cage_mesh(double size, double bar) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 low, high;
            low[axis] = 0;
            high[axis] = size;
            for (int k = 1; k <= 2; ++k) {
                const int across = (axis + k) % 3;
                const bool far = (corner >> (k - 1)) & 1;
                low[across] = far ? size - bar : 0;
                high[across] = far ? size : bar;
            }
            mesh = test::merged(mesh, box_mesh(low, high));
        }
    }
    return mesh;
}

/// A thread of `turns` turns of the given pitch: a helical band of radius `inner` to `outer` about z, with a core (for
/// a bolt) or a shell (for a nut) that closes it.
Mesh helix_mesh(double inner, double outer, double thickness, double pitch, double turns) {
    Mesh mesh;
    const int per_turn = 24, count = static_cast<int>(per_turn * turns);
    for (int i = 0; i <= count; ++i) {
        const double a = 2 * std::numbers::pi * i / per_turn, z = pitch * i / per_turn;
        const Vec3 out{std::cos(a), std::sin(a), 0};
        for (const auto& [r, dz] : {std::pair{inner, 0.0}, {outer, 0.0}, {outer, thickness}, {inner, thickness}}) {
            mesh.vertices.push_back(r * out + Vec3{0, 0, z + dz});
        }
    }
    const auto at = [](int i, int j) { return static_cast<std::uint32_t>(4 * i + j % 4); };
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < 4; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    mesh.triangles.push_back({at(0, 0), at(0, 2), at(0, 1)});
    mesh.triangles.push_back({at(0, 0), at(0, 3), at(0, 2)});
    mesh.triangles.push_back({at(count, 0), at(count, 1), at(count, 2)});
    mesh.triangles.push_back({at(count, 0), at(count, 2), at(count, 3)});
    return mesh;
}

Mesh bolt_mesh() { return test::merged(box_mesh({-3, -3, -2}, {3, 3, 26}), helix_mesh(2, 7, 2, 8, 3)); }
/// Its thread lies half a turn of the pitch off the bolt's, and reaches in deeper than the bolt's reaches out.
Mesh nut_mesh() {
    Mesh shell = test::frame_mesh(26, 3, 16);
    return test::merged(placed(shell, {-13, -13, 4}), placed(helix_mesh(5.5, 11, 2, 8, 1.25), {0, 0, 4 + 3}));
}

TEST(InterlockedSets, FindsTwoLinkedToriInterlocked) {
    AssemblyScene scene({60, 60, 60});
    scene.add(placed(kTorus, {20, 20, 20}));
    scene.add(placed(lying(kTorus, 0), {20, 30, 20}));
    EXPECT_EQ(scene.disassemble().stuck, (Sets{{0, 1}}));
}

TEST(InterlockedSets, TakesToriSideBySideApart) {
    AssemblyScene scene({80, 60, 60});
    scene.add(placed(kTorus, {20, 20, 20}));
    scene.add(placed(lying(kTorus, 0), {36, 20, 20}));
    scene.add(placed(kTorus, {20, 20, 24}));
    const auto answer = scene.disassemble();
    EXPECT_TRUE(answer.complete());
    scene.replay(answer);
}

TEST(InterlockedSets, FindsBorromeanRingsInterlockedThoughNoTwoAreLinked) {
    // Long frames in the three planes, each through the next one.
    const auto ring = [](int narrow) {
        const Vec3 half[3] = {{3, 12, 8}, {8, 3, 12}, {12, 8, 3}};
        Mesh mesh;
        const Vec3 h = half[narrow];
        const double bar = 3;
        int wide = -1, high = -1;
        for (int axis = 0; axis < 3; ++axis) {
            if (h[axis] == 12) wide = axis;
            if (h[axis] == 8) high = axis;
        }
        for (const int sign : {-1, 1}) {
            for (const auto& [along, across] : {std::pair{wide, high}, {high, wide}}) {
                Vec3 low, top;
                low[narrow] = -bar / 2, top[narrow] = bar / 2;
                low[along] = -h[along], top[along] = h[along];
                low[across] = sign > 0 ? h[across] - bar : -h[across];
                top[across] = sign > 0 ? h[across] : -h[across] + bar;
                mesh = test::merged(mesh, box_mesh(low, top));
            }
        }
        return placed(mesh, {20, 20, 20});
    };
    AssemblyScene scene({40, 40, 40});
    for (int i = 0; i < 3; ++i) {
        scene.add(ring(i));
    }
    EXPECT_EQ(scene.disassemble().stuck, (Sets{{0, 1, 2}}));

    // Any two of them come apart.
    for (int out = 0; out < 3; ++out) {
        AssemblyScene two({40, 40, 40});
        for (int i = 0; i < 3; ++i) {
            if (i != out) two.add(ring(i));
        }
        const auto answer = two.disassemble();
        EXPECT_TRUE(answer.complete()) << "without " << out;
        two.replay(answer);
    }
}

TEST(InterlockedSets, FindsABallInACageInterlockedAndBesideItNot) {
    const Mesh cage = cage_mesh(24, 4), ball = test::sphere_mesh(9.5);
    AssemblyScene inside({60, 60, 60});
    inside.add(placed(cage, {10, 10, 10}));
    inside.add(placed(ball, {22, 22, 22}));
    EXPECT_EQ(inside.disassemble().stuck, (Sets{{0, 1}}));

    AssemblyScene beside({60, 60, 60});
    beside.add(placed(cage, {10, 10, 10}));
    beside.add(placed(ball, {45, 22, 22}));
    const auto answer = beside.disassemble();
    EXPECT_TRUE(answer.complete());
    beside.replay(answer);
}

TEST(InterlockedSets, FindsANutOnABoltInterlockedAndBesideItNot) {
    AssemblyScene on({60, 60, 60});
    on.add(placed(bolt_mesh(), {20, 20, 10}));
    on.add(placed(nut_mesh(), {20, 20, 10}));
    EXPECT_EQ(on.disassemble().stuck, (Sets{{0, 1}}));

    AssemblyScene beside({80, 60, 60});
    beside.add(placed(bolt_mesh(), {20, 20, 10}));
    beside.add(placed(nut_mesh(), {50, 20, 10}));
    const auto answer = beside.disassemble();
    EXPECT_TRUE(answer.complete());
    beside.replay(answer);
}

TEST(InterlockedSets, FindsAPartInAClosedHollowInterlockedAndInAnOpenOneNot) {
    for (const bool open : {false, true}) {
        AssemblyScene scene({60, 60, 60});
        scene.add(placed(test::chest_mesh(30, 3, open), {5, 5, 5}));
        scene.add(box_mesh({12, 12, 12}, {20, 20, 20}));
        const auto answer = scene.disassemble();
        EXPECT_EQ(answer.stuck, open ? Sets{} : (Sets{{0, 1}}));
        if (open) scene.replay(answer);
    }
}

/// `count` rings, each through the next, in a circle where closed.
AssemblyScene chain(int count, bool closed) {
    AssemblyScene scene({160, 160, 60});
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / (closed ? count : 2 * count);
        const double radius = closed ? 36 : 72;
        const Vec3 tangent{-std::sin(angle), std::cos(angle), 0}, outwards{std::cos(angle), std::sin(angle), 0};
        const Vec3 up{0, 0, 1};
        // Alternately lying and standing, long way along the tangent.
        const Vec3 across = i % 2 == 0 ? outwards : up, normal = cross(tangent, across);
        Mat3 turn;
        for (int row = 0; row < 3; ++row) {
            turn.rows[static_cast<std::size_t>(row)] = {tangent[row], across[row], normal[row]};
        }
        const Mesh ring = transformed(test::torus_mesh(10, 1.5, 24, 8),
                                      {Mat3{{Vec3{1.9, 0, 0}, Vec3{0, 0.8, 0}, Vec3{0, 0, 1}}}, {}});
        scene.add(transformed(ring, {turn, radius * outwards + Vec3{80, 80, 30}}));
    }
    return scene;
}

TEST(InterlockedSets, FindsAClosedChainInterlocked) {
    const auto answer = chain(8, true).disassemble();
    ASSERT_EQ(answer.stuck.size(), 1u);
    EXPECT_EQ(answer.stuck.front().size(), 8u);
}

/// A frame of 20 x 20 x 3 with a gap in its side at +y.
Mesh open_link() {
    Mesh mesh = box_mesh({0, 0, 0}, {20, 3, 3});
    mesh = test::merged(mesh, box_mesh({0, 0, 0}, {3, 20, 3}));
    mesh = test::merged(mesh, box_mesh({17, 0, 0}, {20, 20, 3}));
    mesh = test::merged(mesh, box_mesh({0, 17, 0}, {7, 20, 3}));
    return test::merged(mesh, box_mesh({13, 17, 0}, {20, 20, 3}));
}

TEST(InterlockedSets, TakesAnOpenChainApartAndNotOneOfClosedLinks) {
    for (const bool open : {true, false}) {
        AssemblyScene scene({80, 30, 30});
        for (int i = 0; i < 4; ++i) {
            // Lying, standing, lying, standing: each through the next one's hole.
            Mesh link = open ? open_link() : test::frame_mesh(20, 3, 3);
            if (i % 2 == 1) link = transformed(link, {Mat3{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}}, {}});
            scene.add(placed(link, i % 2 == 0 ? Vec3{4 + 12.0 * i, 4, 13} : Vec3{4 + 12.0 * i, 12, 4}));
        }
        const auto answer = scene.disassemble();
        if (open) {
            EXPECT_TRUE(answer.complete());
            EXPECT_GT(answer.counts.flooded, 0);
        } else {
            EXPECT_EQ(answer.stuck, (Sets{{0, 1, 2, 3}}));
        }
        scene.replay(answer);
    }
}

}  // namespace
}  // namespace spectralpack
