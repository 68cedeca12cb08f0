#include "run_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <new>
#include <system_error>

#include "time_shares.hpp"

namespace spectralpack::cli {
namespace {

/// "28 Nov 2026", where the program runs.
std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    if (!localtime_r(&now, &local)) return "";
    static constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    return fmt::format("{} {} {}", local.tm_mday, kMonths[local.tm_mon], local.tm_year + 1900);
}

}  // namespace

ReportDetails RunOutputs::report_details() const {
    ReportDetails details;
    details.job_name = settings_.job_name.value_or(std::filesystem::path(settings_.file).stem().string());
    details.date = today();
    details.material = settings_.material.value_or("");
    details.material_density = settings_.material_density;
    return details;
}

/// False where it failed, which is told.
template <class Write>
bool RunOutputs::attempt(const std::string& file, const Write& write) {
    try {
        write();
        return true;
    } catch (const Error& error) {
        display_.on_error(error.what());
    } catch (const std::bad_alloc&) {
        display_.on_error("out of memory while " + file + " was made");
    }
    return false;
}

void RunOutputs::write_trays(const Scene& finished) {
    for (; trays_ < finished.packing.trays.size(); ++trays_) {
        for (const std::string& output : settings_.outputs) {
            if (is_picture(output)) continue;
            attempt(output, [&] { of_trays_.insert(write_tray(finished, trays_, output, settings_.options.threads)); });
        }
    }
}

bool RunOutputs::write(const Scene& scene, const DrawingTime& time, RunFacts& facts) {
    bool all = true;
    std::int64_t done = 0;
    const auto total = static_cast<std::int64_t>(settings_.outputs.size() + settings_.reports.size());
    const int threads = settings_.options.threads;
    const std::size_t trays = scene.packing.trays.size();
    const auto tell = [&] {
        ++done;
        display_.on_progress({Phase::write, done, total, 0, static_cast<double>(done) / static_cast<double>(total)});
    };
    std::vector<std::string> outputs = settings_.outputs;
    std::stable_partition(outputs.begin(), outputs.end(), std::not_fn(is_picture));  // what takes longest comes last
    for (const std::string& output : outputs) {
        all &= attempt(output, [&] {
            WrittenFile written{output, {}};
            const auto files = write_output(scene, output, threads, time);
            if (files.empty()) {
                display_.on_warning(output + " is left out for time; 'spectralpack render' draws it from a .json");
                return;
            }
            if (is_picture(output) && trays > 1 && files.size() <= trays) {
                display_.on_warning(fmt::format("{} of {} trays' own pictures of {} are left out for time",
                                                trays + 1 - files.size(), trays, output));
            }
            for (std::size_t i = 1; i < files.size(); ++i) {
                written.trays.push_back(files[i].string());
            }
            for (const std::filesystem::path& file : files) {
                of_trays_.erase(file);
            }
            facts.written.push_back(std::move(written));
        });
        tell();
    }
    for (const std::string& report : settings_.reports) {
        all &= attempt(report, [&] {
            const int left_out = write_report(scene, report, report_details(), threads, time);
            if (left_out > 0) {
                display_.on_warning(fmt::format("{} picture{} of {} {} left out for time", left_out,
                                                left_out == 1 ? "" : "s", report, left_out == 1 ? "is" : "are"));
            }
            facts.reports.push_back(report);
        });
        tell();
    }
    if (all) {
        for (const std::filesystem::path& file : of_trays_) {
            std::error_code ignored;
            std::filesystem::remove(file, ignored);
        }
    }
    return all;
}

}  // namespace spectralpack::cli
