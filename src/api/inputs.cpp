#include "spectralpack/files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <regex>
#include <system_error>

#include "api/folder_inputs.hpp"
#include "formats/job_file.hpp"
#include "formats/set_file.hpp"
#include "formats/settings_file.hpp"
#include "formats/text_encoding.hpp"
#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxCount = 10'000'000;

struct CountAndScale {
    std::string file = {};
    int count = 1;
    double scale = 1;
};

[[noreturn]] void fail_at_scale(const std::string& argument, const std::string& text) {
    throw UsageError("'" + argument + "': the scale '" + text + "' must be a number above 0" +
                     (text.find(',') != std::string::npos ? ", and its decimal sign is a point" : ""));
}

int count_in(const std::string& argument, const std::string& text) {
    int count = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, count);
    if (parsed.ec != std::errc{} || parsed.ptr != end || count < 1 || count > kMaxCount) {
        throw UsageError("'" + argument + "': the count '" + text + "' must be a whole number from 1 to " +
                         std::to_string(kMaxCount));
    }
    return count;
}

double scale_in(const std::string& argument, const std::string& text) {
    double scale = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, scale);
    if (parsed.ec != std::errc{} || parsed.ptr != end || !(scale > 0) || !std::isfinite(scale)) {
        fail_at_scale(argument, text);
    }
    return scale;
}

/// FILE:COUNT, FILE@SCALE or FILE:COUNT@SCALE, when `argument` reads so.
std::optional<CountAndScale> split_argument(const std::string& argument) {
    static const std::regex with_count(R"(^([\s\S]+):([+-]?[0-9.]+)(?:@([^@:/]*))?$)");
    static const std::regex with_scale(R"(^([\s\S]+)@([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)$)");
    std::smatch match;
    if (std::regex_match(argument, match, with_count)) {
        CountAndScale result{match[1]};
        result.count = count_in(argument, match[2]);
        if (match[3].matched) result.scale = scale_in(argument, match[3]);
        return result;
    }
    if (std::regex_match(argument, match, with_scale)) {
        CountAndScale result{match[1]};
        result.scale = scale_in(argument, match[2]);
        return result;
    }
    return std::nullopt;
}

/// Where the argument begins with a file that is there, and goes on with what is no count or scale.
void require_count_and_scale(const std::string& argument) {
    for (std::size_t at = argument.find_last_of(":@"); at != std::string::npos && at > 0;
         at = argument.find_last_of(":@", at - 1)) {
        const std::string file = argument.substr(0, at), rest = argument.substr(at + 1);
        std::error_code failure;
        if (rest.find('/') != std::string::npos) return;
        if (!fs::exists(file, failure)) continue;
        if (argument[at] == '@' && rest.find_first_of(":@") == std::string::npos) fail_at_scale(argument, rest);
        throw UsageError("'" + argument +
                         "' is no file, and its ending no count and scale: write FILE:COUNT@SCALE, like " + file +
                         ":2@1.5 (a whole number from 1 to " + std::to_string(kMaxCount) +
                         ", and a number above 0 with a decimal point)");
    }
}

