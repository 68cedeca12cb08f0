#include "tools/bench/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <ctime>
#include <fstream>
#include <thread>

#include "spectralpack/files.hpp"
#include "spectralpack/tools/inspect.hpp"
#include "tools/bench/child.hpp"
#include "tools/bench/commit.hpp"
#include "tools/bench/pack_progress.hpp"

namespace spectralpack::tools {
namespace {

namespace fs = std::filesystem;

std::string shell_word(const std::string& word) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return std::isalnum(c) || std::string_view("-_./=:,+@%").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) {
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return quoted + "'";
}

std::string command_line(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + shell_word(word);
    }
    return text;
}

std::string machine_text() {
    std::ifstream processors("/proc/cpuinfo");
    std::string model = "unknown processor";
    for (std::string line; std::getline(processors, line);) {
        if (!line.starts_with("model name")) continue;
        model = line.substr(line.find(':') + 2);
        break;
    }
    return fmt::format("{}, {} processors", model, std::thread::hardware_concurrency());
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
    return text;
}

std::string what_of(const Row& row, const char* kind) { return fmt::format("{}, {}, {}", row.set, row.setting, kind); }

void measure(const Packing& packing, Outcome& outcome) {
    outcome.copies = packing.metrics.copies;
    outcome.placed = packing.metrics.placed;
    outcome.trays = static_cast<int>(packing.trays.size());
    outcome.density = packing.metrics.density;
    outcome.planned = true;
    for (const TrayPacking& tray : packing.trays) {
        outcome.own_box = tray.density_bounding_box;
        outcome.box_volume = tray.bounding_box.volume();
        outcome.height = tray.height;
        outcome.planned = outcome.planned && tray.disassembly && tray.disassembly->complete;
    }
    for (const Unplaced& copy : packing.unplaced) {
        outcome.interlocked += copy.reason == UnplacedReason::cannot_leave ? 1 : 0;
        outcome.cut_off = outcome.cut_off || copy.reason == UnplacedReason::not_tried;
    }
    outcome.cut_off = outcome.cut_off || (packing.options.interlock != Interlock::off && !outcome.planned);
    const PhaseSeconds& seconds = packing.metrics.seconds;
    outcome.load = seconds.load;
    outcome.voxelize = seconds.voxelize;
    outcome.search = seconds.search;
    outcome.refine = seconds.refine;
    outcome.disassemble = seconds.disassemble;
    outcome.reinsert = seconds.reinsert;
    outcome.peak_memory = packing.metrics.peak_memory;
}

/// In trays with a ceiling the tables count heights as the paper does, but where a row says otherwise.
void add_papers_heights(std::vector<std::string>& words) {
    const auto has = [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
    if (has("--open-height") || has("--minimise") || has("--height-at")) return;
    words.insert(words.end(), {"--height-at", "bottom"});
    if (!has("--height-penalty")) words.insert(words.end(), {"--height-penalty", "auto"});
}

std::string filled_in(std::string command, const std::string& name, const std::string& value) {
    const std::string placeholder = "{" + name + "}";
    for (std::size_t at = 0; (at = command.find(placeholder, at)) != std::string::npos; at += value.size()) {
        command.replace(at, placeholder.size(), value);
    }
    return command;
}

/// Of a table's "480x245x200".
Vec3 size_of(const std::string& tray) {
    Vec3 size;
    const char* at = tray.data();
    for (int axis = 0; axis < 3; ++axis) {
        at = std::from_chars(at, tray.data() + tray.size(), size[axis]).ptr + 1;
    }
    return size;
}

}  // namespace

Runner::Runner(OutcomeStore& store, BenchSets& sets, const BenchOptions& options, int runs, BenchListener& listener,
               const StopToken& stop)
    : store_(store),
      sets_(sets),
      options_(options),
      runs_(runs),
      listener_(listener),
      stop_(stop),
      program_(hash_of_file(options.program)) {}

RanRow Runner::run(const Row& row) {
    RanRow ran{row, {}, {}};
    if (row.tray) ran.tray = run(what_of(row, "tray"), *row.tray, row.options);
    if (row.fixed) ran.fixed = run(what_of(row, "fixed set"), *row.fixed, row.options);
    return ran;
}

RanRow Runner::run(const BenchPeer& peer, const Row& row) {
    RanRow ran{row, {}, {}};
    ran.row.setting = peer.name;
    ran.row.paper.clear();
    const auto size_in = [](const Task& task) { return task.container.at(1); };
    if (row.tray) ran.tray = run_peer(what_of(ran.row, "tray"), peer, *row.tray, size_in(*row.tray), true);
    if (row.fixed) {
        ran.fixed = run_peer(what_of(ran.row, "fixed set"), peer, *row.fixed, size_in(*row.fixed) + "x10000", false);
    }
    return ran;
}

void Runner::stamp(Outcome& outcome) const {
    outcome.program = "spectralpack " SPECTRALPACK_VERSION;
    outcome.commit = kCommit;
    outcome.machine = machine_text();
    outcome.date = today();
    std::ifstream("/proc/loadavg") >> outcome.busy;
}

void Runner::begin(const std::string& what) { listener_.on_run({++run_, runs_, what}); }

void Runner::fail(const std::string& why) {
    listener_.on_failure(why);
    ++failed_;
}

void Runner::keep(const std::string& key, const Outcome& outcome) const {
    store_.keep(key, outcome);
    listener_.on_done({outcome.command, outcome.seconds, outcome.cut_off});
}

