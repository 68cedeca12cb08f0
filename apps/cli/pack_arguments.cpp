#include "pack_arguments.hpp"

#include <fmt/format.h>

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

}  // namespace

void add_pack_options(CLI::App& app, PackArguments& arguments) {
    app.add_option("PART", arguments.parts, "what to pack");
    for (const Option& option : option_table()) {
        add_option(app, option, arguments);
    }
}

JobSettings override_settings(JobSettings settings, const PackArguments& arguments) {
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

void settle_container(const PackArguments& arguments, const JobSettings& settings, Job& job) {
    const bool box = arguments.has("tray") || arguments.has("printer");
    job.container = settings.container;
    if (arguments.has("container")) {
        job.container.mesh = MeshSource{arguments.text("container"), "--container"};
    } else if (box) {
        job.container.mesh.reset();
    }
    if (settings.onto) {
        job.onto = load_scene(*settings.onto);
        if (!arguments.has("container") && !box && !settings.sized) {
            job.options.tray = job.onto->packing.container.size;
            ContainerSource same = container_source(job.onto->packing);
            same.keep_out.insert(same.keep_out.end(), job.container.keep_out.begin(), job.container.keep_out.end());
            same.physical = same.physical || job.container.physical;
            job.container = std::move(same);
        }
    }
    if (arguments.has("keep-out")) {
        for (const std::string& keep_out : arguments.given.at("keep-out")) {
            job.container.keep_out.push_back(parse_keep_out(keep_out, job.options.tray));
        }
    }
    job.container.physical = job.container.physical || arguments.has("physical");
}

}  // namespace spectralpack::cli
