#include "spectralpack/files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <regex>
#include <system_error>

#include "formats/job_file.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/set_file.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxCount = 10'000'000;

struct CountAndScale {
    std::string file;
    int count = 1;
    double scale = 1;
};

/// FILE:COUNT or FILE:COUNT@SCALE, when `argument` reads so.
std::optional<CountAndScale> split_argument(const std::string& argument) {
    static const std::regex pattern(R"(^([\s\S]+):([+-]?[0-9.]+)(?:@([^@:/]*))?$)");
    std::smatch match;
    if (!std::regex_match(argument, match, pattern)) return std::nullopt;
    const auto number = [&](const std::string& text, auto& value, const char* what) {
        const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
        if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size() || !(value > 0) ||
            !std::isfinite(static_cast<double>(value))) {
            throw UsageError("'" + argument + "': the " + what + " '" + text + "' must be a positive number");
        }
    };
    CountAndScale result{match[1], 1, 1};
    number(match[2], result.count, "count");
    if (result.count > kMaxCount) throw UsageError("'" + argument + "': over ten million copies");
    if (match[3].matched) number(match[3], result.scale, "scale");
    return result;
}

int product(int count, int times, const std::string& file, const std::string& place) {
    if (count > kMaxCount / times) {
        throw InputError(file, place, "comes to over ten million copies");
    }
    return count * times;
}

class Expander {
  public:
    explicit Expander(fs::path mesh_dir) : mesh_dir_(std::move(mesh_dir)) {}

    void argument(const std::string& text) {
        std::error_code failure;
        const bool exists = fs::exists(text, failure);
        const auto split = exists ? std::nullopt : split_argument(text);
        any(split.value_or(CountAndScale{text, 1, 1}));
    }

    ExpandedInputs take() { return std::move(inputs_); }

  private:
    void any(const CountAndScale& wanted) {
        const std::string& file = wanted.file;
        std::error_code failure;
        const fs::file_status status = fs::status(file, failure);
        const std::string ending = fs::path(file).extension().string();
        if (!fs::exists(status)) {
            const bool absent = !failure || failure == std::errc::no_such_file_or_directory;
            inputs_.unusable.emplace_back(file, "", absent ? "no such file or folder" : failure.message());
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
                parts.push_back({.mesh = (base / row.mesh).string(),
                                 .count = count,
                                 .scale = row.scale * wanted.scale,
                                 .origin = file + " " + place});
            }
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
        JobFile job = read_job(file);
        for (Part& part : job.parts) {
            part.count = product(part.count, wanted.count, file, part.origin + ".count");
            part.scale *= wanted.scale;
            part.origin = file + " " + part.origin;
            inputs_.parts.push_back(std::move(part));
        }
        inputs_.job = std::move(job.settings);
    }

    void folder(const std::string& root, const CountAndScale& wanted) {
        std::vector<std::string> found;
        std::error_code failure;
        auto entries = fs::recursive_directory_iterator(root, failure);
        while (!failure && entries != fs::recursive_directory_iterator()) {
            const fs::directory_entry& entry = *entries;
            std::error_code broken;
            const bool is_folder = fs::is_directory(fs::status(entry.path(), broken));
            if (is_mesh_file(entry.path())) {
                if (broken) {  // a symbolic link that leads nowhere or in circles
                    inputs_.unusable.emplace_back(entry.path().string(), "", broken.message());
                } else if (is_folder) {
                    inputs_.unusable.emplace_back(entry.path().string(), "",
                                                  "is a folder with the name of a mesh file");
                } else {
                    found.push_back(entry.path().string());
                }
            }
            entries.increment(failure);
        }
        if (failure) inputs_.unusable.emplace_back(root, "", failure.message());
        if (found.empty() && !failure) {
            inputs_.unusable.emplace_back(root, "", "the folder holds no mesh files");
        }
        std::sort(found.begin(), found.end());  // bytewise
        for (const std::string& file : found) {
            inputs_.parts.push_back({.mesh = file, .count = wanted.count, .scale = wanted.scale, .origin = root});
        }
    }

    fs::path mesh_dir_;
    ExpandedInputs inputs_;
};

}  // namespace

ExpandedInputs expand_inputs(const std::vector<std::string>& arguments, const fs::path& mesh_dir) {
    Expander expander(mesh_dir);
    for (const std::string& argument : arguments) {
        expander.argument(argument);
    }
    return expander.take();
}

}  // namespace spectralpack
