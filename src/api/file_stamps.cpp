#include "api/file_stamps.hpp"

#include <sys/stat.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "core/remarks.hpp"
#include "formats/file_bytes.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/files.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kMostFilesNamed = 12;

/// Size and times of a file; none where it is not there.
std::optional<FileState> state_of(const std::string& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return std::nullopt;
    return FileState{status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ctim.tv_sec,
                     status.st_ctim.tv_nsec};
}

/// Of what is in a file; none where it cannot be read.
std::optional<FileHash> hash_of(const std::string& file, const StopToken& stop = {}) {
    try {
        const FileBytes bytes(file, stop);
        const XXH128_hash_t hash = XXH3_128bits(bytes.view().data(), bytes.view().size());
        return FileHash{hash.high64, hash.low64};
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

FileStamps::FileStamps(const Job& job, const Workers& workers) {
    for (const std::string& file : mesh_files(job)) {
        stamps_.push_back({file});
    }
    workers.for_each(static_cast<std::int64_t>(stamps_.size()), [&](std::int64_t i) {
        Stamp& stamp = stamps_[static_cast<std::size_t>(i)];
        stamp.state = state_of(stamp.file);
        stamp.hash = hash_of(stamp.file, workers.stop());
    });
}

void FileStamps::warn_of_changes(Listener& listener) const {
    std::vector<std::string> changed, gone;
    for (const Stamp& stamp : stamps_) {
        if (!stamp.hash) continue;  // of which the loader told
        const std::optional<FileState> state = state_of(stamp.file);
        if (!state) {
            gone.push_back(stamp.file);
        } else if (state != stamp.state && hash_of(stamp.file) != stamp.hash) {
            changed.push_back(stamp.file);
        }
    }
    const std::string before = "; the packing is of what was there when the run began";
    if (!changed.empty()) listener.on_warning("changed meanwhile: " + listed(changed, kMostFilesNamed) + before);
    if (!gone.empty()) listener.on_warning("gone meanwhile: " + listed(gone, kMostFilesNamed) + before);
}

}  // namespace spectralpack
