#include "pack_arguments.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "keep_outs.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// For man page and completions; --help has a page of its own (help_page.hpp).
std::string help_line(const Option& option) {
    const std::string by_default = default_text(option);
    return std::string(option.line) + (by_default.empty() ? "" : fmt::format(" [{}]", by_default));
}

void add_option(CLI::App& app, const Option& option, PackArguments& arguments) {
    const auto take = [&given = arguments.given, name = option.name](const std::vector<std::string>& texts) {
        given[name] = texts;
    };
    const std::string name = fmt::format("--{}", option.name), group(title_of(option.group));
    if (option.type == OptionType::flag) {
        app.add_flag_callback(
               name, [take] { take({"true"}); }, help_line(option))
            ->group(group);
        if (option.off_line.empty()) return;
        app.add_flag_callback(
               fmt::format("--no-{}", option.name), [take] { take({"false"}); }, std::string(option.off_line))
            ->group(group);
        return;
    }
    const std::string names = option.letter ? fmt::format("-{},{}", option.letter, name) : name;
    CLI::Option* added = nullptr;
    if (option.type == OptionType::files) {
        added = app.add_option_function<std::vector<std::string>>(names, take, help_line(option));
        added->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    } else {
        added = app.add_option_function<std::string>(
            names, [take](const std::string& text) { take({text}); }, help_line(option));
    }
    added->type_name(std::string(option.placeholder))->group(group);
}

OptionValue value_of(const Option& option, const std::vector<std::string>& texts) {
    if (option.type != OptionType::files) return parse_value(option, texts.front());
    require_accepted(option, texts);
    return texts;
}

const Printer& known_printer(const std::string& name, std::span<const Printer> own) {
    const Printer* printer = find_printer(name, own);
    if (printer) return *printer;
    std::vector<std::string> known;
    for (const std::span<const Printer> list : {own, printers()}) {
        for (const Printer& one : list) {
            known.push_back(one.name);
        }
    }
    const auto near = nearest_word(name, known);
    throw UsageError(fmt::format("--printer {}: not known;{} --printer list names those that are", name,
                                 near ? fmt::format(" did you mean {}?", *near) : ""));
}

std::string box_text(const Vec3& size) {
    return fmt::format("{} x {} x {}", length_text(size.x), length_text(size.y), length_text(size.z));
}

/// Those of the build that is topped up, where nothing else is said.
TakenOver take_gaps(const PackArguments& arguments, const JobSettings& settings, Job& job) {
    TakenOver taken;
    taken.file = std::filesystem::path(*settings.onto).filename().string();
    const PackOptions& build = job.onto->packing.options;
    const bool by_printer = arguments.has("printer");
    const auto take = [&](bool said, const char* what, double PackOptions::*gap) {
        if (!said) {
            job.options.*gap = build.*gap;
            return true;
        }
        if (job.options.*gap != build.*gap) {
            taken.remarks.push_back(fmt::format("the {} is {} mm; {} was packed with {} mm, which its copies keep",
                                                what, length_text(job.options.*gap), taken.file,
                                                length_text(build.*gap)));
        }
        return false;
    };
    taken.gap = take(settings.says_gap || by_printer || arguments.has("gap"), "gap", &PackOptions::gap);
    taken.wall_gap =
        take(settings.says_wall_gap || by_printer || arguments.has("wall-gap"), "wall gap", &PackOptions::wall_gap);
    return taken;
}

}  // namespace

void add_pack_options(CLI::App& app, PackArguments& arguments) {
    app.add_option("PART", arguments.parts, "what to pack");
    for (const Option& option : option_table()) {
        add_option(app, option, arguments);
    }
}

JobSettings override_settings(JobSettings settings, const PackArguments& arguments) {
    if (arguments.has("container-is")) require_accepted(*find_option("container-is"), arguments.text("container-is"));
    if (arguments.has("printer")) {
        apply(known_printer(arguments.text("printer"), settings.own_printers), settings.options);
        forget_defaults(set_by_printer(), settings);
    }
    for (const Option& option : option_table()) {
        if (!arguments.has(option.name) || option.name == "printer") continue;
        const OptionValue value = value_of(option, arguments.given.at(option.name));
        if (option.in_pack.set) option.in_pack.set(settings.options, value);
        if (option.in_job.set) option.in_job.set(settings, value);
        forget_defaults({std::string(option.name)}, settings);
    }
    return settings;
}

TakenOver settle_container(const PackArguments& arguments, const JobSettings& settings, Job& job) {
    TakenOver taken;
    const bool box = arguments.has("tray") || arguments.has("printer");
    job.container = settings.container;
    if (arguments.has("container")) {
        job.container.mesh = MeshSource{arguments.text("container"), "--container"};
    } else if (box) {
        job.container.mesh.reset();
    }
    if (settings.keep) job.keep = load_scene(*settings.keep);
    if (settings.onto) {
        job.onto = load_scene(*settings.onto);
        taken = take_gaps(arguments, settings, job);
        std::vector<std::string> taken_over;  // options, which files of defaults no longer say
        if (taken.gap) taken_over.emplace_back("gap");
        if (taken.wall_gap) taken_over.emplace_back("wall-gap");
        taken.container = !arguments.has("container") && !box && !settings.sized;
        if (taken.container) {
            job.options.tray = job.onto->packing.container.size;
            job.options.printer = job.onto->packing.options.printer;
            ContainerSource same = container_source(job.onto->packing);
            same.keep_out.insert(same.keep_out.end(), job.container.keep_out.begin(), job.container.keep_out.end());
            same.physical = same.physical || job.container.physical;
            job.container = std::move(same);
            taken_over.insert(taken_over.end(), {"tray", "printer"});
        } else if (!arguments.has("container") && job.options.tray != job.onto->packing.container.size) {
            taken.remarks.push_back(fmt::format("the container is {} mm; {} was packed into {} mm",
                                                box_text(job.options.tray), taken.file,
                                                box_text(job.onto->packing.container.size)));
        }
        JobSettings rest;
        rest.defaults = std::move(job.defaults);
        forget_defaults(taken_over, rest);
        job.defaults = std::move(rest.defaults);
    }
    if (arguments.has("keep-out")) {
        for (const std::string& keep_out : arguments.given.at("keep-out")) {
            job.container.keep_out.push_back(parse_keep_out(keep_out, job.options.tray));
        }
    }
    if (arguments.has("container-is")) {
        if (!job.container.mesh) throw UsageError("--container-is tells what a container mesh is; there is none here");
        job.container.is = from_string<ContainerIs>(arguments.text("container-is"));
    }
    job.container.physical = job.container.physical || arguments.has("physical");
    return taken;
}

}  // namespace spectralpack::cli
