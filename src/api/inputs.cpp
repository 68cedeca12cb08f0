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

bool is_scale(double scale) { return scale >= kLeastScale && scale <= kMostScale; }

std::string scales_text() { return "from " + short_number(kLeastScale) + " to " + short_number(kMostScale); }

/// The text behind the last `mark`, where that is made of these characters.
std::optional<std::string> behind(const std::string& text, char mark, const char* characters) {
    const std::size_t at = text.rfind(mark);
    if (at == std::string::npos || at == 0 || at + 1 == text.size()) return std::nullopt;
    if (text.find_first_not_of(characters, at + 1) != std::string::npos) return std::nullopt;
    return text.substr(at + 1);
}

/// All of `text` as a number.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc{} && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

[[noreturn]] void fail_at_scale(const std::string& argument, const std::string& text) {
    throw UsageError("'" + argument + "': the scale '" + text + "' must be a number " + scales_text() +
                     (text.find(',') != std::string::npos ? ", and its decimal sign is a point" : ""));
}

int count_in(const std::string& argument, const std::string& text) {
    const std::optional<int> count = number_in<int>(text);
    if (count && *count >= 1 && *count <= kMaxCount) return *count;
    throw UsageError("'" + argument + "': the count '" + text + "' must be a whole number from 1 to " +
                     std::to_string(kMaxCount));
}

double scale_in(const std::string& argument, const std::string& text) {
    const std::optional<double> scale = number_in<double>(text);
    if (!scale || !is_scale(*scale)) fail_at_scale(argument, text);
    return *scale;
}

/// FILE:COUNT, FILE@SCALE or FILE:COUNT@SCALE, when `argument` reads so.
std::optional<CountAndScale> split_argument(const std::string& argument) {
    // A comma is among them to be told of.
    constexpr const char *kOfCounts = "+-.,0123456789", *kOfScales = "+-.,0123456789eE";
    CountAndScale result{argument};
    const auto cut = [&](const std::string& number) { result.file.resize(result.file.size() - number.size() - 1); };
    const auto scale = behind(result.file, '@', kOfScales);
    if (scale) cut(*scale);
    const auto count = behind(result.file, ':', kOfCounts);
    if (count) cut(*count);
    if (!count && !scale) return std::nullopt;
    if (count) result.count = count_in(argument, *count);
    if (scale) result.scale = scale_in(argument, *scale);
    return result;
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
        if (!exists && !(split && fs::exists(split->file, failure))) require_count_and_scale(text);
        any(split.value_or(CountAndScale{text, 1, 1}));
    }

    ExpandedInputs take() {
        if (inputs_.parts.empty() && inputs_.job) {
            add_unusable({inputs_.job->file, "parts", "names nothing to pack"}, {inputs_.job->file});
        }
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
                Part part{.name = utf8 ? row.name : from_windows_1252(row.name),
                          .mesh = mesh_of(base, row.mesh, utf8),
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
