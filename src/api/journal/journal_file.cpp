#include "api/journal/journal_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "api/input_hash.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kHashDigits = 16;
constexpr std::chrono::milliseconds kBetweenSyncs{1000};

std::string system_reason() { return std::generic_category().message(errno); }

}  // namespace

JournalText read_journal(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) throw InputError(path.string(), "", "cannot be read");
    JournalText text;
    while (text.bytes < bytes.size()) {
        const std::size_t end = bytes.find('\n', text.bytes);
        const std::size_t length = end == std::string::npos ? 0 : end - text.bytes;
        if (length <= kHashDigits || bytes[text.bytes + kHashDigits] != ' ') break;
        std::string record = bytes.substr(text.bytes + kHashDigits + 1, length - kHashDigits - 1);
        std::string hash = chained_hash(text.last_hash, record);
        if (bytes.compare(text.bytes, kHashDigits, hash) != 0) break;
        text.records.push_back(std::move(record));
        text.last_hash = std::move(hash);
        text.bytes = end + 1;
    }
    text.damaged = text.bytes < bytes.size();
    return text;
}

JournalFile::JournalFile(std::filesystem::path path, double after, const JournalText* standing)
    : path_(std::move(path)), after_(after) {
    if (standing) {
        standing_bytes_ = standing->bytes;
        last_hash_ = standing->last_hash;
    }
    if (after_ <= 0 || standing) open();
    try {
        thread_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {
        fail("no thread can be started");
    }
}

JournalFile::~JournalFile() {
    {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
    if (file_ >= 0) close(file_);
}

void JournalFile::add(const std::string& record) {
    const std::scoped_lock lock(mutex_);
    if (failure_) return;
    last_hash_ = chained_hash(last_hash_, record);
    const std::string line = last_hash_ + ' ' + record + '\n';
    if (file_ < 0) {
        waiting_ += line;
    } else {
        write(line);
    }
}

std::optional<std::string> JournalFile::failure() const {
    const std::scoped_lock lock(mutex_);
    return failure_;
}

/// Makes the file in its time, and sees to it that what is written reaches the disk.
void JournalFile::watch() {
    using Seconds = std::chrono::duration<double>;
    std::unique_lock lock(mutex_);
    if (file_ < 0) {
        changed_.wait_for(lock, Seconds(std::min(after_, 1e9)), [this] { return ended_; });
        if (ended_) return;
        open();
    }
    while (!ended_ && !failure_) {
        changed_.wait_for(lock, kBetweenSyncs, [this] { return ended_; });
        if (!std::exchange(dirty_, false)) continue;
        const int file = file_;
        lock.unlock();  // the run goes on meanwhile
        const bool synced = fdatasync(file) == 0 || errno == EINVAL || errno == EROFS;
        lock.lock();
        if (!synced) fail(system_reason());
    }
}

/// Calls come with the mutex locked, or before there is a thread.
void JournalFile::open() {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) return fail(system_reason());
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
        close(std::exchange(file_, -1));
        return fail("another run is writing it");
    }
    if (ftruncate(file_, static_cast<off_t>(standing_bytes_.value_or(0))) != 0) return fail(system_reason());
    on_disk_ = true;
    write(std::exchange(waiting_, {}));
}

void JournalFile::write(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return fail(system_reason());
        done += static_cast<std::size_t>(count);
    }
    dirty_ = true;
}

void JournalFile::fail(const std::string& why) {
    failure_ = why;
    waiting_.clear();
}

}  // namespace spectralpack
