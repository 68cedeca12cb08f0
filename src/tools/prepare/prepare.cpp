#include "spectralpack/tools/prepare.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>

#include "core/parallel.hpp"
#include "formats/json_text.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/files.hpp"
#include "tools/prepare/prepare_files.hpp"

namespace spectralpack::tools {
namespace {

namespace fs = std::filesystem;

/// What the results depend on, besides the meshes.
std::string settings_text(const PrepareOptions& options) {
    const PrepareRules& rules = options.rules;
    return "tray " + json_number(rules.tray.x) + "x" + json_number(rules.tray.y) + "x" + json_number(rules.tray.z) +
           ", triangles " + std::to_string(rules.triangles) + ", unit " + json_number(options.unit);
}

void check_rules(const PrepareOptions& options) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(options.rules.tray[axis] >= options.rules.least_side)) {
            throw UsageError("every side of --tray must be at least " + json_number(options.rules.least_side) + " mm");
        }
    }
    if (options.rules.triangles < 4) throw UsageError("--triangles must be at least 4");
}

bool lies_in(const fs::path& inner, const fs::path& outer) {
    const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
    return end == outer.end();
}

std::string in_one_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        line += (line.empty() ? "" : "; ") + word;
    }
    return line;
}

/// Prepares the files of one folder.
class Preparation {
  public:
    Preparation(const fs::path& folder, const fs::path& output, const PrepareOptions& options)
        : folder_(folder), output_(output), options_(options) {
        const ExpandedInputs inputs = expand_inputs({folder.string()}, "");
        const auto drop = [&](const std::string& file, const std::string& why) {
            const std::string name = fs::path(file).lexically_relative(folder).string();
            unusable_.push_back({name, 0, std::string(to_string(Prepared::unusable)), why, "", 0, 0, {}, 0, 1, ""});
        };
        for (const Part& part : inputs.parts) {
            const std::string name = fs::path(part.mesh.file()).lexically_relative(folder).string();
            if (!part.problem) {
                names_.insert(name);
                continue;
            }
            if (name == "." || part.mesh.file() == folder.string()) throw InputError(*part.problem);
            drop(part.mesh.file(), part.problem->cause());
        }
        for (const std::string& file : inputs.own_builds) {
            drop(file, "is a whole build, written by this program");
        }
    }

    const std::set<std::string>& names() const { return names_; }
    const std::vector<PreparedRow>& unusable() const { return unusable_; }

    /// What the file is like now, without rows.
    PreparedFile stamp(const std::string& name) const {
        std::error_code failure;
        PreparedFile file;
        file.bytes = static_cast<std::int64_t>(fs::file_size(folder_ / name, failure));
        const auto time = fs::last_write_time(folder_ / name, failure);
        file.modified = static_cast<std::int64_t>(time.time_since_epoch().count());
        return file;
    }

    /// Whether what is known of a file still holds, and its results are there.
    bool holds(const std::string& name, const PreparedFile& known) const {
        const PreparedFile now = stamp(name);
        return now.bytes == known.bytes && now.modified == known.modified &&
               std::all_of(known.rows.begin(), known.rows.end(),
                           [&](const PreparedRow& row) { return row.mesh.empty() || fs::exists(output_ / row.mesh); });
    }

    /// Reads a file and writes what is kept of it.
    PreparedFile prepare_file(const std::string& name) const {
        PreparedFile file = stamp(name);
        std::vector<LoadedMesh> loaded;
        try {
            loaded = read_meshes(folder_ / name, options_.unit);
        } catch (const InputError& error) {
            const std::string cause = error.place().empty() ? error.cause() : error.place() + ": " + error.cause();
            file.rows.push_back({name, 0, std::string(to_string(Prepared::unusable)), cause, "", 0, 0, {}, 0, 1, ""});
            return file;
        }
        for (std::size_t i = 0; i < loaded.size(); ++i) {
            file.rows.push_back(prepare_object(name, loaded[i], static_cast<int>(i) + 1, loaded.size() > 1));
        }
        return file;
    }

