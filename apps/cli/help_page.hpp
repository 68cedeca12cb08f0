#pragma once
/// The help of `pack`, from the option table: --help has the options that people use, --help-all every one.

#include <CLI/CLI.hpp>
#include <string>

namespace spectralpack::cli {

/// What is said of `pack` before any option: its first nine lines, which `pack` alone prints.
std::string pack_help_head();
/// What is said at its end: the exit statuses.
std::string pack_help_foot();

class PackHelp : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace spectralpack::cli
