#include "spectralpack/tools/generate.hpp"

#include <algorithm>
#include <cstdio>

#include "spectralpack/error.hpp"
#include "tools/generate/bent_parts.hpp"
#include "tools/generate/block_parts.hpp"
#include "tools/generate/dice.hpp"
#include "tools/generate/letters.hpp"
#include "tools/generate/polyhedra.hpp"
#include "tools/generate/segments.hpp"
#include "tools/generate/turned_parts.hpp"
#include "tools/generate/whole_bodies.hpp"

namespace spectralpack::tools {
namespace {

struct Kind {
    const char* name;
    Mesh (*make)(Dice& dice, double size);
    bool round = false;  ///< about z
};

// The longest sides in mm at evenly spaced quantiles follow the sets of real parts that docs/benchmarks.md measures.
const std::vector<double> kPiecesSizes{8, 18, 25, 31, 39, 48, 62, 85, 105, 127};
const std::vector<double> kMixturesSizes{9,  14, 20, 24, 29, 34, 40,  46,  52,  57, 61,
                                         66, 72, 78, 81, 83, 90, 105, 120, 150, 400};
const std::vector<double> kLocksSizes{21, 42, 54, 66, 78, 90, 102, 118, 146};
const std::vector<double> kToriSizes{38, 45, 52, 60, 68, 75, 85};

// So that 80 polyhedra have about the volume that the paper's density and box come to (figure 17): 561 mm^3 each.
const std::vector<double> kPolyhedraSizes{7, 9, 10, 12, 13, 15, 16, 18, 21, 24};
constexpr int kPolyhedraCount = 8;

// As the paper's figure 16 has them.
constexpr int kBunnyPieces = 13, kMoleculePieces = 12;

constexpr Vec3 kTray{480, 245, 200};  // mm; whatever is generated fits it as it lies

constexpr double kThinnest = 1.5;  // mm; what is flattened is left at least as thick

constexpr int kMaxCopies = 10'000'000;

constexpr double kLarge = 60;  // mm; what is longer is mostly hollow

const std::vector<Kind>& compact_kinds() {
    static const std::vector<Kind> kinds{
        {"bracket", bracket}, {"channel", channel},     {"l-block", l_block},
        {"tee", tee},         {"steps", steps},         {"drilled-block", drilled_block},
        {"wedge", wedge},     {"washer", washer, true}, {"bushing", bushing, true},
        {"pin", pin, true},   {"knob", knob, true},     {"gear", gear, true}};
    return kinds;
}

const std::vector<Kind>& hollow_kinds() {
    static const std::vector<Kind> kinds{{"tray", tray},
                                         {"window-plate", window_plate},
                                         {"cup", cup, true},
                                         {"bowl", bowl, true},
                                         {"funnel", funnel, true},
                                         {"pipe", pipe, true},
                                         {"elbow", elbow},
                                         {"basket", basket},
                                         {"flat-frame", flat_frame},
                                         {"bracket", bracket}};
    return kinds;
}

const std::vector<Kind>& shell_kinds() {
    static const std::vector<Kind> kinds{{"tray", tray},     {"window-plate", window_plate},
                                         {"cup", cup, true}, {"clip", clip},
                                         {"elbow", elbow},   {"c-hook", c_hook}};
    return kinds;
}

const std::vector<Kind>& lock_kinds() {
    static const std::vector<Kind> kinds{{"ring", ring},           {"link", link},     {"curb-link", curb_link},
                                         {"poly-ring", poly_ring}, {"c-hook", c_hook}, {"j-hook", j_hook},
                                         {"s-hook", s_hook},       {"handle", handle}, {"flat-frame", flat_frame},
                                         {"ladder", ladder},       {"cage", cage},     {"basket", basket},
                                         {"spring", spring},       {"knot", knot},     {"clip", clip}};
    return kinds;
}

const std::vector<Kind>& polyhedron_kinds() {
    static const std::vector<Kind> kinds{{"tetrahedron", tetrahedron},
                                         {"l-block", l_block},
                                         {"pyramid", pyramid},
                                         {"dart", dart},
                                         {"frustum", frustum},
                                         {"tee", tee},
                                         {"bipyramid", bipyramid},
                                         {"star", star},
                                         {"wedge", wedge},
                                         {"twisted-prism", twisted_prism}};
    return kinds;
}

const Kind& one_of(Dice& dice, const std::vector<Kind>& kinds) {
    return kinds[static_cast<std::size_t>(dice.number(0, static_cast<int>(kinds.size()) - 1))];
}

/// The two shorter sides made shorter still, as real parts are mostly flat or long; of a round part only its
/// height, where that is not what is longest.
Mesh flattened(const Mesh& mesh, bool round, Dice& dice) {
    const Vec3 sides = bounding_box(mesh).size();
    const double most = std::max({sides.x, sides.y, sides.z}), least = std::min({sides.x, sides.y, sides.z});
    const double middle = dice.between(0.55, 1);
    const double flat = most > kLarge ? dice.between(0.2, 0.6) : dice.between(0.35, 0.9);
    const double shortest = std::max(flat, kThinnest / least);
    Mat3 scale;
    for (int axis = 0; axis < 3; ++axis) {
        if (sides[axis] == most || (round && axis != 2)) continue;
        scale.rows[static_cast<std::size_t>(axis)][axis] = sides[axis] == least ? shortest : middle;
    }
    return transformed(mesh, {scale, {}});
}

/// Turned, its longest side `size` or as long as fits the tray, its box minimum at the origin.
Mesh finished(const Mesh& mesh, const Mat3& rotation, double size) {
    const Mesh turned = transformed(mesh, {rotation, {}});
    const Vec3 sides = bounding_box(turned).size();
    const double scale = std::min(
        {size / std::max({sides.x, sides.y, sides.z}), kTray.x / sides.x, kTray.y / sides.y, kTray.z / sides.z});
    const Mesh scaled = transformed(turned, {scale * Mat3{}, {}});
    return at_origin(scaled);
}

/// Copies of a set where nobody says how many.
int usual_copies(GeneratedSet set) {
    switch (set) {
        case GeneratedSet::pieces:
            return 1446;
        case GeneratedSet::mixtures:
            return 286;
        case GeneratedSet::locks:
            return 468;
        case GeneratedSet::tori:
            return 48;
        case GeneratedSet::polyhedra:
            return 80;
        case GeneratedSet::letters:
        case GeneratedSet::segments:
            break;
    }
    return 0;
}

/// Part `number` of a set, from 0; its name is that of its kind.
GeneratedPart roll(GeneratedSet set, std::size_t number, Dice& dice) {
    const Mat3 rotation = dice.cube_rotation();
    switch (set) {
        case GeneratedSet::pieces:
        case GeneratedSet::mixtures: {
            const bool pieces = set == GeneratedSet::pieces;
            const double size = dice.quantile(pieces ? kPiecesSizes : kMixturesSizes);
            const int count = pieces ? dice.number(4, 18) : dice.chance(0.83) ? 1 : dice.number(2, 3);
            const bool hollow = dice.chance(size > kLarge ? 0.8 : 0.3);
            const Kind& kind = one_of(dice, !hollow ? compact_kinds() : pieces ? shell_kinds() : hollow_kinds());
            const Mesh mesh = flattened(kind.make(dice, size), kind.round, dice);
            return {kind.name, finished(mesh, rotation, size), count};
        }
        case GeneratedSet::locks: {
            const double size = dice.quantile(kLocksSizes);
            const int count = dice.chance(0.7) ? 2 : 2 * dice.number(2, 3);
            const Kind& kind = one_of(dice, lock_kinds());
            return {kind.name, finished(kind.make(dice, size), rotation, size), count};
        }
        case GeneratedSet::polyhedra: {
            const Kind& kind = polyhedron_kinds()[number % polyhedron_kinds().size()];
            const double size = dice.quantile(kPolyhedraSizes);
            return {kind.name, finished(kind.make(dice, size), rotation, size), kPolyhedraCount};
        }
        default: {
            const double size = dice.quantile(kToriSizes);
            return {"torus", finished(distorted_torus(dice, size), rotation, size), 1};
        }
    }
}

std::vector<GeneratedPart> letters() {
    std::vector<GeneratedPart> parts;
    for (const char letter : {'S', 'I', 'G', 'R', 'A', 'P', 'H'}) {
        parts.push_back({std::string("letter-") + letter, letter_mesh(letter), letter == 'G' ? 2 : 1});
    }
    return parts;
}

std::vector<GeneratedPart> segments(std::uint64_t seed) {
    std::vector<GeneratedPart> parts;
    RandomStream seeds(seed);
    const auto add = [&](const std::string& name, const Mesh& whole, int pieces) {
        std::size_t number = 0;
        for (const Mesh& piece : cut_into_segments(whole, {.pieces = pieces, .seed = seeds.next()})) {
            parts.push_back({segment_name(name, ++number), at_origin(piece), 1});
        }
    };
    add(kBunny, bunny_body(), kBunnyPieces);
    add(kMolecule, molecule_body(), kMoleculePieces);
    return parts;
}

}  // namespace

std::vector<GeneratedPart> generate_parts(const GenerateOptions& options) {
    if (options.copies && options.set == GeneratedSet::letters) {
        throw UsageError("letters are always the same seven containers: they take no number of copies");
    }
    if (options.copies && options.set == GeneratedSet::segments) {
        throw UsageError("segments are always 13 pieces of one body and 12 of another: they take no number of copies");
    }
    if (options.copies && (*options.copies < 1 || *options.copies > kMaxCopies)) {
        throw UsageError("the number of copies must be from 1 to 10000000");
    }
    if (options.set == GeneratedSet::letters) return letters();
    if (options.set == GeneratedSet::segments) return segments(options.seed);
    std::vector<GeneratedPart> parts;
    RandomStream seeds(options.seed);
    for (int left = options.copies.value_or(usual_copies(options.set)); left > 0;) {
        Dice dice(seeds.next());
        GeneratedPart part = roll(options.set, parts.size(), dice);
        part.count = std::min(part.count, left);
        left -= part.count;
        char number[16];
        std::snprintf(number, sizeof number, "%04d", static_cast<int>(parts.size()));
        part.name = std::string(to_string(options.set)) + "-" + number + "-" + part.name;
        parts.push_back(std::move(part));
    }
    return parts;
}

std::span<const GeneratedSet> generated_sets() {
    static constexpr GeneratedSet kSets[] = {GeneratedSet::pieces,  GeneratedSet::mixtures,  GeneratedSet::locks,
                                             GeneratedSet::tori,    GeneratedSet::polyhedra, GeneratedSet::letters,
                                             GeneratedSet::segments};
    return kSets;
}

}  // namespace spectralpack::tools
