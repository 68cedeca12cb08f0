#pragma once
/// Small files of a job's folder, whole or not at all.

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace spectralpack::server {

using Json = nlohmann::ordered_json;

/// None where it is not there, cannot be read, or is longer than `most` bytes.
std::optional<std::string> read_text(const std::filesystem::path& path, std::uintmax_t most = std::uintmax_t{1} << 30);

/// None also where it is no JSON.
std::optional<Json> read_json(const std::filesystem::path& path);

/// To a temporary name beside it, then renamed. Throws ResourceError naming the file.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Bytes of all files in a folder and below; 0 where there is none.
std::uintmax_t bytes_in(const std::filesystem::path& folder);

}  // namespace spectralpack::server
