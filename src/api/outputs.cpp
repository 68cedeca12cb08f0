#include <fcntl.h>
#include <linux/stat.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/atomic_file.hpp"
#include "formats/packing_file.hpp"
#include "spectralpack/files.hpp"
#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

std::string text_of_error(int error) { return std::generic_category().message(error); }

/// What a file or folder is marked as (STATX_ATTR_...); 0 where that is not known.
std::uint64_t marks_of(const fs::path& path) {
    struct statx status {};
    if (statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, 0, &status) != 0) return 0;
    return status.stx_attributes;
}

/// In a folder like /tmp each may replace his own files only.
bool is_kept_for_its_owner(const fs::path& folder, const struct stat& file) {
    struct stat owner {};
    const uid_t user = geteuid();
    return stat(folder.c_str(), &owner) == 0 && (owner.st_mode & S_ISVTX) != 0 && user != 0 && user != owner.st_uid &&
           user != file.st_uid;
}

/// Why the file that is there cannot be replaced, or no file can have this name; empty where one can.
std::string why_not_replaced(const fs::path& path, const fs::path& folder) {
    struct stat file {};
    if (lstat(path.c_str(), &file) != 0) return errno == ENOENT ? "" : text_of_error(errno);
    if (S_ISDIR(file.st_mode) || fs::is_directory(path)) return "that is a folder";
    const std::uint64_t marks = marks_of(path);
    if (marks & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) return "that file is marked so that nobody can replace it";
    if (marks & STATX_ATTR_MOUNT_ROOT) return "that file is mounted there and cannot be replaced";
    if (is_kept_for_its_owner(folder, file)) return "that file is another user's";
    return "";
}

/// Makes an empty file and removes it. The system's error; 0 where that went well.
int failure_to_make(const fs::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) return errno;
    const int failure = write(file, "\n", 1) == 1 ? 0 : errno;  // on a full disk there is room for a name, but no more
    close(file);
    unlink(path.c_str());
    return failure;
}

}  // namespace

void require_writable(const fs::path& path, const std::string& what) {
    const auto refuse = [&](const std::string& why) {
        if (!why.empty()) throw UsageError(what + ": " + why);
    };
    std::error_code unknown;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, unknown)) refuse("there is no folder " + folder.string());
    refuse(why_not_replaced(path, folder));
    const std::uint64_t marks = marks_of(folder);
    const int failure =
        marks & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND) ? EROFS : failure_to_make(temporary_file(path));
    if (failure == ENOSPC || failure == EDQUOT) throw ResourceError(what + ": " + text_of_error(failure));
    if (failure == EACCES || failure == EROFS) refuse("its folder is read-only");
    if (failure != 0) refuse(text_of_error(failure));
}

void require_nameable(const Job& job, const fs::path& path) {
    if (ending_of(path) == ".json") require_mesh_paths(mesh_files(job), path.parent_path());
}

bool has_tray_files(const fs::path& path) { return ending_of(path) != ".json"; }

fs::path tray_file(fs::path path, std::int64_t tray) {
    const std::string name = path.stem().string() + "-" + std::to_string(tray) + path.extension().string();
    return path.replace_filename(name);
}

}  // namespace spectralpack
