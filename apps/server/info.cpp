#include <spectralpack/option_table.hpp>
#include <spectralpack/printers.hpp>

#include <array>
#include <cmath>

#include "http/page.hpp"
#include "jobs/job_file_rules.hpp"
#include "routes.hpp"

namespace spectralpack::server {
namespace {

const char* word_of(OptionType type) {
    constexpr std::array kWords{"flag",      "integer", "natural", "bytes", "number", "size",  "word",
                                "rotations", "verify",  "text",    "file",  "files",  "folder"};
    return kWords.at(static_cast<std::size_t>(type));
}

Json option_json(const Option& option) {
    Json json{{"name", option.name},
              {"group", title_of(option.group)},
              {"type", word_of(option.type)},
              {"above", option.above},
              {"words", Json(std::vector<std::string>(option.words.begin(), option.words.end()))},
              {"none_word", option.none_word},
              {"zero_word", option.zero_word},
              {"placeholder", option.placeholder},
              {"line", option.line},
              {"help", option.help},
              {"values", values_of(option)},
              {"default", default_text(option)},
              {"examples", Json(std::vector<std::string>(option.examples.begin(), option.examples.end()))},
              {"optional", option.optional},
              {"here", is_allowed_here(std::string(option.name))}};
    if (std::isfinite(option.least)) json["least"] = option.least;
    if (std::isfinite(option.most)) json["most"] = option.most;
    return json;
}

}  // namespace

Json info_json(const Settings& settings) {
    Json printer_list = Json::array(), options = Json::array();
    for (const Printer& printer : printers()) {
        printer_list.push_back({{"name", printer.name},
                                {"title", printer.title},
                                {"size", {printer.size.x, printer.size.y, printer.size.z}},
                                {"gap", printer.gap},
                                {"wall_gap", printer.wall_gap()}});
    }
    for (const Option& option : option_table()) {
        options.push_back(option_json(option));
    }
    const Limits& limits = settings.limits;
    return {{"program", "spectralpack " SPECTRALPACK_VERSION},
            {"printers", printer_list},
            {"options", options},
            {"limits",
             {{"file_bytes", limits.file_bytes},
              {"files", limits.files},
              {"job_bytes", limits.job_bytes},
              {"jobs", limits.jobs},
              {"parallel", limits.parallel},
              {"time_limit", limits.time_limit ? Json(*limits.time_limit) : Json()}}},
            {"samples", !sample_files().empty()}};
}

}  // namespace spectralpack::server
