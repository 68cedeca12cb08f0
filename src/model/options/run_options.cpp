#include <array>

#include "model/options/entries.hpp"

namespace spectralpack {
namespace {

using Group = OptionGroup;
using Type = OptionType;

constexpr std::array<std::string_view, 2> kVerifiers{"reference", "reference:300"};

}  // namespace

std::vector<Option> run_options() {
    return {
        kept_in<&PackOptions::engine>(
            {.name = "engine",
             .group = Group::packing,
             .placeholder = "NAME",
             .line = "auto, cpu, reference (the definition, slow); the result does not depend on it",
             .help =
                 "All engines give the same placements. 'reference' is the paper's method written plainly. 'cuda' is "
                 "not built yet.",
             .examples = {"cpu"}}),
        kept_in<&PackOptions::threads>({.name = "threads",
                                        .group = Group::packing,
                                        .type = Type::integer,
                                        .least = 0,
                                        .most = kMostThreads,
                                        .placeholder = "N",
                                        .line = "threads; the result does not depend on them",
                                        .default_means = "all",
                                        .examples = {"4"}}),
        kept_in<&PackOptions::seed>({.name = "seed",
                                     .group = Group::packing,
                                     .type = Type::natural,
                                     .least = 0,
                                     .placeholder = "N",
                                     .line = "of --order random, --restarts, --improve and of samples",
                                     .help = "The same seed gives the same packing on every machine.",
                                     .examples = {"7"},
                                     .hash_place = 23}),
        kept_in<&PackOptions::memory>(
            {.name = "memory",
             .group = Group::packing,
             .type = Type::bytes,
             .least = 0,
             .placeholder = "BYTES",
             .line = "to plan with, like 4G",
             .help = "K, M, G and T are powers of 1000, Ki, Mi, Gi and Ti of 1024; in files it is a number of bytes. A "
                     "run that would need more is refused before it starts, with the voxel size that would fit.",
             .default_means = "what is free",
             .examples = {"4G"}}),
        kept_in<&PackOptions::verify_with>(
            {.name = "verify-with",
             .group = Group::packing,
             .type = Type::verify,
             .words = kVerifiers,
             .placeholder = "ENGINE[:SAMPLE]",
             .line = "ask a second engine, too, about all or about SAMPLE copies",
             .help = "The run stops at the first placement that the two answer differently. The sample is drawn by "
                     "--seed.",
             .examples = {"reference:300"}}),
        kept_in<&PackOptions::time_limit>({.name = "time-limit",
                                           .group = Group::packing,
                                           .help_place = 15,
                                           .type = Type::number,
                                           .least = 0,
                                           .placeholder = "S",
                                           .line = "for all of it; the best so far is written by then",
                                           .help = "In seconds, of the whole run, reading, plan, files and pictures "
                                                   "included. It is kept to within a second or a tenth, whichever is "
                                                   "more, unless a single mesh takes longer to read or a file to "
                                                   "write. Placing ends when two thirds are over, or a little less "
                                                   "with pictures: the rest is for the plan that takes the packing "
                                                   "apart, and for writing. Pictures for which there is little time "
                                                   "are drawn without shadows. What was not tried is left over.",
                                           .examples = {"600"}}),
    };
}

std::vector<Option> input_options() {
    return {
        kept_in<&JobSettings::unit>({.name = "unit",
                                     .group = Group::parts,
                                     .help_place = 1,
                                     .placeholder = "UNIT",
                                     .line = "of files that do not say theirs: mm, inch, m",
                                     .help = "3MF files say theirs; STL, OBJ, PLY and OFF do not.",
                                     .default_means = "mm",
                                     .examples = {"inch"}}),
        {.name = "mesh-dir",
         .group = Group::parts,
         .type = Type::folder,
         .placeholder = "FOLDER",
         .line = "folder that the paths in set files start from",
         .default_means = "the set file's own",
         .examples = {"meshes"}},
        kept_in<&JobSettings::skip_unusable>({.name = "skip-unusable",
                                              .group = Group::parts,
                                              .line = "files that cannot be used are no error (exit 0)",
                                              .help = "The rest is packed either way; else the exit status is 3."}),
    };
}

std::vector<Option> program_options() {
    return {
        {.name = "profile",
         .group = Group::result,
         .help_place = 20,
         .type = Type::text,
         .placeholder = "NAME",
         .line = "settings kept in spectralpack.json",
         .help = "A profile is a named set of options in a file of settings, for a material or a machine.",
         .examples = {"pa12"}},
        {.name = "config",
         .group = Group::result,
         .type = Type::file,
         .placeholder = "FILE",
         .line = "settings to use instead of the user's and the project's",
         .help = "Without it options that nobody says come from config.json in ~/.config/spectralpack and from "
                 "spectralpack.json in the working directory, which comes first. Printers in printers.json beside "
                 "such a file are known as well.",
         .examples = {"bureau.json"}},
        {.name = "no-config", .group = Group::result, .line = "use no file of settings"},
        {.name = "journal",
         .group = Group::result,
         .type = Type::file,
         .placeholder = "FILE",
         .line = "keep what is decided in FILE, so that a run that is cut off can go on",
         .help = "By default a run of more than ten seconds keeps one beside the first output: build.3mf.journal for "
                 "build.3mf. The same command finds it and goes on from there; it ends with the same packing. It is "
                 "removed once the outputs are written, and stays where a signal ended the run.",
         .default_means = "beside the first -o",
         .examples = {"night.journal"}},
        {.name = "resume",
         .group = Group::result,
         .type = Type::file,
         .placeholder = "FILE",
         .line = "go on from this journal, and from no other",
         .help = "Refused where it is not there, or of another job: parts, options that decide what comes out, or "
                 "program.",
         .examples = {"build.3mf.journal"}},
        {.name = "no-resume", .group = Group::result, .line = "begin anew, whatever journal is there"},
        {.name = "keep-journal",
         .group = Group::result,
         .line = "do not remove the journal when the run is done",
         .help = "A later run with more --improve then goes on from the best that was found. Needs --journal or "
                 "--resume."},
        kept_in<&JobSettings::dry_run>(
            {.name = "dry-run",
             .group = Group::packing,
             .line = "say what time and memory it would take (packs a few seconds to see); write nothing"}),
        kept_in<&JobSettings::require_all>({.name = "require-all",
                                            .group = Group::packing,
                                            .help_place = 16,
                                            .line = "left over copies are an error (exit 5)"}),
        kept_in<&JobSettings::progress>(
            {.name = "progress",
             .group = Group::result,
             .placeholder = "STYLE",
             .line = "on standard error: auto, bar, json, none",
             .help = "'auto' is a bar on a terminal and nothing elsewhere; 'json' one object a line, for programs.",
             .default_means = "auto",
             .examples = {"json"}}),
        kept_in<&JobSettings::json>(
            {.name = "json", .group = Group::result, .line = "print the packing as JSON instead of the summary"}),
        kept_in<&JobSettings::details>({.name = "details",
                                        .group = Group::result,
                                        .line = "the summary also has memory, threads and the time of each phase"}),
    };
}

}  // namespace spectralpack
