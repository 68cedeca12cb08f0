#include "formats/file_bytes.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/stopped.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kReadAtOnce = 16 << 20;  // that a disk reads in a tenth of a second

struct Descriptor {
    int number;
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw InputError(path.string(), "", std::generic_category().message(error));
}

/// Huge pages for large files: the kernel's handing out of small ones takes as long as copying the
/// file into them.
char* allocate(std::size_t size) {
    constexpr std::size_t kHugePage = 2 << 20;
    if (size < kHugePage) return static_cast<char*>(std::malloc(std::max<std::size_t>(size, 1)));
    const std::size_t rounded = (size + kHugePage - 1) / kHugePage * kHugePage;
    void* bytes = std::aligned_alloc(kHugePage, rounded);
    if (bytes) ::madvise(bytes, rounded, MADV_HUGEPAGE);  // only a hint
    return static_cast<char*>(bytes);
}

}  // namespace

void FileBytes::Free::operator()(char* bytes) const { std::free(bytes); }

FileBytes::FileBytes(const std::filesystem::path& path, const StopToken& stop) {
    // Not blocking: a named pipe would wait for a writer before it could be refused.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file.number < 0 || ::fstat(file.number, &status) != 0) fail(path, errno);
    if (S_ISDIR(status.st_mode)) throw InputError(path.string(), "", "is a folder, not a file");
    if (!S_ISREG(status.st_mode)) throw InputError(path.string(), "", "is not a regular file");
    const auto size = static_cast<std::size_t>(status.st_size);
    bytes_.reset(allocate(size));
    if (!bytes_) {
        throw ResourceError(path.string() + ": there is no memory for its " + std::to_string(size) + " bytes");
    }
    while (size_ < size) {
        throw_if_stopped(stop);
        const ssize_t got = ::read(file.number, bytes_.get() + size_, std::min(size - size_, kReadAtOnce));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path, errno);
        if (got == 0) break;  // it shrank meanwhile; the parser sees a short file
        size_ += static_cast<std::size_t>(got);
    }
}

}  // namespace spectralpack
