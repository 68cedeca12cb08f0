#include "passed_over.hpp"

#include <fmt/format.h>

namespace spectralpack::cli {
namespace {

constexpr std::size_t kMostFiles = 8;

/// "a.step, b.pdf and 3 more".
std::string listed(const std::vector<std::string>& files) {
    std::string list;
    for (std::size_t i = 0; i < files.size() && i < kMostFiles; ++i) {
        list += (i > 0 ? ", " : "") + files[i];
    }
    if (files.size() > kMostFiles) list += fmt::format(" and {} more", files.size() - kMostFiles);
    return list;
}

}  // namespace

void report_passed_over(const ExpandedInputs& inputs, Listener& display) {
    for (const std::string& remark : inputs.remarks) {
        display.on_warning(remark);
    }
    if (!inputs.passed_over.empty()) {
        const bool one = inputs.passed_over.size() == 1;
        display.on_warning(fmt::format("{} that {} no mesh this program reads {} passed over: {}",
                                       one ? "a file" : fmt::format("{} files", inputs.passed_over.size()),
                                       one ? "holds" : "hold", one ? "is" : "are", listed(inputs.passed_over)));
    }
    if (!inputs.own_builds.empty()) {
        const bool one = inputs.own_builds.size() == 1;
        display.on_warning(
            fmt::format("{} by this program {} a whole build, not parts, and {} passed over: {}. {}",
                        one ? "a 3MF written" : fmt::format("{} 3MF written", inputs.own_builds.size()),
                        one ? "holds" : "hold", one ? "is" : "are", listed(inputs.own_builds),
                        one ? "To pack its parts, name the file." : "To pack their parts, name the files."));
    }
}

}  // namespace spectralpack::cli
