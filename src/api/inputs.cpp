#include "spectralpack/files.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <system_error>

#include "api/folder_inputs.hpp"
#include "api/short_number.hpp"
#include "formats/job_file.hpp"
#include "formats/set_file.hpp"
#include "formats/settings_file.hpp"
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

bool is_scale(double scale) { return scale >= kLeastScale && scale <= kMostScale; }

std::string scales_text() { return "from " + short_number(kLeastScale) + " to " + short_number(kMostScale); }

/// The text behind the last `mark`, where that is made of these characters.
std::optional<std::string> behind(const std::string& text, char mark, const char* characters) {
    const std::size_t at = text.rfind(mark);
    if (at == std::string::npos || at == 0 || at + 1 == text.size()) return std::nullopt;
    if (text.find_first_not_of(characters, at + 1) != std::string::npos) return std::nullopt;
    return text.substr(at + 1);
}

/// FILE:COUNT, FILE@SCALE or FILE:COUNT@SCALE, when `argument` reads so.
std::optional<CountAndScale> split_argument(const std::string& argument) {
    constexpr const char *kOfCounts = "+-.0123456789", *kOfScales = "+-.0123456789eE";
    const auto read = [&](const std::string& text, auto& value, const char* what) {
        const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
        if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size() || !(value > 0)) {
            throw UsageError("'" + argument + "': the " + what + " '" + text + "' must be a positive number");
        }
    };
    CountAndScale result{argument};
    const auto cut = [&](const std::string& number) { result.file.resize(result.file.size() - number.size() - 1); };
    const auto scale = behind(result.file, '@', kOfScales);
    if (scale) cut(*scale);
    const auto count = behind(result.file, ':', kOfCounts);
    if (count) cut(*count);
    if (!count && !scale) return std::nullopt;
    if (count) read(*count, result.count, "count");
    if (result.count > kMaxCount) throw UsageError("'" + argument + "': over ten million copies");
    if (scale) read(*scale, result.scale, "scale");
    if (!is_scale(result.scale)) {
        throw UsageError("'" + argument + "': the scale '" + *scale + "' must be " + scales_text());
    }
    return result;
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

double scaled(double scale, double times, const std::string& file, const std::string& place) {
    if (is_scale(scale * times)) return scale * times;
    throw InputError(file, place,
                     "comes to a scale of " + short_number(scale * times) + ", which must be " + scales_text());
}

/// Rows of a set that say the same, but for how many.
bool alike(const Part& a, const Part& b) {
    return a.mesh.file() == b.mesh.file() && a.name == b.name && a.scale == b.scale && a.gap == b.gap &&
           a.orientations == b.orientations && a.unit == b.unit && a.priority == b.priority && a.due == b.due &&
           a.value == b.value;
}

class Expander {
  public:
    Expander(fs::path mesh_dir, const JobSettings& defaults) : defaults_(defaults), mesh_dir_(std::move(mesh_dir)) {}

    void argument(const std::string& text) {
        std::error_code failure;
        const bool exists = fs::exists(text, failure);
        const auto split = exists ? std::nullopt : split_argument(text);
        any(split.value_or(CountAndScale{text, 1, 1}));
    }

    ExpandedInputs take() {
        const bool nothing = inputs_.parts.empty() && inputs_.unusable.empty();
        if (nothing && inputs_.job) inputs_.unusable.emplace_back(inputs_.job->file, "parts", "names nothing to pack");
        return std::move(inputs_);
    }

  private:
    void any(const CountAndScale& wanted) {
        const std::string& file = wanted.file;
        std::error_code failure;
        const fs::file_status status = fs::status(file, failure);
        const std::string ending = ending_of(file);
        if (!fs::exists(status)) {
            const bool absent = !failure || failure == std::errc::no_such_file_or_directory;
            inputs_.unusable.emplace_back(file, "", absent ? absence_of(file) : failure.message());
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
            for (const SetRow& row : read_set(file)) {
                const std::string place = "line " + std::to_string(row.line);
                const int count = product(row.count, wanted.count, file, place);
                Part part{.name = row.name,
                          .mesh = (base / row.mesh).string(),
                          .count = count,
                          .scale = scaled(row.scale, wanted.scale, file, place),
                          .gap = row.gap,
                          .orientations = row.orientations,
                          .unit = row.unit,
                          .priority = row.priority,
                          .due = row.due,
                          .value = row.value,
                          .origin = file + " " + place};
                // One part, not thousands that are each prepared by themselves.
                const bool again = !parts.empty() && alike(parts.back(), part);
                if (again && parts.back().count <= kMaxCount - count) {
                    parts.back().count += count;
                } else {
                    parts.push_back(std::move(part));
                }
            }
            if (parts.empty()) throw InputError(file, "", "names no part: it has a header and nothing else");
        } catch (const InputError& error) {
            inputs_.unusable.push_back(error);
            return;
        }
        std::move(parts.begin(), parts.end(), std::back_inserter(inputs_.parts));
    }

    void job(const std::string& file, const CountAndScale& wanted) {
        if (inputs_.job) {
            throw UsageError(file + ": is the second job file, after " + inputs_.job->file + "; one run has one job");
        }
        JobFile job = read_job(file, defaults_);
        for (Part& part : job.parts) {
            part.count = product(part.count, wanted.count, file, part.origin + ".count");
            part.scale = scaled(part.scale, wanted.scale, file, part.origin + ".scale");
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
        append(found.unusable, inputs_.unusable);
        append(found.passed_over, inputs_.passed_over);
        append(found.own_builds, inputs_.own_builds);
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
