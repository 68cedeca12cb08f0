#pragma once
/// A file of records to which more are added while a run goes on: one line each, with a checksum that depends on all
/// lines before it. What was added last may be torn; what stands before that is whole.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace spectralpack {

/// What a journal holds, up to the first line that is torn or damaged.
struct JournalText {
    std::vector<std::string> records;
    std::size_t bytes = 0;  ///< of these lines
    std::string last_hash;  ///< which the next line's depends on
    bool damaged = false;   ///< something stood after them
};

/// Throws InputError where the file cannot be read.
JournalText read_journal(const std::filesystem::path& path);

/// Adds records. The file is made once `after` seconds have gone by; until then they are held in memory, and where the
/// run ends before, there never is one. Each record is handed to the system as it comes, and is on the disk two seconds
/// later, as far as the system tells. What cannot be written ends the journal, not the run.
class JournalFile {
  public:
    /// Goes on after `standing`, which was read from the file; with null its contents are replaced.
    JournalFile(std::filesystem::path path, double after, const JournalText* standing);
    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    void add(const std::string& record);

    const std::filesystem::path& path() const { return path_; }
    bool on_disk() const { return on_disk_; }
    /// Why no more is written; none: it is.
    std::optional<std::string> failure() const;

  private:
    void watch();
    void open();
    void write(const std::string& bytes);
    void fail(const std::string& why);

    std::filesystem::path path_;
    std::optional<std::size_t> standing_bytes_;  // of the file that are kept
    std::string last_hash_;
    double after_;

    mutable std::mutex mutex_;  // of all that follows
    std::condition_variable changed_;
    std::string waiting_;  // lines until the file is made
    int file_ = -1;
    bool dirty_ = false, ended_ = false;
    std::optional<std::string> failure_;
    std::atomic<bool> on_disk_ = false;
    std::thread thread_;
};

}  // namespace spectralpack
