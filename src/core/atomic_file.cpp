#include "core/atomic_file.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace spectralpack {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestName = 255;  ///< bytes, of a file in its folder
constexpr std::size_t kProcessDigits = 10;

/// Temporary names are this, the number of the process, and the ending, which is kept because some writers choose the
/// format by it.
std::string temporary_stem(const fs::path& path) {
    const std::string before = ".", behind = ".part", ending = path.extension().string();
    const std::size_t taken = before.size() + behind.size() + kProcessDigits + ending.size();
    std::string stem = path.stem().string();
    std::size_t length = std::min(stem.size(), kLongestName - std::min(kLongestName, taken));
    const auto inside_character = [&] { return (static_cast<unsigned char>(stem[length]) & 0xc0) == 0x80; };
    while (length > 0 && length < stem.size() && inside_character()) {
        --length;
    }
    stem.resize(length);
    return before + stem + behind;
}

/// Removes temporary files of `path` whose processes are gone: they were killed.
void remove_leftovers(const fs::path& folder, const fs::path& path) {
    const std::string stem = temporary_stem(path), ending = path.extension().string();
    std::error_code ignored;
    std::vector<fs::path> leftovers;
    for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.size() <= stem.size() + ending.size() || !name.starts_with(stem) || !name.ends_with(ending)) continue;
        const char* const first = name.data() + stem.size();
        const char* const last = name.data() + name.size() - ending.size();
        pid_t process = 0;
        const auto [after, error] = std::from_chars(first, last, process);
        if (error != std::errc() || after != last || process <= 0) continue;
        if (::kill(process, 0) != 0 && errno == ESRCH) leftovers.push_back(entry->path());
    }
    for (const fs::path& leftover : leftovers) {
        fs::remove(leftover, ignored);
    }
}

}  // namespace

ResourceError write_failure(const fs::path& path) {
    const std::string reason =
        errno == 0 ? "the disk is full or the folder is read-only" : std::generic_category().message(errno);
    return ResourceError("cannot write " + path.string() + ": " + reason);
}

fs::path temporary_file(const fs::path& path) {
    return path.parent_path() / (temporary_stem(path) + std::to_string(::getpid()) + path.extension().string());
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder)) {
        throw ResourceError("cannot write " + path.string() + ": there is no folder " + folder.string());
    }
    remove_leftovers(folder, path);
    const fs::path temporary = temporary_file(path);
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
