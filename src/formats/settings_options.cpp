#include "formats/settings_options.hpp"

#include <algorithm>
#include <optional>

#include "formats/option_reader.hpp"
#include "spectralpack/printers.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

/// Paths as they are from the working directory.
OptionValue from_here(OptionValue value, const Option& option, const fs::path& folder) {
    if (option.type == OptionType::file) return (folder / std::get<std::string>(value)).string();
    if (option.type == OptionType::files) {
        for (std::string& path : std::get<std::vector<std::string>>(value)) {
            path = (folder / path).string();
        }
    }
    return value;
}

}  // namespace

std::vector<std::string> read_settings_options(const Node& node, const fs::path& folder, JobSettings& settings) {
    std::vector<std::string_view> known;
    for (const Option& option : option_table()) {
        if (option.in_pack.set || option.in_job.set) known.push_back(option.name);
    }
    node.expect_keys(known);
    std::vector<std::string> said;
    std::optional<std::string> printer_name;
    if (const auto v = node.find("printer")) {
        const Printer* printer = find_printer(v->text(), settings.own_printers);
        if (!printer) v->fail("is no printer that is known: see 'spectralpack pack --printer list'");
        apply(*printer, settings.options);
        said = set_by_printer();
        printer_name = printer->name;
    }
    read_options(node, settings.options);
    if (printer_name) settings.options.printer = printer_name;  // as the list has it
    for (const Option& option : option_table()) {
        const auto v = node.find(option.name);
        if (!v) continue;
        if (std::ranges::find(said, option.name) == said.end()) said.emplace_back(option.name);
        if (option.in_job.set) option.in_job.set(settings, from_here(read_value(*v, option), option, folder));
    }
    return said;
}

}  // namespace spectralpack