std::optional<Outcome> Runner::found(const std::string& key) {
    std::optional<Outcome> before = store_.find(key);
    if (before) ++run_;
    return before;
}

std::optional<Outcome> Runner::run(const std::string& what, const Task& task, const std::vector<std::string>& options) {
    if (stop_.stopped()) return std::nullopt;
    const SetOnDisk& set = sets_.at(task.set);
    std::vector<std::string> words{"pack", set.file.string()};
    if (!set.mesh_dir.empty()) words.insert(words.end(), {"--mesh-dir", set.mesh_dir});
    std::vector<std::string> into = task.container;
    if (!task.letter.empty()) into = {"--container", sets_.letters().string() + "/letter-" + task.letter + ".stl"};
    for (const std::vector<std::string>& more : {into, options, options_.pack_options}) {
        words.insert(words.end(), more.begin(), more.end());
    }
    add_papers_heights(words);
    if (options_.time_limit) words.insert(words.end(), {"--time-limit", fmt::format("{}", *options_.time_limit)});

    std::uint64_t inputs = hash_of(command_line(words), hash_of(fmt::format("{} {}", program_, set.contents)));
    const auto container = std::find(words.begin(), words.end(), "--container");
    if (container != words.end()) inputs = hash_of_file(*(container + 1), inputs);
    const std::string key = fmt::format("{:016x}", inputs);
    if (auto before = found(key)) return before;

    const fs::path packing = store_.folder() / (key + ".json");
    Outcome outcome;
    outcome.command = "spectralpack " + command_line(words);
    stamp(outcome);
    words.insert(words.begin(), options_.program.string());
    words.insert(words.end(), {"--progress", "json", "-o", packing.string()});
    begin(what);
    std::ofstream log(store_.folder() / (key + ".log"));
    const auto line = [&](const std::string& text) {
        log << text << std::endl;
        const std::optional<BenchProgress> progress = parse_progress(text);
        if (!progress) return;
        listener_.on_progress(*progress);
        auto& trace = outcome.trace;
        if (progress->phase != "search" || (!trace.empty() && progress->done <= trace.back().first)) return;
        trace.emplace_back(progress->done, progress->seconds);
    };
    const Ended ended = run_program(words, line, stop_);
    if (stop_.stopped()) return std::nullopt;
    if (ended.status != 0) {
        fail(fmt::format("exit status {}: {}\n{}", ended.status, outcome.command, ended.last_words));
        return std::nullopt;
    }
    measure(load_scene(packing).packing, outcome);
    outcome.seconds = ended.wall_seconds;
    outcome.cpu_seconds = ended.cpu_seconds;
    keep(key, outcome);
    return outcome;
}

std::optional<Outcome> Runner::run_peer(const std::string& what, const BenchPeer& peer, const Task& task,
                                        const std::string& tray, bool closed) {
    if (stop_.stopped()) return std::nullopt;
    const SetOnDisk& set = sets_.at(task.set);
    std::string files, counted;
    std::int64_t copies = 0;
    for (const Part& part : expand_inputs({set.file.string()}, set.mesh_dir).parts) {
        counted += fmt::format(" {} {}", part.count, shell_word(part.mesh.file()));
        copies += part.count;
        for (int copy = 0; copy < part.count; ++copy) {
            files += " " + shell_word(part.mesh.file());
        }
    }
    std::string command = filled_in(filled_in(peer.command, "set", shell_word(set.file.string())), "tray", tray);
    const std::string key = fmt::format("{:016x}", hash_of(command, set.contents));
    if (auto before = found(key)) return before;

    const fs::path out = store_.folder() / (key + ".stl");
    Outcome outcome;
    outcome.command = command;
    stamp(outcome);
    outcome.program = peer.name;
    outcome.copies = copies;
    command = filled_in(filled_in(command, "files", files), "counted", counted);
    if (options_.time_limit)
        command = fmt::format("timeout -s INT {} sh -c {}", *options_.time_limit, shell_word(command));
    begin(what);
    std::ofstream log(store_.folder() / (key + ".log"));
    const Ended ended = run_program(
        {"/bin/sh", "-c", filled_in(command, "out", shell_word(out.string()))},
        [&](const std::string& line) { log << line << std::endl; }, stop_);
    if (stop_.stopped()) return std::nullopt;
    const auto left = inspect(expand_inputs({out.string()}, ""), {});
    if (left.empty() || left.front().objects.empty()) {
        fail(fmt::format("{}: exit status {} and no mesh in {}: {}\n{}", peer.name, ended.status, out.string(),
                         outcome.command, ended.last_words));
        return std::nullopt;
    }
    double volume = 0;
    Box box;
    for (const InspectedObject& object : left.front().objects) {
        volume += object.figures.volume;
        box.add(object.figures.box);
    }
    const Vec3 room = size_of(tray);
    const Vec3 taken = box.size();
    if (taken.x > room.x || taken.y > room.y || taken.z > room.z) {
        fail(fmt::format("{} leaves a packing of {:g}x{:g}x{:g} mm, which is no answer for {}", peer.name, taken.x,
                         taken.y, taken.z, tray));
        return std::nullopt;
    }
    outcome.trays = 1;
    outcome.density = volume / (room.x * room.y * (closed ? room.z : taken.z));
    outcome.own_box = volume / box.volume();
    outcome.box_volume = box.volume();
    outcome.height = box.size().z;
    outcome.seconds = ended.wall_seconds;
    outcome.cpu_seconds = ended.cpu_seconds;
    outcome.peak_memory = ended.peak_memory;
    keep(key, outcome);
    return outcome;
}

}  // namespace spectralpack::tools
