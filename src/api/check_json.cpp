#include <algorithm>
#include <string>

#include "formats/json_text.hpp"
#include "formats/packing_file.hpp"
#include "spectralpack/check.hpp"
#include "spectralpack/files.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack {
namespace {

/// "[a, b, c]" of texts that are JSON already.
template <class List, class Text>
std::string json_list(const List& list, const Text& text) {
    std::string joined;
    for (const auto& item : list) {
        joined += (joined.empty() ? "" : ", ") + text(item);
    }
    return "[" + joined + "]";
}

std::string int_list(const std::vector<int>& list) {
    return json_list(list, [](int i) { return std::to_string(i); });
}

const char* json_truth(bool value) { return value ? "true" : "false"; }

const char* interlocking_word(const CheckReport& report) {
    if (report.plans_complete()) return "none";
    const auto missing = [](const auto& plan) { return !plan; };
    if (std::all_of(report.plans.begin(), report.plans.end(), missing)) return "not checked";
    return "not shown to be free";
}

}  // namespace

std::string check_report_json(const Scene& scene, const CheckReport& report) {
    const auto finding_text = [](const Finding& finding) {
        return "{\"kind\": " + json_string(std::string(to_string(finding.kind))) +
               ", \"tray\": " + (finding.tray == kWholePacking ? "null" : std::to_string(finding.tray + 1)) +
               ", \"placements\": " + int_list(finding.placements) + ", \"amount\": " + json_number(finding.amount) +
               ", \"message\": " + json_string(finding.message) + "}";
    };
    const auto plan_text = [](const std::optional<PlanReport>& plan) -> std::string {
        if (!plan) return "null";
        return "{\"ok\": " + std::string(json_truth(plan->ok())) + ", \"complete\": " + json_truth(plan->complete) +
               ", \"steps\": " + std::to_string(plan->steps) + ", \"sweeps\": " + std::to_string(plan->sweeps) +
               ", \"unpack\": \"" + std::string(to_string(plan->unpack)) +
               "\", \"through_walls\": " + std::to_string(plan->through_walls) +
               ", \"failed_steps\": " + int_list(plan->failed_steps) +
               ", \"without_step\": " + int_list(plan->without_step) + ", \"staying\": " + int_list(plan->staying) +
               "}";
    };
    std::size_t copies = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        copies += tray.placements.size();
    }
    return "{\"ok\": " + std::string(json_truth(report.ok())) + ", \"stopped\": " + json_truth(report.stopped) +
           ", \"copies\": " + std::to_string(copies) + ", \"pairs_tested\": " + std::to_string(report.pairs_tested) +
           ", \"min_gap\": " + (report.min_gap ? json_number(*report.min_gap) : "null") +
           ", \"density\": " + json_list(report.density, json_number) + ", \"interlocking\": \"" +
           interlocking_word(report) + "\", \"plans\": " + json_list(report.plans, plan_text) +
           ", \"findings\": " + json_list(report.findings, finding_text) + "}";
}

std::string packing_json(const Scene& scene) { return packing_to_json(scene.packing, std::filesystem::current_path()); }

}  // namespace spectralpack
