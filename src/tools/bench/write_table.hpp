#pragma once
/// Tables as files: Markdown, CSV and plots.

#include <filesystem>
#include <vector>

#include "tools/bench/runner.hpp"

namespace spectralpack::tools {

/// What is known of the rows so far, as Markdown.
std::string markdown(const Table& table, const std::vector<RanRow>& rows);

/// Writes table-NAME.md, .csv and, where some run took long enough to see how its time grows, .svg.
void write_table(const Table& table, const std::vector<RanRow>& rows, const std::filesystem::path& folder);

/// Writes benchmarks.md: all tables that are in the folder, whenever they were made, and their plots.
void write_all_tables(const std::filesystem::path& folder);

}  // namespace spectralpack::tools
