#include "formats/job_file.hpp"

#include <chrono>
#include <utility>

#include "formats/file_bytes.hpp"
#include "formats/json_node.hpp"
#include "formats/option_reader.hpp"
#include "formats/part_orientations.hpp"
#include "spectralpack/printers.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

constexpr int kMostCopies = 10'000'000;

constexpr Names<double, 3> kUnits{{{"mm", 1.0}, {"inch", 25.4}, {"m", 1000.0}}};

class JobReader {
  public:
    JobReader(const fs::path& path, const nlohmann::json& document)
        : file_(path.string()), folder_(path.parent_path()), root_(file_, document, "") {}

    JobFile read() {
        const Node format = root_.at("format");
        if (format.text() == "spectralpack/packing") format.fail("this is a packing, not a job; --onto tops it up");
        if (format.text() != "spectralpack/job") format.fail("must be \"spectralpack/job\"");
        if (root_.at("version").integer<std::int64_t>() != 1) {
            root_.at("version").fail("is not a version this program reads (1)");
        }
        root_.expect_keys({"format", "version", "unit", "container", "open_height", "trays", "keep_out", "wall_gap",
                           "gap", "parts", "fixed", "options"});
        job_.settings.file = file_;
        if (const auto options = root_.find("options")) read_job_options(*options);
        PackOptions& o = job_.settings.options;
        if (const auto v = root_.find("unit")) job_.settings.unit = v->one_of(kUnits);
        if (const auto v = said_once("trays", "trays")) o.trays = trays_of(*v);
        if (const auto v = said_once("open_height", "open-height")) o.open_height = v->boolean();
        if (const auto v = root_.find("container")) read_container(*v);
        if (const auto v = root_.find("keep_out")) {
            v->for_each([&](const Node& node) { read_keep_out(node); });
        }
        if (const auto v = root_.find("fixed")) {
            v->for_each([&](const Node& node) { read_fixed(node); });
        }
        if (const auto v = said_once("gap", "gap")) o.gap = v->number_from(0);
        if (const auto v = said_once("wall_gap", "wall-gap")) o.wall_gap = v->number_from(0);
        root_.at("parts").for_each([&](const Node& node) { read_part(node); });
        return std::move(job_);
    }

  private:
    void read_container(const Node& node) {
        node.expect_keys({"size", "mesh", "transform", "unit", "physical"});
        ContainerSource& container = job_.settings.container;
        if (const auto v = node.find("physical")) container.physical = v->boolean();
        const auto size = node.find("size"), mesh = node.find("mesh");
        if (const auto v = node.find("transform"); v && !mesh) v->fail("needs a mesh");
        if (mesh && size) size->fail("is that of the mesh: leave one of them out");
        if (!mesh && !size) node.at("size");
        const auto options = root_.find("options");
        if (options && options->find("tray")) (size ? *size : *mesh).fail("is said twice: also as options.tray");
        job_.settings.sized = true;
        if (mesh) {
            container.mesh = mesh_source(node);
        } else {
            job_.settings.options.tray = size_of(*size);
        }
    }

    /// "mesh", and where it stands: "transform", "unit".
    MeshSource mesh_source(const Node& node) const {
        MeshSource source{path_of(node.at("mesh")), file_ + " " + node.path()};
        if (const auto v = node.find("transform")) source.transform = transform_of(*v);
        if (const auto v = node.find("unit")) source.unit = v->one_of(kUnits);
        return source;
    }

    void read_keep_out(const Node& node) {
        node.expect_keys({"box", "mesh", "transform", "unit"});
        const auto box = node.find("box");
        if (box && node.find("mesh")) box->fail("is one keep-out, the mesh another");
        KeepOutSource source;
        if (box) {
            source.box = box_of(*box);
        } else {
            source.mesh = mesh_source(node);
        }
        job_.settings.container.keep_out.push_back(std::move(source));
    }

    void read_fixed(const Node& node) {
        node.expect_keys({"name", "mesh", "transform", "unit", "gap"});
        FixedSource source{mesh_source(node)};
        if (const auto v = node.find("name")) source.name = v->text();
        if (const auto v = node.find("gap")) source.gap = v->number_from(0);
        job_.settings.fixed.push_back(std::move(source));
    }

    /// Two sides are a base, for packings without a ceiling.
    static Vec3 size_of(const Node& node) {
        if (node.size() == 2) return {node.element(0).positive(), node.element(1).positive(), 0};
        node.expect_size(3);
        return {node.element(0).positive(), node.element(1).positive(), node.element(2).positive()};
    }

    /// A key of the job that is an option as well.
    std::optional<Node> said_once(const char* key, const char* option) const {
        const auto node = root_.find(key);
        const auto options = root_.find("options");
        if (node && options && options->find(option)) {
            node->fail(std::string("is said twice: also as options.") + option);
        }
        return node;
    }

