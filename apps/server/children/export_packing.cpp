#include <ctime>
#include <filesystem>

#include <spectralpack/spectralpack.hpp>

#include "children/children.hpp"
#include "jobs/job_folder.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

/// "29 Nov 2026", here.
std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof(text), "%d %b %Y", &parts)};
}

/// The scene with one tray alone. What is left over is of the whole build, and stays out of it.
Scene only_tray(Scene scene, std::size_t tray) {
    if (tray >= scene.packing.trays.size()) throw UsageError("the build has no such tray");
    TrayPacking kept = std::move(scene.packing.trays[tray]);
    scene.packing.trays.clear();
    scene.packing.trays.push_back(std::move(kept));
    return scene;
}

}  // namespace

int export_packing(const std::vector<std::string>& arguments) {
    const fs::path to = arguments.at(1);
    const std::size_t tray = std::stoul(arguments.at(2));
    Scene scene = load_scene(arguments.at(0));
    if (tray > 0) scene = only_tray(std::move(scene), tray - 1);
    // Made under another name, so that nobody takes half a file; the ending says what is written.
    const fs::path unfinished = to.parent_path() / ("unfinished-" + to.filename().string());
    if (is_report_file(to) && to.extension() == ".html") {
        write_report(scene, unfinished, {.job_name = arguments.at(3), .date = today()}, 0);
    } else {
        // Of several trays it makes a file for each as well.
        for (const fs::path& written : write_output(scene, unfinished, 0)) {
            if (written != unfinished) fs::remove(written);
        }
    }
    fs::rename(unfinished, to);
    return 0;
}

}  // namespace spectralpack::server
