#include "formats/job_file.hpp"

#include <algorithm>
#include <utility>

#include "formats/date.hpp"
#include "formats/file_bytes.hpp"
#include "formats/json_node.hpp"
#include "formats/option_reader.hpp"
#include "formats/part_orientations.hpp"
#include "formats/settings_options.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

constexpr int kMostCopies = 10'000'000;

/// Keys of the job that are options as well.
constexpr std::pair<const char*, const char*> kJobKeys[] = {
    {"trays", "trays"}, {"open_height", "open-height"}, {"gap", "gap"}, {"wall_gap", "wall-gap"}};

class JobReader {
  public:
    JobReader(const fs::path& path, const nlohmann::json& document, const JobSettings& defaults)
        : file_(path.string()), folder_(path.parent_path()), root_(file_, document, ""), job_{defaults, {}} {}

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
        if (const auto v = root_.find("unit")) {
            job_.settings.unit = v->one_of<LengthUnit>();
            said({"unit"});
        }
        for (const auto& [key, name] : kJobKeys) {
            const Option& option = *find_option(name);
            if (const auto v = said_once(key, name)) {
                option.in_pack.set(job_.settings.options, read_value(*v, option));
                said({name});
            }
        }
        if (const auto v = root_.find("container")) read_container(*v);
        if (const auto v = root_.find("keep_out")) {
            v->for_each([&](const Node& node) { read_keep_out(node); });
        }
        if (const auto v = root_.find("fixed")) {
            v->for_each([&](const Node& node) { read_fixed(node); });
        }
        root_.at("parts").for_each([&](const Node& node) { read_part(node); });
        return std::move(job_);
    }

  private:
    void read_container(const Node& node) {
        node.expect_keys({"size", "mesh", "transform", "unit", "is", "physical"});
        ContainerSource& container = job_.settings.container;
        if (const auto v = node.find("physical")) container.physical = v->boolean();
        if (const auto v = node.find("is")) container.is = v->one_of<ContainerIs>();
        const auto size = node.find("size"), mesh = node.find("mesh");
        for (const char* key : {"transform", "is"}) {
            if (const auto v = node.find(key); v && !mesh) v->fail("needs a mesh");
        }
        if (mesh && size) size->fail("is that of the mesh: leave one of them out");
        if (!mesh && !size) node.at("size");
        const auto options = root_.find("options");
        if (options && options->find("tray")) (size ? *size : *mesh).fail("is said twice: also as options.tray");
        job_.settings.sized = true;
        said({"tray"});
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
        if (const auto v = node.find("unit")) source.unit = in_mm(v->one_of<LengthUnit>());
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
        if (const auto v = node.find("unit"); v && root_.find("unit")) v->fail("is said twice: also as unit");
        said(read_settings_options(node, folder_, job_.settings));
        if (node.find("tray") || node.find("printer")) job_.settings.sized = true;
    }

    void said(const std::vector<std::string>& options) {
        forget_defaults(options, job_.settings);
        job_.settings.says_gap = job_.settings.says_gap || std::ranges::count(options, "gap") > 0;
        job_.settings.says_wall_gap = job_.settings.says_wall_gap || std::ranges::count(options, "wall-gap") > 0;
    }

    void read_part(const Node& node) {
        node.expect_keys({"name", "mesh", "object", "count", "scale", "unit", "gap", "priority", "due", "order",
                          "value", "orientations"});
        Part part;
        part.origin = node.path();
        part.mesh = path_of(node.at("mesh"));
        if (const auto v = node.find("name")) part.name = v->text();
        if (const auto v = node.find("object")) part.object = v->text();
        if (const auto v = node.find("count")) part.count = v->integer<int>(1, kMostCopies);
        if (const auto v = node.find("scale")) part.scale = v->positive();
        if (const auto v = node.find("gap")) part.gap = v->number_from(0);
        if (const auto v = node.find("priority")) part.priority = v->number();
        if (const auto v = node.find("unit")) part.unit = in_mm(v->one_of<LengthUnit>());
        if (const auto v = node.find("due")) part.due = date_of(*v);
        if (const auto v = node.find("order")) part.order = v->text();
        if (const auto v = node.find("value")) part.value = v->number_from(0);
        if (const auto v = node.find("orientations")) part.orientations = part_orientations_of(*v);
        job_.parts.push_back(std::move(part));
    }

    static std::string date_of(const Node& node) {
        const std::string text = node.text();
        if (!is_date(text)) node.fail("must be a date like \"2026-12-01\"");
        return text;
    }

    std::string path_of(const Node& node) const {
        const std::string text = node.text();
        if (text.empty() || text.find('\0') != std::string::npos) {
            node.fail("must be the path of a file");
        }
        return (folder_ / text).string();
    }

    std::string file_;
    fs::path folder_;
    Node root_;
    JobFile job_;
};

}  // namespace

JobFile parse_job(const fs::path& path, std::string_view text, const JobSettings& defaults) {
    const nlohmann::json document = parse_json(path.string(), text);
    return JobReader(path, document, defaults).read();
}

JobFile read_job(const fs::path& path, const JobSettings& defaults) {
    return parse_job(path, FileBytes(path).view(), defaults);
}

}  // namespace spectralpack