    void read_job_options(const Node& node) {
        node.expect_keys(
            {"tray",           "trays",         "gap",         "try-per-tray", "printer",          "onto",
             "wall-gap",       "voxel",         "rotations",   "refine",       "interlock",        "order",
             "height-penalty", "height-at",     "seed",        "engine",       "threads",          "memory",
             "verify-with",    "time-limit",    "unit",        "output",       "report",           "progress",
             "dry-run",        "skip-unusable", "require-all", "json",         "material-density", "detail",
             "take-out",       "open-height",   "minimise",    "fill",         "max-density",      "max-layer-fill",
             "restarts",       "beam",          "links",       "ray-spacing"});
        JobSettings& s = job_.settings;
        if (const auto v = node.find("printer")) use_printer(*v);
        read_options(node, s.options);
        if (const auto v = node.find("tray")) {
            s.options.tray = size_of(*v);
            s.sized = true;
        }
        if (const auto v = node.find("onto")) s.onto = path_of(*v);
        if (const auto v = node.find("unit")) {
            if (root_.find("unit")) v->fail("is said twice: also as unit");
            s.unit = v->one_of(kUnits);
        }
        if (const auto v = node.find("output")) {
            if (v->is_text()) {
                s.outputs.push_back(path_of(*v));
            } else {
                v->for_each([&](const Node& output) { s.outputs.push_back(path_of(output)); });
            }
        }
        if (const auto v = node.find("report")) s.report = path_of(*v);
        if (const auto v = node.find("material-density")) s.material_density = v->positive();
        if (const auto v = node.find("progress")) s.progress = v->one_of(kProgressNames);
        const std::pair<const char*, std::optional<bool>*> flags[] = {{"dry-run", &s.dry_run},
                                                                      {"json", &s.json},
                                                                      {"skip-unusable", &s.skip_unusable},
                                                                      {"require-all", &s.require_all}};
        for (const auto& [key, flag] : flags) {
            if (const auto v = node.find(key)) *flag = v->boolean();
        }
    }

    /// What the job says itself is read later and overrides the printer's values.
    void use_printer(const Node& node) {
        const Printer* printer = find_printer(node.text());
        if (!printer) node.fail("is no printer that is known: see 'spectralpack pack --printer list'");
        apply(*printer, job_.settings.options);
        job_.settings.sized = true;
    }

    void read_part(const Node& node) {
        node.expect_keys({"name", "mesh", "count", "scale", "gap", "priority", "due", "orientations"});
        Part part;
        part.origin = node.path();
        part.mesh = path_of(node.at("mesh"));
        if (const auto v = node.find("name")) part.name = v->text();
        if (const auto v = node.find("count")) part.count = v->integer<int>(1, kMostCopies);
        if (const auto v = node.find("scale")) part.scale = v->positive();
        if (const auto v = node.find("gap")) part.gap = v->number_from(0);
        if (const auto v = node.find("priority")) part.priority = v->number();
        if (const auto v = node.find("due")) part.due = date_of(*v);
        if (const auto v = node.find("orientations")) part.orientations = part_orientations_of(*v);
        job_.parts.push_back(std::move(part));
    }

    /// A calendar date, which then sorts as text.
    static std::string date_of(const Node& node) {
        const std::string text = node.text();
        bool digits = text.size() == 10;
        for (std::size_t i = 0; i < text.size() && digits; ++i) {
            digits = i == 4 || i == 7 ? text[i] == '-' : text[i] >= '0' && text[i] <= '9';
        }
        const auto number = [&](std::size_t at, std::size_t size) {
            return static_cast<unsigned>(std::stoul(text.substr(at, size)));
        };
        if (!digits || !std::chrono::year_month_day(std::chrono::year(static_cast<int>(number(0, 4))),
                                                    std::chrono::month(number(5, 2)), std::chrono::day(number(8, 2)))
                            .ok()) {
            node.fail("must be a date like \"2026-12-01\"");
        }
        return text;
    }

    std::string path_of(const Node& node) const {
        const std::string text = node.text();
        if (text.empty() || text.find('\0') != std::string::npos) {
            node.fail("must be the path of a file");
        }
        return (folder_ / text).string();
    }

    static constexpr Names<std::string_view, 4> kProgressNames{
        {{"auto", "auto"}, {"bar", "bar"}, {"json", "json"}, {"none", "none"}}};

    std::string file_;
    fs::path folder_;
    Node root_;
    JobFile job_;
};

}  // namespace

JobFile parse_job(const fs::path& path, std::string_view text) {
    return JobReader(path, parse_json(path.string(), text)).read();
}

JobFile read_job(const fs::path& path) { return parse_job(path, FileBytes(path).view()); }

}  // namespace spectralpack
