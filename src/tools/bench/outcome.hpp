#pragma once
/// What became of one run, and the keeping of it on disk.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spectralpack::tools {

struct Outcome {
    std::string command;  ///< for people to repeat it
    std::string program, commit, machine, date;
    bool cut_off = false;  ///< by the time limit
    std::int64_t copies = 0, placed = 0, interlocked = 0;
    bool planned = false;  ///< there is a whole plan to take it apart
    int trays = 0;
    double density = 0;     ///< of the container; of many, the mean
    double own_box = 0;     ///< of the packing's own box; of many trays, of the last
    double box_volume = 0;  ///< mm^3, of that box
    double height = 0;      ///< mm; of many trays, of the last
    double seconds = 0, cpu_seconds = 0;
    double busy = 0;  ///< load of the machine when it began
    double load = 0, voxelize = 0, search = 0, refine = 0, disassemble = 0, reinsert = 0;
    std::int64_t peak_memory = 0;
    std::vector<std::pair<std::int64_t, double>> trace;  ///< copies placed, seconds of search until then
};

/// Outcomes by key, one file each, written whole or not at all: what was done before is not done again.
class OutcomeStore {
  public:
    explicit OutcomeStore(std::filesystem::path folder);

    std::optional<Outcome> find(const std::string& key) const;  ///< none also where the file is not whole
    void keep(const std::string& key, const Outcome& outcome) const;

    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

}  // namespace spectralpack::tools
