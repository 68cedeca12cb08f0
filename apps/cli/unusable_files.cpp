#include "unusable_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "text.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::size_t kWidestName = 30;  ///< beside which the causes still have room

std::vector<std::string> names_of(const std::vector<InputError>& errors) {
    std::map<std::string, int> alike;
    for (const InputError& error : errors) {
        ++alike[std::filesystem::path(error.file()).filename().string()];
    }
    std::vector<std::string> names;
    for (const InputError& error : errors) {
        const std::string name = std::filesystem::path(error.file()).filename().string();
        names.push_back(printable(name.empty() || alike[name] > 1 ? error.file() : name));
    }
    return names;
}

}  // namespace

std::vector<std::string> unusable_lines(const std::vector<InputError>& errors) {
    const std::vector<std::string> names = names_of(errors);
    std::size_t widest = 0;
    for (const std::string& name : names) {
        widest = std::max(widest, std::min(columns_of(name), kWidestName));
    }
    std::vector<std::string> lines{errors.size() == 1
                                       ? "1 file cannot be used and is left out:"
                                       : fmt::format("{} files cannot be used and are left out:", errors.size())};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const std::string& place = errors[i].place();
        const std::string why = printable(place.empty() ? errors[i].cause() : place + ": " + errors[i].cause());
        const std::size_t columns = columns_of(names[i]);
        std::string head = "  " + names[i] + std::string(widest + 3 - std::min(columns, widest), ' ');
        std::istringstream rest(wrapped(why, kScreenWidth - widest - 5));
        for (std::string line; std::getline(rest, line);) {
            lines.push_back(head + line);
            head.assign(widest + 5, ' ');
        }
    }
    return lines;
}

}  // namespace spectralpack::cli
