#include "core/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace spectralpack {

namespace fs = std::filesystem;

ResourceError write_failure(const fs::path& path) {
    const std::string reason =
        errno == 0 ? "the disk is full or the folder is read-only" : std::generic_category().message(errno);
    return ResourceError("cannot write " + path.string() + ": " + reason);
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder)) {
        throw ResourceError("cannot write " + path.string() + ": there is no folder " + folder.string());
    }
    // The ending is kept because some writers choose the format by it.
    fs::path temporary =
        folder / ("." + path.stem().string() + ".part" + std::to_string(::getpid()) + path.extension().string());
    std::error_code ignored;
    try {
        errno = 0;
        write(temporary);
        std::error_code failure;
        fs::rename(temporary, path, failure);
        if (failure) {
            throw ResourceError("cannot write " + path.string() + ": " + failure.message());
        }
    } catch (...) {
        fs::remove(temporary, ignored);
        throw;
    }
}

void replace_file(const fs::path& path, std::string_view bytes) {
    replace_file(path, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) throw write_failure(path);
    });
}

}  // namespace spectralpack
