#pragma once
/// What is made from the option table and the commands: each as the text of one file.

#include <string>
#include <vector>

#include "command_info.hpp"

namespace spectralpack::docs {

std::string job_schema();  ///< docs/job.schema.json

std::string command_line(const std::vector<CommandInfo>& commands);  ///< docs/cli.md
std::string man_page(const std::vector<CommandInfo>& commands);      ///< spectralpack.1

std::string bash_completion(const std::vector<CommandInfo>& commands);  ///< spectralpack.bash
std::string zsh_completion(const std::vector<CommandInfo>& commands);   ///< _spectralpack
std::string fish_completion(const std::vector<CommandInfo>& commands);  ///< spectralpack.fish

}  // namespace spectralpack::docs
