#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "formats/file_bytes.hpp"
#include "formats/json_node.hpp"
#include "formats/option_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/part_orientations.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// Files of version 0.1 have other words for some.
UnplacedReason reason_of(const Node& node) {
    constexpr std::pair<std::string_view, UnplacedReason> kEarlier[] = {
        {"tray_full", UnplacedReason::no_place},
        {"interlocked", UnplacedReason::cannot_leave},
        {"unusable", UnplacedReason::bad_file},
        {"stopped", UnplacedReason::not_tried},
    };
    const std::string word = node.text();
    for (const auto& [earlier, reason] : kEarlier) {
        if (word == earlier) return reason;
    }
    return node.one_of<UnplacedReason>();
}

namespace fs = std::filesystem;

/// Scales that differ by no more, relatively, are the same.
constexpr double kSameScaleOfPart = 1e-9;

/// Reads a tray's disassembly plan and keeps track of who still stands with whom.
class PlanReader {
  public:
    /// `walls`: those of a physical container stand in the tray, too.
    PlanReader(const std::vector<Placement>& placements, bool walls)
        : placements_(placements), walls_(walls), subassembly_(placements.size(), 0), left_in_(placements.size()) {}

    Disassembly read(const Node& node) {
        Disassembly plan;
        plan.complete = node.at("complete").boolean();
        node.at("steps").for_each([&](const Node& step) { plan.steps.push_back(read_step(step)); });
        if (const auto v = node.find("interlocked")) {
            v->for_each([&](const Node& set) { plan.interlocked.push_back(placements_of(set)); });
        }
        if (const auto v = node.find("unpack")) plan.unpack = v->one_of<Unpack>();
        if (const auto v = node.find("through_walls")) plan.through_walls = steps_in(*v, plan.steps.size());
        return plan;
    }

  private:
    /// Positions of placements, each named once; ascending whatever the file's order.
    std::vector<int> placements_of(const Node& node) const {
        if (node.size() == 0) node.fail("must name a placement");
        std::vector<int> indices;
        node.for_each([&](const Node& element) {
            const int index = element.integer<int>();
            if (index < 0 || std::cmp_greater_equal(index, placements_.size())) {
                element.fail("must be the position of a placement of this tray, there are " +
                             std::to_string(placements_.size()));
            }
            indices.push_back(index);
        });
        std::sort(indices.begin(), indices.end());
        const auto twice = std::adjacent_find(indices.begin(), indices.end());
        if (twice != indices.end()) node.fail("names placement " + std::to_string(*twice) + " twice");
        return indices;
    }

    /// Positions of steps, ascending.
    static std::vector<int> steps_in(const Node& node, std::size_t count) {
        std::vector<int> positions;
        node.for_each([&](const Node& element) {
            const int position = element.integer<int>();
            if (position < 0 || std::cmp_greater_equal(position, count)) {
                element.fail("must be the position of a step of this plan, there are " + std::to_string(count));
            }
            if (!positions.empty() && position <= positions.back()) element.fail("must be greater than the one before");
            positions.push_back(position);
        });
        return positions;
    }

    RemovalStep read_step(const Node& node) {
        const Node named = node.at("placements");
        RemovalStep step{placements_of(named), {}};
        node.at("path").for_each([&](const Node& move) { step.path.push_back(vector_of(move)); });
        const int subassembly = subassembly_[static_cast<std::size_t>(step.placements.front())];
        for (const int index : step.placements) {
            const auto i = static_cast<std::size_t>(index);
            const std::string name = "placement " + std::to_string(index);
            if (placements_[i].fixed && !placements_[i].before) named.fail(name + " is fixed and never moves");
            if (left_in_[i]) {
                named.fail(name + " has left in steps[" + std::to_string(*left_in_[i]) + "] already");
            }
            if (subassembly_[i] != subassembly) {
                named.fail(name + " and placement " + std::to_string(step.placements.front()) +
                           " no longer stand together: a group left before");
            }
        }
        const bool group = step.placements.size() > 1;
        const bool leaves_walls = walls_ && subassembly == 0;
        if (group && !leaves_walls &&
            std::cmp_equal(std::count(subassembly_.begin(), subassembly_.end(), subassembly), step.placements.size())) {
            named.fail("is all that stands together: a group must leave something behind");
        }
        ++steps_;
        for (const int index : step.placements) {
            const auto i = static_cast<std::size_t>(index);
            subassembly_[i] = steps_;
            if (!group) left_in_[i] = steps_ - 1;
        }
        return step;
    }

