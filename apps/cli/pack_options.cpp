#include "pack_arguments.hpp"

namespace spectralpack::cli {

void add_pack_options(CLI::App& app, PackArguments& a) {
    app.add_option("PART", a.parts, "what to pack");
    app.add_option("-o,--output", a.outputs, "file to write, repeatable: .json .3mf .stl .csv .png")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--report", a.report,
                   "report for people to write: .html (a page with pictures that prints well) or .csv");
    app.add_option("--material-density", a.material_density, "g/cm3 of the material; the report then has masses");
    const std::string container = "Container";
    app.add_option("--tray", a.tray, "container in mm; with --open-height XxY will do [480x245x200]")->group(container);
    app.add_flag("--open-height", a.open_height, "no ceiling: least height on the tray's base")->group(container);
    app.add_option("--minimise", a.minimise, "box: a base, up to the tray's, and height of least volume [none]")
        ->group(container);
    app.add_flag("--fill", a.fill, "as many copies as fit; counts are shares of one another")->group(container);
    app.add_option("--max-density", a.max_density, "cap on the density, a share like 0.3")->group(container);
    app.add_option("--max-layer-fill", a.max_layer_fill, "cap on the share of each layer's area, like 0.4")
        ->group(container);
    app.add_option("--printer", a.printer, "build volume and customary gaps of a printer; list prints them")
        ->group(container);
    app.add_option("--container", a.container, "closed mesh to fill instead of a box")->group(container);
    app.add_option("--keep-out", a.keep_out,
                   "room that stays empty, repeatable: a box x0,y0,z0,x1,y1,z1 in mm, or a mesh file")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(container);
    app.add_flag("--physical", a.physical,
                 "walls and keep-outs are really there: what leaves, leaves over the top, which is open")
        ->group(container);
    app.add_option("--onto", a.onto, "packing file to top up: its copies stay where they are")->group(container);
    app.add_option("--trays", a.trays, "containers to fill, a number or all [1]")->group(container);
    app.add_option(
           "--try-per-tray", a.try_per_tray,
           "of several trays, one is full once so many parts found no place in it; 0: once all were tried [1000]")
        ->group(container);
    app.add_option("--gap", a.gap, "least distance between two copies, mm [0.2]")->group(container);
    app.add_option("--wall-gap", a.wall_gap, "least distance to the walls, mm [0]")->group(container);
    const std::string input = "Input";
    app.add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]")->group(input);
    app.add_option("--mesh-dir", a.mesh_dir, "folder that the paths in set files start from")->group(input);
    app.add_flag("--skip-unusable", a.skip_unusable, "exit 0 although an input was unusable")->group(input);
    const std::string search = "Search";
    app.add_option("--voxel", a.voxel, "voxel size in mm [2]")->group(search);
    app.add_option("--detail", a.detail, "copies may come as near as voxels this many times finer allow, 1 to 8 [2]")
        ->group(search);
    app.add_option("--rotations", a.rotations,
                   "orientations tried: none, a step in degrees (90: 24 of them), icosahedron[:N]; each with +box for\n"
                   "the turns of the part's minimum bounding box [90]")
        ->group(search);
    app.add_option("--height-penalty", a.height_penalty, "how much height costs: auto, or p of p z^3 [auto]")
        ->group(search);
    app.add_option(
           "--height-at", a.height_at,
           "where height counts: bottom, or top (before proximity: lower, in half the time) [bottom; top without a ceiling]")
        ->group(search);
    app.add_option(
           "--order", a.order,
           "which copies first: size (of the box, largest first), volume (of the solid), mixed (geometric mean\n"
           "of both), random, input. Where not all fit, volume and mixed give a denser tray by letting denser\n"
           "parts in first, not by packing better; to place all as low as can be, size is best [size]")
        ->group(search);
    app.add_option(
           "--restarts", a.restarts,
           "pack in N orders, the one asked for and others near it, and keep the best: most solid volume in the\n"
           "tray, or least height where all fits [1]")
        ->group(search);
    app.add_option("--beam", a.beam,
                   "beam search over orders with this many states, compared with the plain order; 5 takes some\n"
                   "fifteen times as long [1: none]")
        ->group(search);
    app.add_option("--seed", a.seed, "seed of --order random, --restarts and of samples [0]")->group(search);
    app.add_flag("--refine", a.refine, "slide copies together off the grid, gap kept on the true meshes [the default]")
        ->group(search);
    app.add_flag("--no-refine", a.no_refine, "stay on the grid")->group(search);
    app.add_option("--interlock", a.interlock,
                   "keep copies from locking: post (repair the packing), place (only where a way out is), off [post]")
        ->group(search);
    app.add_option("--links", a.links,
                   "with --interlock post, places where two copies hold each other by themselves, like links of a "
                   "chain: avoid, allow (the paper's way: taken out again afterwards) [avoid]")
        ->group(search);
    app.add_option(
           "--take-out", a.take_out,
           "of copies that hold each other, which go first, to be put back if they may stay after all or elsewhere: "
           "thinnest (least material for its box: cages and rings), lightest (least material), smallest (the "
           "paper's: smallest boxes up to a tenth) [thinnest]")
        ->group(search);
    app.add_option("--ray-spacing", a.ray_spacing,
                   "mm between the rays that tell which copy is straight in whose way; what they miss, flood fills "
                   "find [4 voxel / detail]")
        ->group(search);
    const std::string run = "Run";
    app.add_option("--engine", a.engine, "auto, cpu, reference (the definition, slow) [auto]")->group(run);
    app.add_option("--threads", a.threads, "threads, 0 for all [0]; the result does not depend on it")->group(run);
    app.add_option("--memory", a.memory, "memory to plan with, like 4G [what is free]")->group(run);
    app.add_option("--time-limit", a.time_limit, "seconds; then the best packing so far is written")
        ->check(CLI::NonNegativeNumber)
        ->group(run);
    app.add_flag("--dry-run", a.dry_run,
                 "say what memory and time it would take (packs a few seconds to see); write nothing")
        ->group(run);
    app.add_option("--verify-with", a.verify_with,
                   "let a second engine answer too, all or about SAMPLE placements: reference[:SAMPLE]")
        ->group(run);
    app.add_flag("--require-all", a.require_all, "exit 5 when copies are left over")->group(run);
    app.add_option("--progress", a.progress, "auto, bar, json, none [auto]")->group(run);
    app.add_flag("--json", a.json, "print the packing as JSON instead of a summary")->group(run);
}

}  // namespace spectralpack::cli
