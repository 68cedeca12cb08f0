#pragma once
/// Sets of generated parts with the characters of the paper's benchmarks (section 5.1), so that benchmarks can be run
/// from nothing.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spectralpack/events.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack::tools {

enum class GeneratedSet {
    pieces,     ///< many small and medium, mostly axis-aligned parts, each several times
    mixtures,   ///< large, mostly hollow ones and small, mostly solid ones
    locks,      ///< rings, links, hooks, frames, cages: what catches in one another
    tori,       ///< distorted tori (figure 22)
    polyhedra,  ///< ten kinds of few faces, convex and not, each eight times (figure 17)
    letters,    ///< S, I, G, R, A, P, H as containers (appendix B.4)
    segments,   ///< a bunny-like body in 13 pieces, a molecule-like one in 12 (figure 16)
};

/// All of them, in the order above.
std::span<const GeneratedSet> generated_sets();

struct GenerateOptions {
    GeneratedSet set = GeneratedSet::pieces;
    std::uint64_t seed = 0;
    /// In all; none: as many as the sets of docs/benchmarks.md, which are 1446, 286, 468, 48 and 80. None for letters
    /// and segments.
    std::optional<int> copies = {};
};

struct GeneratedPart {
    std::string name;  ///< file name without its ending, unlike all others
    Mesh mesh;         ///< mm, box minimum at the origin; closed, outward, no self-intersections
    int count = 1;
};

/// The parts of a set. The same options give the same bits on every machine, and the first parts do not depend on how
/// many follow. Letters are always the same seven, whatever the seed; the pieces of segments differ by it, their bodies
/// do not. Throws UsageError for a number of copies that makes no sense.
std::vector<GeneratedPart> generate_parts(const GenerateOptions& options);

struct GeneratedFiles {
    std::filesystem::path set_file;  ///< columns mesh,count,scale; beside the meshes
    int meshes = 0;
    int copies = 0;
    double volume = 0;      ///< of all copies, mm^3
    double box_volume = 0;  ///< of all copies' boxes as they lie, mm^3
};

/// Writes every part as a binary STL into `folder`, which is made where it is not there, and then a set file that names
/// them; of segments first one for each body, too, bunny.csv and molecule.csv. Files of the same names are replaced.
/// Throws what generate_parts() throws, and ResourceError where the folder cannot be written. Of `control` only the
/// listener counts.
GeneratedFiles generate(const GenerateOptions& options, const std::filesystem::path& folder,
                        const Control& control = {});

struct SegmentOptions {
    Vec3 tray{480, 245, 200};  ///< mm; every piece fits into it in one of the 24 orientations
    int pieces = 1;            ///< at least
    std::uint64_t seed = 0;    ///< of how more pieces are cut than the tray demands
    double unit = 1;           ///< millimetres per unit for files that do not say
};

/// Cuts the meshes of a file by planes into closed pieces in millimetres, each where it lay in the whole, whose volumes
/// add up to the whole's. What fits the tray stays whole where no more pieces are asked for; what does not is cut along
/// the axes, as seldom as that goes. They are written as those of a set are, as NAME-01.stl and so on, with
/// segments.csv. Throws InputError for a mesh that cannot be read or is not closed, saying where it is open; UsageError
/// for more than a thousand pieces; ResourceError where the folder cannot be written.
GeneratedFiles generate_segments(const std::filesystem::path& file, const SegmentOptions& options,
                                 const std::filesystem::path& folder, const Control& control = {});

}  // namespace spectralpack::tools

namespace spectralpack {

template <>
inline constexpr Words<7> kWords<tools::GeneratedSet>{"pieces",    "mixtures", "locks",   "tori",
                                                      "polyhedra", "letters",  "segments"};

}  // namespace spectralpack