    const std::vector<Placement>& placements_;
    const bool walls_;
    int steps_ = 0;                            ///< read so far
    std::vector<int> subassembly_;             ///< by placement: 0 in the tray, else 1 + the step it left in
    std::vector<std::optional<int>> left_in_;  ///< by placement: the step that took it out by itself
};

class PackingReader {
  public:
    PackingReader(const fs::path& path, const nlohmann::json& document)
        : file_(path.string()), folder_(path.parent_path()), root_(file_, document, "") {}

    Packing read() {
        const Node format = root_.at("format");
        if (format.text() == "spectralpack/job") format.fail("this is a job; \"pack\" makes a packing of it");
        if (format.text() != "spectralpack/packing") format.fail("must be \"spectralpack/packing\"");
        if (root_.at("version").integer<std::int64_t>() != 1) {
            root_.at("version").fail("is not a version this program reads (1)");
        }
        if (const auto units = root_.find("units"); units && units->text() != "mm") units->fail("must be \"mm\"");
        if (const auto program = root_.find("program")) packing_.program = program->text();
        if (const auto hash = root_.find("input_hash")) packing_.input_hash = hash->text();
        read_container(root_.at("container"));
        packing_.options.tray = packing_.container.size;
        if (const auto options = root_.find("options")) read_options(*options, packing_.options);
        if (const auto defaults = root_.find("defaults")) {
            defaults->for_each([&](const Node& node) { read_defaults(node); });
        }
        root_.at("parts").for_each([&](const Node& node) { read_part(node); });
        root_.at("trays").for_each([&](const Node& node) { read_tray(node); });
        if (const auto unplaced = root_.find("unplaced")) {
            unplaced->for_each([&](const Node& node) { read_unplaced(node); });
        }
        if (const auto metrics = root_.find("metrics")) read_metrics(*metrics);
        return std::move(packing_);
    }

  private:
    void read_container(const Node& node) {
        const Node size = node.at("size");
        size.expect_size(3);
        for (int axis = 0; axis < 3; ++axis) {
            packing_.container.size[axis] = size.element(static_cast<std::size_t>(axis)).positive();
        }
        if (const auto open = node.find("open_height")) packing_.container.open_height = open->boolean();
        Container& container = packing_.container;
        if (const auto mesh = node.find("mesh")) container.mesh = standing_mesh(*mesh, node);
        for (const char* key : {"transform", "is"}) {
            if (const auto v = node.find(key); v && !container.mesh) v->fail("needs a mesh");
        }
        if (const auto is = node.find("is")) container.is = is->one_of<ContainerIs>();
        if (const auto keep_out = node.find("keep_out")) {
            keep_out->for_each([&](const Node& zone) { container.keep_out.push_back(keep_out_of(zone)); });
        }
        if (const auto physical = node.find("physical")) container.physical = physical->boolean();
    }

    KeepOut keep_out_of(const Node& zone) const {
        const auto mesh = zone.find("mesh"), box = zone.find("box"), transform = zone.find("transform");
        if (mesh && box) box->fail("is one keep-out, the mesh another");
        if (mesh) return {{}, standing_mesh(*mesh, zone)};
        if (transform) transform->fail("needs a mesh");
        return {box_of(zone.at("box"))};
    }

    void read_defaults(const Node& node) {
        SettingsSource source{node.at("file").text()};
        if (const auto v = node.find("profile")) source.profile = v->text();
        node.at("options").for_each([&](const Node& name) { source.options.push_back(name.text()); });
        packing_.defaults.push_back(std::move(source));
    }

    StandingMesh standing_mesh(const Node& mesh, const Node& owner) const {
        return {mesh_path(mesh), transform_of(owner.at("transform"))};
    }

