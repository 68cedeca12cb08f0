#pragma once
/// Commands and options that are not there, and what was probably meant.

#include <CLI/CLI.hpp>
#include <string>

namespace spectralpack::cli {

/// What is wrong with arguments that `app` did not take: the first command or option that is not there, with one that
/// is near it, before what `error` says.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace spectralpack::cli
