#include <array>

#include "model/options/entries.hpp"

namespace spectralpack {
namespace {

using Group = OptionGroup;
using Type = OptionType;

// Finer ones would be s times finer in each of three directions, for nothing: --voxel is the option to turn then.
constexpr int kMostDetail = 8;

// Nobody would wait for more.
constexpr int kMostRestarts = 1'000'000;
constexpr int kMostBeam = 100;
constexpr int kMostImprove = 1'000'000;  // seconds: eleven days

constexpr std::array<std::string_view, 8> kRotations{"none",          "90",    "45", "30", "15", "icosahedron",
                                                     "icosahedron:1", "90+box"};

}  // namespace

std::vector<Option> grid_options() {
    return {
        kept_in<&PackOptions::voxel>(
            {.name = "voxel",
             .group = Group::packing,
             .help_place = 14,
             .type = Type::number,
             .least = 0,
             .above = true,
             .placeholder = "MM",
             .line = "finer is denser; half takes 5 times as long",
             .help = "The voxel size in mm. Every position on a grid of this step is tried. Finer voxels pack "
                     "denser and take longer: halving them costs about five times the time. Where nothing is said, "
                     "--improve takes 1 mm if its time is enough for that; the packing file says which it took.",
             .default_means = "2: perhaps 1 with --improve",
             .examples = {"1"},
             .hash_place = 2}),
        kept_in<&PackOptions::detail>(
            {.name = "detail",
             .group = Group::packing,
             .type = Type::integer,
             .least = 1,
             .most = kMostDetail,
             .placeholder = "N",
             .line = "copies come as near as voxels this many times finer allow",
             .help = "Positions stay on the grid of --voxel, while collisions between copies are decided on voxels of "
                     "--voxel / N. That is much of what finer voxels give, in much less time.",
             .examples = {"1"},
             .hash_place = 11}),
        kept_in<&PackOptions::rotations>(
            {.name = "rotations",
             .group = Group::parts,
             .help_place = 3,
             .type = Type::rotations,
             .words = kRotations,
             .placeholder = "STEP",
             .line = "ways a part may stand: none, or degrees",
             .help =
                 "'none' keeps parts as they lie in their files. A step in degrees turns them round every axis: "
                 "90 gives 24 ways to stand, 45 gives 208. 'icosahedron:N' takes the corners of an icosahedron "
                 "whose edges were halved N times as directions of up. Each may have '+box' for the turns that "
                 "lay the part's smallest box along the axes. A job file may allow less for single parts. Where nothing "
                 "is said, --improve takes 90+box if its time is enough for that; the packing file says which it "
                 "took.",
             .default_means = "90: perhaps 90+box with --improve",
             .examples = {"none", "45", "90+box", "icosahedron:1"},
             .hash_place = 10}),
        // It counts in the hash as the parts' orientations.
        kept_in<&PackOptions::upright>(
            {.name = "upright",
             .group = Group::parts,
             .help_place = 2,
             .line = "parts keep their top up",
             .help = "They are turned about the vertical only, by the step of --rotations. A part whose orientations "
                     "a job file or a set file limits keeps to those."}),
    };
}

std::vector<Option> placing_options() {
    return {
        kept_in<&PackOptions::refine>(
            {.name = "refine",
             .group = Group::packing,
             .line = "slide copies together, up to the exact gap",
             .help = "Once its place on the grid is found, a copy slides along the axes towards its neighbours, two "
                     "voxels a way at most, until it is the gap away from a copy or a wall on the true meshes "
                     "(section 3.2 of the paper). What found no place on the grid is then tried off it, between the "
                     "boxes of what stands.",
             .off_line = "stay on the grid",
             .hash_place = 12}),
        kept_in<&PackOptions::interlock>(
            {.name = "interlock",
             .group = Group::packing,
             .placeholder = "WHEN",
             .line = "see that all comes apart: post (once all is placed), place (at each place), off",
             .help = "Copies that hold each other could not be taken out of the build. 'post' takes the finished "
                     "tray apart, takes out what cannot leave and puts it elsewhere where it can; the packing file "
                     "then holds a plan for taking the tray apart. 'place' uses only places that have a way out. "
                     "'off' does not look: nothing is known of it then.",
             .examples = {"off"},
             .hash_place = 13}),
        kept_in<&PackOptions::links>(
            {.name = "links",
             .group = Group::packing,
             .placeholder = "RULE",
             .line = "with --interlock post, places where two copies are like links of a chain: avoid, allow",
             .help = "'avoid' does not take such places. 'allow' is the paper's way: what cannot leave is taken out "
                     "again afterwards.",
             .examples = {"allow"},
             .hash_place = 14}),
        kept_in<&PackOptions::take_out>(
            {.name = "take-out",
             .group = Group::packing,
             .placeholder = "WHICH",
             .line = "of copies that cannot leave, which are taken out first: thinnest, lightest, smallest",
             .help = "With --interlock post. They are put back if they may stay after all, or elsewhere. "
                     "'thinnest': the one with the least material for its box, so cages, rings and springs rather "
                     "than what is in them. 'lightest': the one with the least material. 'smallest': the paper's "
                     "rule, the smallest boxes up to a tenth of all.",
             .examples = {"lightest"},
             .hash_place = 15}),
        kept_in<&PackOptions::unpack>(
            {.name = "unpack",
             .group = Group::packing,
             .none_word = "auto",
             .placeholder = "ORDER",
             .line = "order in which the plan takes copies out: top (from the top down, between the walls), any (also "
                     "sideways)",
             .help = "A powder cake is dug from above. 'top' takes out the uppermost copy of those that are free, over "
                     "the top, as if walls and keep-outs were there. What has no way out so leaves as with 'any', and "
                     "the summary says how many do. Which copies are packed, and where, is the same.",
             .default_means = "top; any in a container mesh",
             .examples = {"any"}}),
        kept_in<&PackOptions::ray_spacing>(
            {.name = "ray-spacing",
             .group = Group::packing,
             .type = Type::number,
             .least = 0,
             .above = true,
             .placeholder = "MM",
             .line = "mm between the rays that tell which copy is straight in whose way",
             .help = "What the rays miss is found otherwise, more slowly. Fewer rays are faster. No finer than a "
                     "twentieth of the voxels that collisions are decided on.",
             .default_means = "4 voxel / detail",
             .examples = {"0.5"},
             .hash_place = 7}),
        kept_in<&PackOptions::height_penalty>(
            {.name = "height-penalty",
             .group = Group::packing,
             .type = Type::number,
             .least = 0,
             .none_word = "auto",
             .placeholder = "P",
             .line = "how much height costs: auto, or p of p z^3",
             .help = "Of two places, the one with the lower cost is taken: how far it is from what stands there, and "
                     "the height penalty. 'auto' is the paper's appendix A.2: 4 where the boxes of all copies are more "
                     "than 1.2 times the tray, else 10^8. It weighs where height counts at the bottom; a number asks "
                     "for that.",
             .examples = {"auto", "4"},
             .hash_place = 4}),
        kept_in<&PackOptions::height_at>(
            {.name = "height-at",
             .group = Group::packing,
             .none_word = "auto",
             .placeholder = "WHERE",
             .line = "auto, top (lower builds), bottom",
             .help =
                 "'bottom' is the paper's: the penalty is of the height of a copy's lower end. With 'top' the place "
                 "whose upper end is lowest wins, and proximity decides between equals. 'auto' is top in a tray that "
                 "holds all copies that are left (so in the last of several) and without a ceiling, and bottom in "
                 "trays that overflow, which it fills more densely. A tray that turns out otherwise than expected is "
                 "packed both ways, and the better packing stays.",
             .examples = {"top"},
             .hash_place = 16}),
    };
}

std::vector<Option> order_options() {
    return {
        kept_in<&PackOptions::order>(
            {.name = "order",
             .group = Group::packing,
             .placeholder = "RULE",
             .line = "which copies first: size (of the box), volume (of the material), mixed, random, input",
             .help = "Where not all fit, volume and mixed give a denser tray by letting denser parts in first, not by "
                     "packing better; to place all as low as can be, size is best. Priorities and due dates of a job "
                     "file come before any order.",
             .examples = {"random"},
             .hash_place = 20}),
        kept_in<&PackOptions::restarts>(
            {.name = "restarts",
             .group = Group::packing,
             .type = Type::integer,
             .least = 1,
             .most = kMostRestarts,
             .placeholder = "N",
             .line = "pack in N orders and keep the best",
             .help = "The order asked for and others near it. The best has most material in the tray, or the least "
                     "height where all fits. The orders are tried on the grid, at most for a third of --time-limit; "
                     "the packing found then slides together. --improve uses the time better.",
             .examples = {"20"},
             .hash_place = 21}),
        kept_in<&PackOptions::beam>(
            {.name = "beam",
             .group = Group::packing,
             .type = Type::integer,
             .least = 1,
             .most = kMostBeam,
             .placeholder = "WIDTH",
             .line = "look for a good order with this many tries side by side; 5 takes 15 times as long",
             .help = "It runs on the grid, at most for a third of --time-limit; the packing found then slides "
                     "together. --improve uses the time better.",
             .default_means = "none",
             .examples = {"5"},
             .hash_place = 22}),
        kept_in<&PackOptions::goal>(
            {.name = "goal",
             .group = Group::packing,
             .placeholder = "WHAT",
             .line = "what a full tray should hold most of: fair, volume, copies, value",
             .help = "For one tray that cannot hold all. 'fair' lets large copies go first, as people do. 'volume' "
                     "fills the tray most, 'copies' places the most copies, 'value' those that are worth most (the "
                     "column 'value' of a set); these leave out what takes much room for what it brings, hollow or "
                     "large parts. Unless --order says otherwise, copies are tried in the order that serves the goal.",
             .examples = {"volume"},
             .hash_place = 24}),
        kept_in<&PackOptions::improve>(
            {.name = "improve",
             .group = Group::packing,
             .help_place = 12,
             .type = Type::integer,
             .least = 1,
             .most = kMostImprove,
             .zero_word = "rest",
             .placeholder = "S",
             .line = "so many seconds more to pack lower or denser; 'rest': what --time-limit leaves",
             .help =
                 "Once the first packing is done, other orders are tried and copies are shifted, over and over; the "
                 "best packing so far is kept, which comes apart like any other. Where all fits it becomes "
                 "lower; a tray that overflows comes to hold more of what --goal says; of several trays the last "
                 "comes to hold less. Ctrl-C ends it early, and the best is written. What comes of it depends on how "
                 "fast the machine is; --improve-steps does not.",
             .default_means = "none",
             .examples = {"60"},
             .hash_place = 25}),
        kept_in<&PackOptions::improve_steps>(
            {.name = "improve-steps",
             .group = Group::packing,
             .type = Type::integer,
             .least = 0,
             .most = kMostInt,
             .placeholder = "N",
             .line = "improve by trying N other orders, however long that takes",
             .help = "The same number gives the same packing on every machine. A packing that --improve made says how "
                     "many steps it took. With both, what ends first counts.",
             .default_means = "none",
             .examples = {"200"},
             .hash_place = 26}),
    };
}

}  // namespace spectralpack
