#include "generate/generate.hpp"

#include <algorithm>
#include <cstdio>

#include "generate/bent_parts.hpp"
#include "generate/block_parts.hpp"
#include "generate/dice.hpp"
#include "generate/letters.hpp"
#include "generate/turned_parts.hpp"

namespace spectralpack {
namespace {

struct Kind {
    const char* name;
    Mesh (*make)(Dice& dice, double size);
};

// The longest sides in mm at evenly spaced quantiles follow the sets of real parts in docs/benchmarks.md.
const std::vector<double> kPiecesSizes{8, 18, 25, 31, 39, 48, 62, 85, 105, 127};
const std::vector<double> kMixturesSizes{9, 20, 30, 42, 61, 72, 86, 120, 400};
const std::vector<double> kLocksSizes{21, 42, 54, 66, 78, 90, 102, 118, 146};
const std::vector<double> kToriSizes{38, 45, 52, 60, 68, 75, 85};

constexpr Vec3 kTray{480, 245, 200};  // mm; whatever is generated fits it as it lies

constexpr double kLarge = 66;  // mm; in mixtures, what is longer is mostly hollow

const std::vector<Kind>& compact_kinds() {
    static const std::vector<Kind> kinds{
        {"bracket", bracket}, {"channel", channel}, {"l-block", l_block},
        {"tee", tee},         {"steps", steps},     {"drilled-block", drilled_block},
        {"wedge", wedge},     {"washer", washer},   {"bushing", bushing},
        {"pin", pin},         {"knob", knob},       {"gear", gear}};
    return kinds;
}

const std::vector<Kind>& hollow_kinds() {
    static const std::vector<Kind> kinds{{"tray", tray},
                                         {"window-plate", window_plate},
                                         {"cup", cup},
                                         {"bowl", bowl},
                                         {"funnel", funnel},
                                         {"pipe", pipe},
                                         {"elbow", elbow},
                                         {"basket", basket},
                                         {"flat-frame", flat_frame},
                                         {"bracket", bracket}};
    return kinds;
}

const std::vector<Kind>& shell_kinds() {
    static const std::vector<Kind> kinds{{"tray", tray}, {"window-plate", window_plate}, {"cup", cup},
                                         {"clip", clip}, {"elbow", elbow},               {"c-hook", c_hook}};
    return kinds;
}

const std::vector<Kind>& lock_kinds() {
    static const std::vector<Kind> kinds{
        {"ring", ring},           {"link", link},     {"curb-link", curb_link},
        {"poly-ring", poly_ring}, {"c-hook", c_hook}, {"j-hook", j_hook},
        {"s-hook", s_hook},       {"handle", handle}, {"flat-frame", flat_frame},
        {"ladder", ladder},       {"cage", cage},     {"basket", basket},
        {"spring", spring},       {"knot", knot},     {"window-plate", window_plate},
        {"clip", clip}};
    return kinds;
}

const Kind& one_of(Dice& dice, const std::vector<Kind>& kinds) {
    return kinds[static_cast<std::size_t>(dice.number(0, static_cast<int>(kinds.size()) - 1))];
}

/// Turned, its longest side `size` or as long as fits the tray, its box minimum at the origin.
Mesh finished(const Mesh& mesh, const Mat3& rotation, double size) {
    const Mesh turned = transformed(mesh, {rotation, {}});
    const Vec3 sides = bounding_box(turned).size();
    const double scale = std::min({size / std::max({sides.x, sides.y, sides.z}), kTray.x / sides.x,
                                   kTray.y / sides.y, kTray.z / sides.z});
    const Mesh scaled = transformed(turned, {scale * Mat3{}, {}});
    return transformed(scaled, {Mat3{}, -bounding_box(scaled).min});
}

struct Recipe {
    const char* name;
    int copies;
};

Recipe recipe_of(GeneratedSet set) {
    switch (set) {
        case GeneratedSet::pieces: return {"pieces", 1446};
        case GeneratedSet::mixtures: return {"mixtures", 286};
        case GeneratedSet::locks: return {"locks", 468};
        case GeneratedSet::tori: return {"tori", 48};
        case GeneratedSet::letters: break;
    }
    return {"letters", 8};
}

/// One part of a set; its name is that of its kind.
GeneratedPart roll(GeneratedSet set, Dice& dice) {
    const auto made = [&](const Kind& kind, double size, const Mat3& rotation, int count) {
        return GeneratedPart{kind.name, finished(kind.make(dice, size), rotation, size), count};
    };
    if (set == GeneratedSet::pieces) {
        const double size = dice.quantile(kPiecesSizes);
        const Mat3 rotation = dice.cube_rotation();
        const int count = dice.number(4, 18);
        return made(one_of(dice, dice.chance(0.6) ? compact_kinds() : shell_kinds()), size, rotation, count);
    }
    if (set == GeneratedSet::mixtures) {
        const double size = dice.quantile(kMixturesSizes);
        const Mat3 rotation = dice.cube_rotation();
        const int count = dice.chance(0.83) ? 1 : dice.number(2, 3);
        const bool hollow = dice.chance(size > kLarge ? 0.75 : 0.2);
        return made(one_of(dice, hollow ? hollow_kinds() : compact_kinds()), size, rotation, count);
    }
    if (set == GeneratedSet::locks) {
        const double size = dice.quantile(kLocksSizes);
        const Mat3 rotation = dice.cube_rotation();
        const int count = dice.chance(0.7) ? 2 : dice.number(2, 3) * 2;
        return made(one_of(dice, lock_kinds()), size, rotation, count);
    }
    const double size = dice.quantile(kToriSizes);
    const Mat3 rotation = dice.rotation();
    return made({"torus", distorted_torus}, size, rotation, 1);
}

std::vector<GeneratedPart> letters() {
    std::vector<GeneratedPart> parts;
    for (const char letter : {'S', 'I', 'G', 'R', 'A', 'P', 'H'}) {
        parts.push_back({std::string("letter-") + letter, letter_mesh(letter), letter == 'G' ? 2 : 1});
    }
    return parts;
}

}  // namespace

std::vector<GeneratedPart> generate_parts(GeneratedSet set, std::uint64_t seed,
                                          std::optional<int> copies) {
    if (set == GeneratedSet::letters) return letters();
    const Recipe recipe = recipe_of(set);
    std::vector<GeneratedPart> parts;
    RandomStream seeds(seed);
    for (int left = copies.value_or(recipe.copies); left > 0;) {
        Dice dice(seeds.next());
        GeneratedPart part = roll(set, dice);
        part.count = std::min(part.count, left);
        left -= part.count;
        char number[16];
        std::snprintf(number, sizeof number, "%04d", static_cast<int>(parts.size()));
        part.name = std::string(recipe.name) + "-" + number + "-" + part.name;
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace spectralpack