/// "no such file or folder", and one with a name like it that is there.
std::string absence_of(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::vector<std::string> names;
    std::error_code failure;
    for (auto entry = fs::directory_iterator(folder, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        names.push_back(entry->path().filename().string());
    }
    std::ranges::sort(names);
    const auto near = nearest_word(file.filename().string(), names);
    return "no such file or folder" + (near ? "; near it: " + *near : "");
}

int product(int count, int times, const std::string& file, const std::string& place) {
    if (count > kMaxCount / times) {
        throw InputError(file, place, "comes to over ten million copies");
    }
    return count * times;
}

class Expander {
  public:
    Expander(fs::path mesh_dir, const JobSettings& defaults) : defaults_(defaults), mesh_dir_(std::move(mesh_dir)) {}

    void argument(const std::string& text) {
        std::error_code failure;
        const bool exists = fs::exists(text, failure);
        const auto split = exists ? std::nullopt : split_argument(text);
        if (!exists && !(split && fs::exists(split->file, failure))) require_count_and_scale(text);
        any(split.value_or(CountAndScale{text, 1, 1}));
    }

    ExpandedInputs take() { return std::move(inputs_); }

  private:
    void any(const CountAndScale& wanted) {
        const std::string& file = wanted.file;
        std::error_code failure;
        const fs::file_status status = fs::status(file, failure);
        const std::string ending = ending_of(file);
        if (!fs::exists(status)) {
            const bool absent = !failure || failure == std::errc::no_such_file_or_directory;
            add_unusable({file, "", absent ? absence_of(file) : failure.message()}, wanted);
        } else if (fs::is_directory(status)) {
            folder(file, wanted);
        } else if (ending == ".csv") {
            set(file, wanted);
        } else if (ending == ".json") {
            job(file, wanted);
        } else {
            inputs_.parts.push_back({.mesh = file, .count = wanted.count, .scale = wanted.scale});
        }
    }

    void set(const std::string& file, const CountAndScale& wanted) {
        const fs::path base = mesh_dir_.empty() ? fs::path(file).parent_path() : mesh_dir_;
        std::vector<Part> parts;
        try {
            const std::vector<SetRow> rows = read_set(file);
            const bool utf8 =
                std::ranges::all_of(rows, [](const SetRow& row) { return is_utf8(row.mesh) && is_utf8(row.name); });
            if (!utf8) inputs_.remarks.push_back(file + " is not UTF-8 and was read as Windows-1252");
            for (const SetRow& row : rows) {
                const std::string place = "line " + std::to_string(row.line);
                const int count = product(row.count, wanted.count, file, place);
                parts.push_back({.name = utf8 ? row.name : from_windows_1252(row.name),
                                 .mesh = mesh_of(base, row.mesh, utf8),
                                 .count = count,
                                 .scale = row.scale * wanted.scale,
                                 .gap = row.gap,
                                 .orientations = row.orientations,
                                 .unit = row.unit,
                                 .priority = row.priority,
                                 .due = row.due,
                                 .value = row.value,
                                 .origin = file + " " + place});
            }
        } catch (const InputError& error) {
            add_unusable(error, wanted);
            return;
        }
        std::move(parts.begin(), parts.end(), std::back_inserter(inputs_.parts));
    }

    /// A file whose name has these very bytes is that file.
    static std::string mesh_of(const fs::path& base, const std::string& mesh, bool utf8) {
        std::error_code failure;
        if (utf8 || fs::exists(base / mesh, failure)) return (base / mesh).string();
        return (base / from_windows_1252(mesh)).string();
    }

    void job(const std::string& file, const CountAndScale& wanted) {
        if (inputs_.job) {
            throw UsageError(file + ": is the second job file, after " + inputs_.job->file + "; one run has one job");
        }
        JobFile job = read_job(file, defaults_);
        for (Part& part : job.parts) {
            part.count = product(part.count, wanted.count, file, part.origin + ".count");
            part.scale *= wanted.scale;
            part.origin = file + " " + part.origin;
            inputs_.parts.push_back(std::move(part));
        }
        inputs_.job = std::move(job.settings);
    }

    void folder(const std::string& root, const CountAndScale& wanted) {
        const FolderInputs found = inputs_in(root);
        for (const std::string& file : found.meshes) {
            inputs_.parts.push_back({.mesh = file, .count = wanted.count, .scale = wanted.scale, .origin = root});
        }
        for (const InputError& error : found.unusable) {
            add_unusable(error, wanted);
        }
        append(found.passed_over, inputs_.passed_over);
        append(found.own_builds, inputs_.own_builds);
    }

    /// It keeps its place and its count, and is left over.
    void add_unusable(const InputError& problem, const CountAndScale& wanted) {
        inputs_.parts.push_back(
            {.mesh = problem.file(), .count = wanted.count, .scale = wanted.scale, .problem = problem});
    }

    template <class Element>
    static void append(const std::vector<Element>& some, std::vector<Element>& all) {
        all.insert(all.end(), some.begin(), some.end());
    }

    const JobSettings& defaults_;
    fs::path mesh_dir_;
    ExpandedInputs inputs_;
};

}  // namespace

ExpandedInputs expand_inputs(const std::vector<std::string>& arguments, const fs::path& mesh_dir,
                             const JobSettings& defaults) {
    Expander expander(mesh_dir, defaults);
    for (const std::string& argument : arguments) {
        expander.argument(argument);
    }
    return expander.take();
}

JobSettings read_defaults(const std::vector<fs::path>& files, const std::string& profile) {
    JobSettings settings;
    read_settings(files, profile, settings);
    settings.sized = false;  // nobody says it of this job: a build that is topped up keeps its tray
    return settings;
}

std::string printers_json(std::span<const Printer> printers) { return printers_to_json(printers); }

}  // namespace spectralpack
