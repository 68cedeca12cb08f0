#include <string>

#include "formats/json_text.hpp"
#include "formats/packing_file.hpp"
#include "spectralpack/packings.hpp"

namespace spectralpack {
namespace {

const char* kind_word(FindingKind kind) {
    switch (kind) {
        case FindingKind::outside: return "outside";
        case FindingKind::overlap: return "overlap";
        case FindingKind::nested: return "nested";
        case FindingKind::gap: return "gap";
        case FindingKind::transform: return "transform";
        case FindingKind::density: return "density";
        case FindingKind::count: return "count";
    }
    return "";
}

/// "[a, b, c]" of texts that are JSON already.
template <class List, class Text>
std::string json_list(const List& list, const Text& text) {
    std::string joined;
    for (const auto& item : list) {
        joined += (joined.empty() ? "" : ", ") + text(item);
    }
    return "[" + joined + "]";
}

}  // namespace

std::string check_report_json(const Scene& scene, const CheckReport& report) {
    const auto finding_text = [](const Finding& finding) {
        return "{\"kind\": " + json_string(kind_word(finding.kind)) +
               ", \"tray\": " + std::to_string(finding.tray) + ", \"placements\": " +
               json_list(finding.placements, [](int i) { return std::to_string(i); }) +
               ", \"amount\": " + json_number(finding.amount) +
               ", \"message\": " + json_string(finding.message) + "}";
    };
    std::size_t copies = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        copies += tray.placements.size();
    }
    return "{\"ok\": " + std::string(report.ok() ? "true" : "false") +
           ", \"stopped\": " + (report.stopped ? "true" : "false") +
           ", \"copies\": " + std::to_string(copies) +
           ", \"pairs_tested\": " + std::to_string(report.pairs_tested) +
           ", \"min_gap\": " + (report.min_gap ? json_number(*report.min_gap) : "null") +
           ", \"density\": " + json_list(report.density, json_number) +
           ", \"interlocking\": \"not checked\", \"findings\": " +
           json_list(report.findings, finding_text) + "}";
}

std::string packing_json(const Scene& scene) {
    return packing_to_json(scene.packing, std::filesystem::current_path());
}

}  // namespace spectralpack
