#include "spectralpack/tools/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "spectralpack/error.hpp"
#include "tools/bench/runner.hpp"
#include "tools/bench/write_table.hpp"

namespace spectralpack::tools {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kPeers = "4";  // the table that other programs are in, too

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        list += (list.empty() ? "" : ", ") + name;
    }
    return list;
}

/// Of a table's rows those with one of `wanted` in the first two columns; all where nothing is asked for.
void keep_wanted(Table& table, const std::vector<std::string>& wanted) {
    if (wanted.empty()) return;
    std::erase_if(table.rows, [&](const Row& row) {
        const std::string columns = row.set + ", " + row.setting;
        return std::none_of(wanted.begin(), wanted.end(),
                            [&](const std::string& text) { return columns.find(text) != std::string::npos; });
    });
}

/// The tables to run, with their wanted rows.
std::vector<Table> wanted_tables(const BenchOptions& options) {
    const bool all = std::ranges::find(options.tables, kAll) != options.tables.end();
    const std::vector<std::string>& known = bench_tables();
    std::vector<Table> tables;
    for (const std::string& name : all ? known : options.tables) {
        if (std::ranges::find(known, name) == known.end()) {
            throw UsageError(fmt::format("there is no table '{}'; {}, or one of {}", name, kAll, listed(known)));
        }
        Table table = make_table(name, options.scale);
        keep_wanted(table, options.rows);
        if (!table.rows.empty()) {
            tables.push_back(std::move(table));
        } else if (!all) {
            throw UsageError(fmt::format("table {} has no row with the text of --rows in 'set, setting'", name));
        }
    }
    if (tables.empty()) throw UsageError("no table has a row with the text of --rows in 'set, setting'");
    return tables;
}

/// The other programs that are run on a table's rows.
std::span<const BenchPeer> peers_of(const Table& table, const BenchOptions& options) {
    return table.name == kPeers ? std::span(options.peers) : std::span<const BenchPeer>();
}

int runs_of(const std::vector<Table>& tables, const BenchOptions& options) {
    int runs = 0;
    for (const Table& table : tables) {
        const int programs = 1 + static_cast<int>(peers_of(table, options).size());
        for (const Row& row : table.rows) {
            runs += ((row.tray ? 1 : 0) + (row.fixed ? 1 : 0)) * programs;
        }
    }
    return runs;
}

}  // namespace

BenchSummary bench(const BenchOptions& options, BenchListener& listener, const StopToken& stop) {
    const std::vector<Table> tables = wanted_tables(options);
    OutcomeStore store(options.folder / "runs");
    BenchSets sets(options.folder / "sets", options.sets, options.mesh_dir, options.scale);
    Runner runner(store, sets, options, runs_of(tables, options), listener, stop);
    for (const Table& table : tables) {
        std::vector<RanRow> rows;
        const auto add = [&](RanRow row) {
            if (row.tray || row.fixed) rows.push_back(std::move(row));
        };
        for (const Row& row : table.rows) {
            add(runner.run(row));
            for (const BenchPeer& peer : peers_of(table, options)) {
                add(runner.run(peer, row));
            }
            write_table(table, rows, options.folder);
            write_all_tables(options.folder);
        }
        listener.on_table(markdown(table, rows));
    }
    return {runner.failed(), stop.reason()};
}

}  // namespace spectralpack::tools
