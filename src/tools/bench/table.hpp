#pragma once
/// What `bench` runs: tables of rows, each a set packed with some options of `pack`, in a container that overflows and
/// as a fixed set.

#include <optional>
#include <string>
#include <vector>

#include "spectralpack/tools/bench.hpp"

namespace spectralpack::tools {

/// One run of `pack`.
struct Task {
    std::string set;                     ///< a set's name; "pieces:500" for its first 500 copies
    std::vector<std::string> container;  ///< options that say what is packed into
    std::string letter = "";             ///< of the generated ones, which is the container instead
};

/// Two kinds of quality, because a tray that overflows is the denser the more hollow parts are left out.
struct Row {
    std::string set, setting;          ///< for people
    std::vector<std::string> options;  ///< of both tasks
    std::optional<Task> tray;          ///< a tray that need not hold all: its density
    std::optional<Task> fixed;         ///< copies that all have to be placed: their height, or the number of trays
    std::string paper = "";            ///< the paper's figures for its own sets
};

struct Table {
    std::string name, title;
    std::string note = "";
    bool phases = false;  ///< shares of time per phase are of interest
    bool boxes = false;   ///< the volume of the packing's box is, and the time that a copy takes
    std::vector<Row> rows = {};
};

/// `name` is one of bench_tables().
Table make_table(const std::string& name, BenchScale scale);

}  // namespace spectralpack::tools
