#include <map>
#include <set>

#include <spectralpack/spectralpack.hpp>

#include "children/children.hpp"
#include "children/surroundings.hpp"
#include "jobs/job_folder.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

/// The copies that stand elsewhere than before, by tray.
std::map<std::size_t, std::set<std::size_t>> moved_copies(const Packing& packing,
                                                          const std::vector<CopyChange>& changes) {
    std::map<std::pair<int, int>, int> last;  // tray by copy; -1: it is out
    for (const CopyChange& change : changes) {
        last[{change.part, change.copy}] = change.transform ? change.tray : -1;
    }
    std::map<std::size_t, std::set<std::size_t>> moved;
    for (const auto& [copy, tray] : last) {
        if (tray < 0) continue;
        const auto at = static_cast<std::size_t>(tray);
        moved[at].insert(placement_of(packing, at, copy.first, copy.second));
    }
    return moved;
}

}  // namespace

int change_packing(const std::vector<std::string>& arguments) {
    const std::optional<Json> asked = read_json(arguments.at(0));
    if (!asked) throw UsageError("there are no changes");
    const JobFolder job{fs::current_path()};
    Scene scene = load_scene("packing.json");
    const std::vector<CopyChange> changes = changes_from(asked->at("changes"));
    scene.packing = changed(scene, changes);
    for (const auto& [tray, copies] : moved_copies(scene.packing, changes)) {
        const std::vector<std::string> faults = faults_of(scene, tray, copies);
        if (!faults.empty()) throw UsageError(faults.front());
    }
    write_text(arguments.at(1), packing_json(scene));
    return 0;
}

}  // namespace spectralpack::server
