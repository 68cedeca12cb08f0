#pragma once
/// How the library talks while it works: it never prints. All calls come from the thread that called in.

#include <cstdint>
#include <optional>
#include <string>

namespace spectralpack {

enum class Phase { load, voxelize, search, disassemble, reinsert, check, render, write };

struct Progress {
    Phase phase = Phase::load;
    std::int64_t done = 0;
    std::int64_t total = 0;
    /// Of the packing so far, 0..1; only in Phase::search. None where the container has no ceiling to fill up to.
    std::optional<double> density = 0;
    double work = 0;            ///< share of the phase's expected work that is done, 0..1
    std::int64_t verified = 0;  ///< placements a second engine answered alike so far; only with --verify-with
    int order = 0, orders = 0;  ///< where several orders are packed in: which, from 1, of how many
};

class Listener {
  public:
    virtual ~Listener() = default;
    virtual void on_progress(const Progress&) {}
    /// Something the user should know that stops nothing; one line, names the file it is about.
    virtual void on_warning(const std::string&) {}
};

}  // namespace spectralpack
