#include "jobs/text_files.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

#include <spectralpack/error.hpp>

namespace spectralpack::server {

namespace fs = std::filesystem;

std::optional<std::string> read_text(const fs::path& path, std::uintmax_t most) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (error || bytes > most) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    std::string text(bytes, '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(bytes))) return std::nullopt;
    return text;
}

std::optional<Json> read_json(const fs::path& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) return std::nullopt;
    Json json = Json::parse(*text, nullptr, false);
    if (json.is_discarded()) return std::nullopt;
    return json;
}

void write_text(const fs::path& path, const std::string& text) {
    const fs::path temporary = path.parent_path() / ("." + path.filename().string() + ".new");
    {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file << text;
        file.flush();
        if (!file)
            throw ResourceError("cannot write " + path.string() + ": the disk is full, or the folder is read-only");
    }
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) throw ResourceError("cannot write " + path.string() + ": " + error.message());
}

std::uintmax_t bytes_in(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code gone;
        if (it->is_regular_file(gone)) bytes += it->file_size(gone);
    }
    return bytes;
}

}  // namespace spectralpack::server
