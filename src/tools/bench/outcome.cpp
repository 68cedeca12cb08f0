#include "tools/bench/outcome.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <system_error>

#include "core/atomic_file.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::tools {
namespace {

namespace fs = std::filesystem;

/// Calls visit(name, value) for every value but the trace: the one list of what a file holds.
template <class AnyOutcome, class Visit>
void for_each_value(AnyOutcome& o, const Visit& visit) {
    visit("command", o.command);
    visit("program", o.program);
    visit("commit", o.commit);
    visit("machine", o.machine);
    visit("date", o.date);
    visit("cut-off", o.cut_off);
    visit("copies", o.copies);
    visit("placed", o.placed);
    visit("interlocked", o.interlocked);
    visit("planned", o.planned);
    visit("trays", o.trays);
    visit("density", o.density);
    visit("own-box", o.own_box);
    visit("box-volume", o.box_volume);
    visit("height", o.height);
    visit("seconds", o.seconds);
    visit("cpu-seconds", o.cpu_seconds);
    visit("busy", o.busy);
    visit("load", o.load);
    visit("voxelize", o.voxelize);
    visit("search", o.search);
    visit("refine", o.refine);
    visit("disassemble", o.disassemble);
    visit("reinsert", o.reinsert);
    visit("peak-memory", o.peak_memory);
}

constexpr const char* kEnd = "end";  // the last line

void read_value(std::istringstream& in, std::string& value) { std::getline(in >> std::ws, value); }

/// As read_value() reads it.
template <class Value>
std::string text_of(const Value& value) {
    return fmt::format("{}", value);
}
std::string text_of(bool value) { return value ? "1" : "0"; }

template <class Number>
void read_value(std::istringstream& in, Number& value) {
    in >> value;
}

}  // namespace

OutcomeStore::OutcomeStore(fs::path folder) : folder_(std::move(folder)) {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure) throw ResourceError("cannot make the folder " + folder_.string() + ": " + failure.message());
}

std::optional<Outcome> OutcomeStore::find(const std::string& key) const {
    std::ifstream file(folder_ / (key + ".txt"));
    Outcome outcome;
    bool whole = false;
    for (std::string line; std::getline(file, line);) {
        std::istringstream in(line);
        std::string name;
        in >> name;
        if (name == "trace") {
            auto& [placed, seconds] = outcome.trace.emplace_back();
            in >> placed >> seconds;
        }
        for_each_value(outcome, [&](const char* known, auto& value) {
            if (name == known) read_value(in, value);
        });
        whole = whole || name == kEnd;
    }
    if (!whole) return std::nullopt;
    return outcome;
}

void OutcomeStore::keep(const std::string& key, const Outcome& outcome) const {
    std::string text;
    for_each_value(outcome,
                   [&](const char* name, const auto& value) { text += fmt::format("{} {}\n", name, text_of(value)); });
    for (const auto& [placed, seconds] : outcome.trace) {
        text += fmt::format("trace {} {}\n", placed, seconds);
    }
    replace_file(folder_ / (key + ".txt"), text + kEnd + "\n");
}

}  // namespace spectralpack::tools
