#include "model/options/entries.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/printers.hpp"

namespace spectralpack {
namespace {

using Group = OptionGroup;
using Type = OptionType;

/// Their names, and "list".
std::span<const std::string_view> printer_words() {
    static const std::vector<std::string_view> words = [] {
        std::vector<std::string_view> names{"list"};
        for (const Printer& printer : printers()) {
            names.push_back(printer.name);
        }
        return names;
    }();
    return words;
}

}  // namespace

std::vector<Option> output_options() {
    return {
        kept_in<&JobSettings::outputs>(
            {.name = "output",
             .letter = 'o',
             .group = Group::result,
             .help_place = 17,
             .type = Type::files,
             .placeholder = "FILE",
             .line = ".3mf .stl .json .csv .png, more than once",
             .help = "The ending says what is written: .json the packing file with everything that is known, .3mf for "
                     "slicers, .stl all copies merged, .csv a line with the transform of each copy, .png a picture. Of "
                     "several trays, those but .json become one file for each tray and one with all of them. Files "
                     "are written whole or not at all; an existing one is replaced.",
             .examples = {"build.3mf", "build.json"}}),
        kept_in<&JobSettings::reports>(
            {.name = "report",
             .group = Group::result,
             .help_place = 18,
             .type = Type::files,
             .placeholder = "FILE",
             .line = ".html: the operator's sheet; .csv: a line a part",
             .help =
                 "More than once. The sheet is one file of A4 pages to print: for each tray a picture with the copies' "
                 "numbers, figures, the area of each layer, the part list, top views to find the copies in the powder "
                 "by, the order of removal, and what was left over and why. The table has a line for each part.",
             .examples = {"build.html"}}),
        kept_in<&JobSettings::material_density>({.name = "material-density",
                                                 .group = Group::result,
                                                 .help_place = 19,
                                                 .type = Type::number,
                                                 .least = 0,
                                                 .above = true,
                                                 .placeholder = "D",
                                                 .line = "g/cm3; the report then has masses",
                                                 .examples = {"1.01"}}),
        kept_in<&JobSettings::material>({.name = "material",
                                         .group = Group::result,
                                         .type = Type::text,
                                         .placeholder = "NAME",
                                         .line = "the material's name, for the report",
                                         .examples = {"PA 12"}}),
        kept_in<&JobSettings::job_name>({.name = "job-name",
                                         .group = Group::result,
                                         .type = Type::text,
                                         .placeholder = "NAME",
                                         .line = "heading of the report",
                                         .default_means = "the job file's name, else the report's",
                                         .examples = {"Week 48"}}),
    };
}

std::vector<Option> container_options() {
    return {
        kept_in<&PackOptions::tray>(
            {.name = "tray",
             .group = Group::tray,
             .help_place = 5,
             .type = Type::size,
             .placeholder = "XxYxZ",
             .line = "tray in mm",
             .help = "Length, width and height of the box that is filled. Its lower corner is the origin, z points "
                     "up. With --open-height length and width will do.",
             .examples = {"160x120x100", "300x200"},
             .hash_place = 1}),
        kept_in<&PackOptions::trays>(
            {.name = "trays",
             .group = Group::tray,
             .help_place = 6,
             .type = Type::integer,
             .least = 1,
             .most = kMostInt,
             .zero_word = "all",
             .placeholder = "N",
             .line = "trays to fill at most, or all",
             .help = "Trays are filled one after the other, each with what found no place in those before it. 'all' "
                     "goes on until everything is placed or a tray stays empty.",
             .examples = {"2", "all"},
             .hash_place = 8}),
        kept_in<&PackOptions::try_per_tray>(
            {.name = "try-per-tray",
             .group = Group::tray,
             .type = Type::integer,
             .least = 0,
             .most = kMostInt,
             .placeholder = "N",
             .line = "a tray is full once so many parts found no place in it; 0: once all were tried",
             .help = "Where many copies wait for later trays, not every one of them has to be tried in each: fewer "
                     "tries are faster, more let small parts fill the gaps of early trays.",
             .examples = {"500"},
             .hash_place = 9}),
        kept_in<&PackOptions::printer>(
            {.name = "printer",
             .group = Group::tray,
             .help_place = 4,
             .type = Type::text,
             .words = printer_words(),
             .placeholder = "NAME",
             .line = "tray and gaps of a printer; list shows them",
             .help = "Sets --tray, --gap and --wall-gap, which override it where they are given. The gaps are "
                     "customary starting values, not the maker's word: yours depend on material and machine.",
             .examples = {"hp-mjf-5200"}}),
        {.name = "container",
         .group = Group::tray,
         .type = Type::file,
         .placeholder = "MESH",
         .line = "a closed mesh to fill instead of a box",
         .help = "It is moved to the origin; its box takes the place of --tray. Only what lies wholly inside is "
                 "filled. A cup is filled inside (--container-is). In a job file: the key 'container'.",
         .examples = {"cup.stl"}},
        {.name = "container-is",
         .group = Group::tray,
         .type = Type::word,
         .words = words_of<ContainerIs>(),
         .placeholder = "WHAT",
         .line = "what of the container mesh is filled: solid, or vessel (its inside)",
         .help =
             "solid: the mesh's own volume. vessel: what it holds inside, up to where it would run over. Without "
             "it a mesh is a vessel where that is at least a third of its own volume; the program says which. A vessel "
             "that is open at the top is physical: what leaves, leaves over it. In a job file: 'is' of "
             "'container'.",
         .examples = {"vessel"}},
        {.name = "keep-out",
         .group = Group::tray,
         .help_place = 7,
         .type = Type::files,
         .placeholder = "BOX",
         .line = "stays empty: x0,y0,z0,x1,y1,z1, or a mesh file",
         .help = "A box by two opposite corners in mm, or a closed mesh; more than once. The wall gap holds for it, "
                 "too. In a job file: the key 'keep_out'.",
         .takes = "a box x0,y0,z0,x1,y1,z1 in mm, or the path of a mesh file",
         .examples = {"0,0,0,480,10,200", "pillar.stl"}},
        {.name = "physical",
         .group = Group::tray,
         .line = "walls and keep-outs are really there: copies leave over the top, which is open",
         .help = "Else they are virtual: a way out may lead through them. In a job file: 'physical' of 'container'."},
        kept_in<&JobSettings::onto>(
            {.name = "onto",
             .group = Group::tray,
             .help_place = 8,
             .type = Type::file,
             .placeholder = "FILE",
             .line = "add to this build; its copies stay",
             .help = "A packing file (.json). What is packed is placed beside and on top of the copies in it, tray "
                     "by tray, in the same tray unless another is given.",
             .examples = {"yesterday.json"}}),
        kept_in<&JobSettings::keep>(
            {.name = "keep",
             .group = Group::tray,
             .type = Type::file,
             .placeholder = "FILE",
             .line = "copies of this build of the same parts stay where they stand",
             .help =
                 "A packing file (.json). Its copies count as placed; what else is asked for is packed around them. "
                 "A build that lacks some copies is packed to the end so, or one of which a few were taken out. "
                 "Parts are known by mesh, scale and name.",
             .examples = {"build.json"}}),
    };
}

std::vector<Option> gap_options() {
    return {
        kept_in<&PackOptions::gap>(
            {.name = "gap",
             .group = Group::gap,
             .help_place = 9,
             .type = Type::number,
             .least = 0,
             .placeholder = "MM",
             .line = "between two copies",
             .help = "The least distance between two copies, in mm. It is kept on the true meshes, whatever the "
                     "voxel size. A part may have a gap of its own in a job file; of two copies the larger counts. "
                     "Print bureaus commonly ask for 1 mm or more.",
             .examples = {"1"},
             .of_printer = true}),
        kept_in<&PackOptions::wall_gap>(
            {.name = "wall-gap",
             .group = Group::gap,
             .help_place = 10,
             .type = Type::number,
             .least = 0,
             .placeholder = "MM",
             .line = "to the walls",
             .help = "The least distance to the walls, in mm; also to the floor, the ceiling, keep-outs and a "
                     "container mesh.",
             .examples = {"1.5"},
             .hash_place = 3,
             .of_printer = true}),
    };
}

std::vector<Option> filling_options() {
    return {
        kept_in<&PackOptions::open_height>(
            {.name = "open-height",
             .group = Group::tray,
             .line = "no ceiling: as low as can be on the tray's base",
             .help = "The packing file records the height reached. Goes with one tray that is a box, and not with "
                     "--fill. Where the height of --tray is left out, heights are weighed by the longer side of the "
                     "base.",
             .hash_place = 17}),
        kept_in<&PackOptions::minimise>(
            {.name = "minimise",
             .group = Group::tray,
             .placeholder = "WHAT",
             .line = "box: the smallest box that holds all, up to the tray's base",
             .help = "Bases up to the tray's are tried for the packing whose bounding box has the least volume.",
             .examples = {"box"},
             .hash_place = 18}),
        kept_in<&PackOptions::fill>(
            {.name = "fill",
             .group = Group::packing,
             .help_place = 11,
             .line = "as many copies as fit; counts are shares",
             .help = "Counts of 1 and 3 give three of the second part for each of the first, as far as there is place.",
             .hash_place = 19}),
        kept_in<&PackOptions::max_density>(
            {.name = "max-density",
             .group = Group::packing,
             .type = Type::number,
             .least = 0,
             .most = 1,
             .above = true,
             .placeholder = "F",
             .line = "at most this share of the tray, like 0.3",
             .help = "A copy that would exceed it is left over; smaller ones that come later may still be placed.",
             .examples = {"0.3"},
             .hash_place = 5}),
        kept_in<&PackOptions::max_layer_fill>({.name = "max-layer-fill",
                                               .group = Group::packing,
                                               .help_place = 13,
                                               .type = Type::number,
                                               .least = 0,
                                               .most = 1,
                                               .above = true,
                                               .placeholder = "F",
                                               .line = "at most this share of each layer, like 0.4",
                                               .help = "As --max-density, for every layer by itself.",
                                               .examples = {"0.4"},
                                               .hash_place = 6}),
    };
}

}  // namespace spectralpack