    void read_part(const Node& node) {
        PackedPart part;
        part.id = static_cast<int>(packing_.parts.size());
        if (const auto id = node.find("id"); id && id->integer<std::int64_t>() != part.id) {
            id->fail("must be the part's position, " + std::to_string(part.id));
        }
        part.mesh = mesh_path(node.at("mesh"));
        named_.push_back(node.at("mesh").text());
        const auto name = node.find("name");
        part.name = name ? name->text() : fs::path(part.mesh).stem().string();
        if (const auto v = node.find("object")) part.object = v->text();
        if (const auto v = node.find("item_transform")) part.item_transform = transform_of(*v);
        if (const auto v = node.find("count")) part.count = v->integer<int>(0);
        if (const auto v = node.find("numbers")) {
            v->expect_size(static_cast<std::size_t>(part.count));
            v->for_each([&](const Node& number) { part.numbers.push_back(number.integer<int>(1)); });
        }
        if (const auto v = node.find("share")) part.share = v->integer<int>(1);
        if (const auto v = node.find("scale")) part.scale = v->positive();
        if (const auto v = node.find("unit")) part.unit = v->positive();
        if (const auto v = node.find("gap")) part.gap = v->number_from(0);
        if (const auto v = node.find("orientations")) part.orientations = part_orientations_of(*v);
        if (const auto v = node.find("priority")) part.priority = v->number();
        if (const auto v = node.find("due")) part.due = v->text();
        if (const auto v = node.find("order")) part.order = v->text();
        if (const auto v = node.find("value")) part.value = v->number_from(0);
        if (const auto v = node.find("volume")) part.volume = v->number();
        if (const auto v = node.find("repairs")) {
            v->for_each([&](const Node& repair) { part.repairs.push_back(repair.text()); });
        }
        packing_.parts.push_back(std::move(part));
    }

    std::string mesh_path(const Node& node) const {
        const std::string text = node.text();
        const auto [path, fresh] = paths_.try_emplace(text);
        if (fresh) path->second = found_path(node, text);
        return path->second;
    }

    std::string found_path(const Node& node, const std::string& text) const {
        if (text.empty() || text.find('\0') != std::string::npos) node.fail("must be the path of a file");
        // Dropping ".." from the text is only right where the folder before it is no link.
        const fs::path joined = folder_ / text, plain = joined.lexically_normal();
        std::error_code failure;
        const fs::path real = fs::weakly_canonical(joined, failure);
        return (failure || fs::weakly_canonical(plain, failure) == real ? plain : real).string();
    }

    int part_of(const Node& node) const {
        const Node part = node.at("part");
        const auto index = part.integer<int>();
        if (index < 0 || std::cmp_greater_equal(index, packing_.parts.size())) {
            part.fail("must be the position of a part, there are " + std::to_string(packing_.parts.size()));
        }
        return index;
    }

    /// What a placement says of its part again is as its part says it: nobody is to be judged by one and built by the
    /// other.
    void expect_of_part(const Node& placed, int index) const {
        const auto i = static_cast<std::size_t>(index);
        const PackedPart& part = packing_.parts[i];
        const std::string owner = "parts[" + std::to_string(index) + "]";
        if (const auto mesh = placed.find("mesh"); mesh && mesh->text() != named_[i] && mesh_path(*mesh) != part.mesh) {
            mesh->fail("must be the mesh of its part, " + named_[i] + " (" + owner + ")");
        }
        if (const auto scale = placed.find("scale");
            scale && std::abs(scale->positive() - part.scale) > kSameScaleOfPart * part.scale) {
            scale->fail("must be the scale of its part, " + nlohmann::json(part.scale).dump() + " (" + owner + ")");
        }
    }

    void read_tray(const Node& node) {
        TrayPacking tray;
        node.at("placements").for_each([&](const Node& placed) {
            Placement placement;
            placement.part = part_of(placed);
            expect_of_part(placed, placement.part);
            if (const auto v = placed.find("copy")) placement.copy = v->integer<int>(0);
            if (const auto v = placed.find("orientation")) placement.orientation = v->integer<int>(0);
            if (const auto v = placed.find("fixed")) placement.fixed = v->boolean();
            placement.transform = transform_of(placed.at("transform"));
            if (const auto v = placed.find("before")) placement.before = placement.fixed && v->boolean();
            tray.placements.push_back(placement);
        });
        if (const auto v = node.find("density")) tray.density = v->number();
        if (const auto v = node.find("density_bounding_box")) tray.density_bounding_box = v->number();
        if (const auto v = node.find("bounding_box")) {
            v->expect_size(2);
            tray.bounding_box.min = vector_of(v->element(0));
            tray.bounding_box.max = vector_of(v->element(1));
        }
        if (const auto v = node.find("height")) tray.height = v->number();
        if (const auto v = node.find("height_at")) tray.height_at = v->one_of<HeightReference>();
        if (const auto layers = node.find("layers")) {
            if (const auto v = layers->find("thickness")) tray.layers.thickness = v->number_from(0);
            if (const auto v = layers->find("area")) {
                v->for_each([&](const Node& area) { tray.layers.area.push_back(area.number()); });
            }
        }
        if (const auto v = node.find("disassembly")) {
            tray.disassembly = PlanReader(tray.placements, packing_.container.physical).read(*v);
        }
        packing_.trays.push_back(std::move(tray));
    }

