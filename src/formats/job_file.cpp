#include "formats/job_file.hpp"

#include <utility>

#include "formats/file_bytes.hpp"
#include "formats/json_node.hpp"
#include "formats/option_reader.hpp"
#include "formats/part_orientations.hpp"

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
        if (root_.at("format").text() != "spectralpack/job") {
            root_.at("format").fail("must be \"spectralpack/job\"");
        }
        if (root_.at("version").integer<std::int64_t>() != 1) {
            root_.at("version").fail("is not a version this program reads (1)");
        }
        root_.expect_keys({"format", "version", "unit", "container", "open_height", "trays",
                           "keep_out", "wall_gap", "gap", "parts", "fixed", "options"});
        job_.settings.file = file_;
        refuse_what_is_not_built();
        if (const auto options = root_.find("options")) read_job_options(*options);
        PackOptions& o = job_.settings.options;
        if (const auto v = root_.find("unit")) job_.settings.unit = v->one_of(kUnits);
        if (const auto v = said_once("open_height", "open-height")) o.open_height = v->boolean();
        if (const auto v = root_.find("container")) read_container(*v);
        if (const auto v = said_once("gap", "gap")) o.gap = v->number_from(0);
        if (const auto v = said_once("wall_gap", "wall-gap")) o.wall_gap = v->number_from(0);
        root_.at("parts").for_each([&](const Node& node) { read_part(node); });
        return std::move(job_);
    }

  private:
    [[noreturn]] static void not_built(const Node& node, const std::string& what) {
        throw UsageError(node.file() + ": " + node.path() + ": " + what + " not built yet");
    }

    /// What says that there is nothing of the kind is fine.
    void refuse_what_is_not_built() const {
        if (const auto v = root_.find("trays")) refuse_trays(*v);
        if (const auto v = root_.find("keep_out"); v && v->size() > 0) {
            not_built(*v, "keep-out zones are");
        }
        if (const auto v = root_.find("fixed"); v && v->size() > 0)
            not_built(*v, "fixed parts are");
    }

    static void refuse_trays(const Node& node) {
        const bool one = node.is_text() ? node.text() == "1" : node.integer<int>(1) == 1;
        if (node.is_text() && !one && node.text() != "all")
            node.fail("must be a number or \"all\"");
        if (!one) not_built(node, "several containers are");
    }

    void read_container(const Node& node) {
        node.expect_keys({"size", "mesh", "transform", "physical"});
        for (const char* key : {"mesh", "transform"}) {
            if (const auto v = node.find(key)) not_built(*v, "a mesh as container is");
        }
        if (const auto v = node.find("physical"); v && v->boolean()) {
            not_built(*v, "a physical container is");
        }
        const Node size = node.at("size");
        if (const auto options = root_.find("options"); options && options->find("tray")) {
            size.fail("is said twice: also as options.tray");
        }
        job_.settings.options.tray = size_of(size);
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
        node.expect_keys({"tray",           "trays",           "gap",
                          "wall-gap",       "voxel",           "rotations",
                          "refine",         "interlock",       "order",
                          "height-penalty", "height-at",       "seed",
                          "engine",         "threads",         "memory",
                          "verify-with",    "time-limit",      "unit",
                          "output",         "report",          "progress",
                          "dry-run",        "skip-unusable",   "require-all",
                          "json",           "material-density", "detail", "open-height",
                          "minimise",       "fill",            "max-density",
                          "max-layer-fill"});
        JobSettings& s = job_.settings;
        read_options(node, s.options);
        if (const auto v = node.find("tray")) s.options.tray = size_of(*v);
        if (const auto v = node.find("trays")) refuse_trays(*v);
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
        const std::pair<const char*, std::optional<bool>*> flags[] = {
            {"dry-run", &s.dry_run},
            {"json", &s.json},
            {"skip-unusable", &s.skip_unusable},
            {"require-all", &s.require_all}};
        for (const auto& [key, flag] : flags) {
            if (const auto v = node.find(key)) *flag = v->boolean();
        }
    }

    void read_part(const Node& node) {
        node.expect_keys(
            {"name", "mesh", "count", "scale", "gap", "priority", "due", "orientations"});
        if (const auto v = node.find("priority"); v && v->number() != 0)
            not_built(*v, "priorities are");
        if (const auto v = node.find("due")) not_built(*v, "due dates are");
        JobPart part;
        part.key = node.path();
        part.mesh = path_of(node.at("mesh"));
        if (const auto v = node.find("name")) part.name = v->text();
        if (const auto v = node.find("count")) part.count = v->integer<int>(1, kMostCopies);
        if (const auto v = node.find("scale")) part.scale = v->positive();
        if (const auto v = node.find("gap")) part.gap = v->number_from(0);
        if (const auto v = node.find("orientations")) part.orientations = part_orientations_of(*v);
        job_.parts.push_back(std::move(part));
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

JobFile read_job(const fs::path& path) {
    return parse_job(path, FileBytes(path).view());
}

}  // namespace spectralpack
