#pragma once
/// Sets of generated parts with the characters of the paper's benchmarks (section 5.1), so that
/// benchmarks can be run from nothing.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

enum class GeneratedSet {
    pieces,     ///< many small and medium, mostly axis-aligned parts, each several times
    mixtures,   ///< large, mostly hollow ones and small, mostly solid ones
    locks,      ///< rings, links, hooks, frames, cages: what catches in one another
    tori,       ///< distorted tori (figure 22)
    polyhedra,  ///< ten kinds of few faces, convex and not, each eight times (figure 17)
    letters,    ///< S, I, G, R, A, P, H as containers (appendix B.4)
};

struct GeneratedPart {
    std::string name;  ///< file name without its ending, unlike all others
    Mesh mesh;         ///< mm, box minimum at the origin; closed, outward, no self-intersections
    int count = 1;
};

/// The parts of a set, with `copies` copies in all (none: as many as the sets of docs/benchmarks.md:
/// 1446, 286, 468, 48 and 80). The same seed gives the same bits on every machine, and the first parts do
/// not depend on how many follow. Letters are always the same seven, whatever the seed. Precondition:
/// copies >= 1, none for letters.
std::vector<GeneratedPart> generate_parts(GeneratedSet set, std::uint64_t seed, std::optional<int> copies);

}  // namespace spectralpack