  private:
    PreparedRow prepare_object(const std::string& name, const LoadedMesh& loaded, int object, bool one_of_many) const {
        const double unit = loaded.unit.value_or(options_.unit);
        const PreparedMesh prepared =
            prepare_mesh(unit == 1 ? loaded.mesh : transformed(loaded.mesh, {unit * Mat3{}, {}}), options_.rules);
        PreparedRow row;
        row.file = name;
        row.object = object;
        row.outcome = to_string(prepared.outcome);
        row.detail = prepared.detail;
        row.triangles_before = static_cast<std::int64_t>(loaded.mesh.triangles.size());
        row.scale = prepared.scale;
        row.repairs = in_one_line(loaded.repairs);
        if (prepared.outcome != Prepared::kept) return row;
        row.mesh = result_name(name, one_of_many ? object : 0);
        row.triangles_after = static_cast<std::int64_t>(prepared.mesh.triangles.size());
        row.size = bounding_box(prepared.mesh).size();
        row.volume = signed_volume(prepared.mesh);
        std::error_code failure;
        fs::create_directories((output_ / row.mesh).parent_path(), failure);
        if (failure) {
            throw ResourceError("cannot make the folder " + (output_ / row.mesh).parent_path().string() + ": " +
                                failure.message());
        }
        write_stl(prepared.mesh, output_ / row.mesh);
        return row;
    }

    /// The path of a file's result: its own where it is an STL, otherwise with what makes it another file's.
    std::string result_name(const std::string& name, int object) const {
        if (object == 0 && fs::path(name).extension() == ".stl") return name;
        std::string result = name + (object > 0 ? "-" + std::to_string(object) : "");
        while (names_.contains(result + ".stl")) {
            result += "_";
        }
        return result + ".stl";
    }

    fs::path folder_, output_;
    PrepareOptions options_;
    std::set<std::string> names_;        // mesh files, relative to the folder
    std::vector<PreparedRow> unusable_;  // named like meshes, but no files
};

/// The report, the set file, and the counts.
void write_results(const Preparation& preparation, const PrepareJournal& journal, PrepareSummary& summary) {
    std::vector<PreparedRow> report = preparation.unusable();
    std::vector<SetRow> set;
    for (const std::string& name : preparation.names()) {
        const auto file = journal.files().find(name);
        if (file == journal.files().end()) continue;
        report.insert(report.end(), file->second.rows.begin(), file->second.rows.end());
        for (const PreparedRow& row : file->second.rows) {
            if (!row.mesh.empty()) set.push_back({row.mesh, 1, 1, 0});
        }
    }
    for (const PreparedRow& row : report) {
        if (const auto outcome = from_string<Prepared>(row.outcome)) ++summary.meshes[*outcome];
    }
    write_prepare_report(report, summary.report_file);
    write_set(set, summary.set_file);
}

}  // namespace

PrepareSummary prepare(const fs::path& folder, const fs::path& output, const PrepareOptions& options,
                       const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    const StopToken& stop = control.stop;
    check_rules(options);
    if (!fs::is_directory(folder)) throw InputError(folder.string(), "", "no such folder");
    if (lies_in(fs::weakly_canonical(output), fs::canonical(folder))) {
        throw UsageError("-o " + output.string() + " lies in the folder that is prepared: use one beside it");
    }
    const Preparation preparation(folder, output, options);
    std::error_code failure;
    fs::create_directories(output, failure);
    if (failure) throw ResourceError("cannot make the folder " + output.string() + ": " + failure.message());

    PrepareSummary summary;
    summary.set_file = output / "set.csv";
    summary.report_file = output / "report.csv";
    PrepareJournal journal(output / "journal.csv", settings_text(options));
    std::vector<std::string> to_do;
    for (const std::string& name : preparation.names()) {
        const auto known = journal.files().find(name);
        if (known == journal.files().end() || !preparation.holds(name, known->second)) to_do.push_back(name);
    }
    summary.files = static_cast<std::int64_t>(preparation.names().size());
    summary.earlier = summary.files - static_cast<std::int64_t>(to_do.size());
    summary.done = summary.earlier;

    const Workers workers(options.threads);
    const auto batch = static_cast<std::size_t>(4 * workers.threads());
    for (std::size_t begin = 0; begin < to_do.size() && !stop.stopped(); begin += batch) {
        const std::size_t size = std::min(batch, to_do.size() - begin);
        std::vector<std::optional<PreparedFile>> done(size);
        workers.for_each(static_cast<std::int64_t>(size), [&](std::int64_t i) {
            const auto k = static_cast<std::size_t>(i);
            if (!stop.stopped()) done[k] = preparation.prepare_file(to_do[begin + k]);
        });
        for (std::size_t k = 0; k < size; ++k) {
            if (!done[k]) continue;
            journal.add(to_do[begin + k], std::move(*done[k]));
            ++summary.done;
        }
        listener.on_progress({Phase::load, summary.done, summary.files, 0,
                              static_cast<double>(summary.done) / static_cast<double>(summary.files)});
    }
    summary.stopped = summary.done < summary.files ? stop.reason() : StopReason::none;
    write_results(preparation, journal, summary);
    return summary;
}

}  // namespace spectralpack::tools