    void read_unplaced(const Node& node) {
        Unplaced unplaced;
        unplaced.part = part_of(node);
        if (const auto v = node.find("copy")) unplaced.copy = v->integer<int>(0);
        if (const auto v = node.find("reason")) unplaced.reason = reason_of(*v);
        if (const auto v = node.find("detail")) unplaced.detail = v->text();
        packing_.unplaced.push_back(std::move(unplaced));
    }

    void read_metrics(const Node& node) {
        Metrics& m = packing_.metrics;
        if (const auto v = node.find("copies")) m.copies = v->integer<std::int64_t>(0);
        if (const auto v = node.find("placed")) m.placed = v->integer<std::int64_t>(0);
        if (const auto v = node.find("density")) m.density = v->number();
        if (const auto v = node.find("min_gap")) m.min_gap = v->number();
        if (const auto v = node.find("seconds")) {
            const std::pair<const char*, double*> phases[] = {
                {"total", &m.seconds.total},       {"load", &m.seconds.load},
                {"voxelize", &m.seconds.voxelize}, {"search", &m.seconds.search},
                {"refine", &m.seconds.refine},     {"disassemble", &m.seconds.disassemble},
                {"reinsert", &m.seconds.reinsert}};
            for (const auto& [key, seconds] : phases) {
                if (const auto phase = v->find(key)) *seconds = phase->number();
            }
        }
        if (const auto v = node.find("interlock")) {
            InterlockCounts& counts = m.interlock.emplace();
            const std::pair<const char*, int*> fields[] = {
                {"straight", &counts.straight}, {"flooded", &counts.flooded}, {"groups", &counts.groups},
                {"fills", &counts.fills},       {"removed", &counts.removed}, {"reinserted", &counts.reinserted},
                {"added", &counts.added}};
            for (const auto& [key, count] : fields) {
                if (const auto field = v->find(key)) *count = field->integer<int>(0);
            }
        }
        if (const auto v = node.find("searches")) m.searches = v->integer<std::int64_t>(0);
        if (const auto v = node.find("orders")) m.orders = v->integer<int>(1);
        if (const auto v = node.find("improvement")) {
            Improved& improved = m.improvement.emplace();
            if (const auto field = v->find("what")) improved.what = field->one_of<Improves>();
            if (const auto field = v->find("before")) improved.before = field->number();
            if (const auto field = v->find("now")) improved.now = field->number();
            if (const auto field = v->find("steps")) improved.steps = field->integer<std::int64_t>(0);
            if (const auto field = v->find("starts")) improved.starts = field->integer<int>(0);
            if (const auto field = v->find("seconds")) improved.seconds = field->number();
        }
        if (const auto v = node.find("verified")) m.verified = v->integer<std::int64_t>(0);
        if (const auto v = node.find("peak_memory")) m.peak_memory = v->integer<std::int64_t>(0);
        if (const auto v = node.find("engine")) m.engine = v->text();
        if (const auto v = node.find("threads")) m.threads = v->integer<int>(0);
    }

    std::string file_;
    fs::path folder_;
    Node root_;
    Packing packing_;
    std::vector<std::string> named_;                              ///< by part: its mesh, as the file writes it
    mutable std::unordered_map<std::string, std::string> paths_;  ///< of meshes, as the file writes them
};

}  // namespace

Packing parse_packing(const fs::path& path, std::string_view text) {
    // As the first of a 3MF or STL is: a parser would only say which byte it did not expect.
    if (text.find_first_not_of(" \t\r\n") != text.find('{')) {
        throw InputError(path.string(), "", "is not a packing file: those are written with -o NAME.json");
    }
    return PackingReader(path, parse_json(path.string(), text)).read();
}

Packing read_packing(const fs::path& path) { return parse_packing(path, FileBytes(path).view()); }

}  // namespace spectralpack
