#pragma once
/// Journals in memory whose checksums are sound, whatever their records say: a fuzzer cannot guess checksums.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "api/input_hash.hpp"
#include "api/journal/journal_file.hpp"
#include "mesh_checks.hpp"

namespace spectralpack {

class JournalInMemory {
  public:
    JournalInMemory() : file_(memfd_create("journal", 0)) { expect(file_ >= 0, "there is room in memory"); }
    ~JournalInMemory() { close(file_); }
    JournalInMemory(const JournalInMemory&) = delete;
    JournalInMemory& operator=(const JournalInMemory&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

    void write(const std::vector<std::string>& records) const {
        std::ofstream out(path(), std::ios::binary | std::ios::trunc);
        std::string hash;
        for (const std::string& record : records) {
            hash = chained_hash(hash, record);
            out << hash << ' ' << record << '\n';
        }
    }

  private:
    int file_;
};

/// Up to where decisions begin.
inline std::vector<std::string> head_of(std::vector<std::string> records) {
    records.erase(std::find(records.begin(), records.end(), "begun") + 1, records.end());
    return records;
}

/// Each line is a record.
inline void append_lines(std::vector<std::string>& records, const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (end > at) records.push_back(text.substr(at, end - at));
        at = end + 1;
    }
}

}  // namespace spectralpack
