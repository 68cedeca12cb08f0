#include "disassembly/graph/rays.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "disassembly/scenes.hpp"
#include "geometry/slides_past.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;

BlockingGraph graph_of(const AssemblyScene& scene, double spacing) {
    BlockingGraph graph(scene.parts().size());
    std::vector<const Body*> parts;
    for (const Body& part : scene.parts()) {
        parts.push_back(&part);
    }
    cast_rays(parts, spacing, graph, Workers(2));
    return graph;
}

TEST(Rays, TellWhoIsAbove) {
    AssemblyScene scene({40, 40, 40});
    scene.add(test::box_mesh({0, 0, 0}, {20, 20, 5}));
    scene.add(test::box_mesh({5, 5, 5}, {10, 10, 9}));  // standing on it
    scene.add(test::box_mesh({30, 30, 0}, {35, 35, 5}));
    const BlockingGraph graph = graph_of(scene, 0.5);
    EXPECT_EQ(graph.blockers(0, {2, 1}), 1);
    EXPECT_EQ(graph.blockers(1, {2, -1}), 1);
    EXPECT_EQ(graph.blockers(1, {2, 1}), 0);
    EXPECT_EQ(graph.blockers(0, {2, -1}), 0);
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        EXPECT_EQ(graph.blockers(2, BlockingGraph::direction(d)), 0);
    }
    EXPECT_EQ(graph.blockers(0, {0, 1}), 0) << "they touch in a plane along x";
}

TEST(Rays, FindNothingThatExactSweepsDoNot) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomStream random(seed);
        AssemblyScene scene({60, 60, 60});
        for (int i = 0; i < 6; ++i) {
            const Vec3 at{8 + 40 * random.unit(), 8 + 40 * random.unit(), 8 + 40 * random.unit()};
            const Mesh ball = test::placed(test::sphere_mesh(2 + 3 * random.unit(), 6), at);
            bool meets = false;
            for (const Body& part : scene.parts()) {
                meets = meets || distance(part.box(), bounding_box(ball)) < 0.1;
            }
            if (!meets) scene.add(ball);
        }
        const BlockingGraph graph = graph_of(scene, 0.5);
        for (std::size_t i = 0; i < scene.parts().size(); ++i) {
            for (int d = 0; d < BlockingGraph::kDirections; ++d) {
                const AxisDirection direction = BlockingGraph::direction(d);
                int exact = 0;
                for (std::size_t j = 0; j < scene.parts().size(); ++j) {
                    exact += i != j && !slides_past(*scene.parts()[i].surface, {}, *scene.parts()[j].surface, direction,
                                                    1e-4, 100);
                }
                EXPECT_LE(graph.blockers(i, direction), exact);
                EXPECT_GE(graph.blockers(i, direction), exact - 1) << "rays miss little of a ball";
            }
        }
    }
}

}  // namespace
}  // namespace spectralpack
