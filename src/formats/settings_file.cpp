#include "formats/settings_file.hpp"

#include <algorithm>
#include <optional>

#include "formats/file_bytes.hpp"
#include "formats/json_node.hpp"
#include "formats/settings_options.hpp"

namespace spectralpack {
namespace {

namespace fs = std::filesystem;

/// What people write by hand need not say what it is.
void expect_format(const Node& root, const std::string& format) {
    if (const auto v = root.find("format"); v && v->text() != format) v->fail("must be \"" + format + "\"");
    if (const auto v = root.find("version"); v && v->integer<std::int64_t>() != 1) {
        v->fail("is not a version this program reads (1)");
    }
}

/// A file of defaults, whose options are known to be right once it is read.
struct SettingsFile {
    explicit SettingsFile(const fs::path& path)
        : name(path.string()), folder(path.parent_path()), document(parse_json(name, FileBytes(path).view())) {
        const Node root(name, document, "");
        expect_format(root, "spectralpack/settings");
        root.expect_keys({"format", "version", "options", "profiles"});
    }

    std::optional<Node> options() const { return Node(name, document, "").find("options"); }

    /// By name.
    std::vector<std::pair<std::string, Node>> profiles() const {
        std::vector<std::pair<std::string, Node>> all;
        const auto node = Node(name, document, "").find("profiles");
        if (!node) return all;
        for (const std::string& key : node->keys()) {
            all.emplace_back(key, node->at(key));
        }
        return all;
    }

    std::string name;
    fs::path folder;
    nlohmann::json document;
};

void take(const Node& options, const SettingsFile& file, const std::string& profile, JobSettings& settings) {
    std::vector<std::string> said = read_settings_options(options, file.folder, settings);
    forget_defaults(said, settings);
    if (!said.empty()) settings.defaults.push_back({file.name, profile, std::move(said)});
}

void know(std::vector<Printer> more, std::vector<Printer>& printers) {
    for (Printer& printer : more) {
        std::erase_if(printers, [&](const Printer& known) { return known.name == printer.name; });
        printers.push_back(std::move(printer));
    }
}

Printer printer_of(const Node& node) {
    node.expect_keys({"name", "title", "size", "gap", "wall", "floor", "source"});
    Printer printer;
    printer.name = node.at("name").text();
    if (printer.name.empty() || printer.name == "list") node.at("name").fail("must be a name, and not 'list'");
    const auto title = node.find("title");
    printer.title = title ? title->text() : printer.name;
    const Node size = node.at("size");
    size.expect_size(3);
    printer.size = size_of(size);
    if (const auto v = node.find("gap")) printer.gap = v->number_from(0);
    if (const auto v = node.find("wall")) printer.wall = v->number_from(0);
    if (const auto v = node.find("floor")) printer.floor = v->number_from(0);
    if (const auto v = node.find("source")) printer.source = v->text();
    return printer;
}

}  // namespace

void read_settings(std::span<const fs::path> paths, const std::string& profile, JobSettings& settings) {
    std::vector<SettingsFile> files;
    for (const fs::path& path : paths) {
        files.emplace_back(path);
        const fs::path printers = path.parent_path() / "printers.json";
        if (fs::exists(printers)) know(read_printers(printers), settings.own_printers);
    }
    for (const SettingsFile& file : files) {
        if (const auto options = file.options()) take(*options, file, "", settings);
    }
    bool found = profile.empty();
    std::string known;
    for (const SettingsFile& file : files) {
        for (const auto& [name, options] : file.profiles()) {
            if (name == profile) {
                found = true;
                take(options, file, profile, settings);
            } else {
                JobSettings unused = settings;  // said wrong, it is told now and not once it is asked for
                read_settings_options(options, file.folder, unused);
            }
            known += (known.empty() ? "" : ", ") + name;
        }
    }
    if (found) return;
    throw UsageError("--profile " + profile + ": " +
                     (files.empty()   ? "there is no file of settings (spectralpack.json here, or --config FILE)"
                      : known.empty() ? "the settings have no profiles"
                                      : "there is no such profile; there are " + known));
}

std::vector<Printer> read_printers(const fs::path& path) {
    const std::string name = path.string();
    const nlohmann::json document = parse_json(name, FileBytes(path).view());
    const Node root(name, document, "");
    expect_format(root, "spectralpack/printers");
    root.expect_keys({"format", "version", "printers"});
    std::vector<Printer> printers;
    root.at("printers").for_each([&](const Node& node) {
        printers.push_back(printer_of(node));
        const auto same = [&](const Printer& other) { return other.name == printers.back().name; };
        if (std::count_if(printers.begin(), printers.end(), same) > 1) node.at("name").fail("is there twice");
    });
    return printers;
}

std::string printers_to_json(std::span<const Printer> printers) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Printer& printer : printers) {
        list.push_back({{"name", printer.name},
                        {"title", printer.title},
                        {"size", {printer.size.x, printer.size.y, printer.size.z}},
                        {"gap", printer.gap},
                        {"wall", printer.wall},
                        {"floor", printer.floor},
                        {"source", printer.source}});
    }
    const nlohmann::ordered_json root = {
        {"format", "spectralpack/printers"}, {"version", 1}, {"printers", std::move(list)}};
    return root.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace spectralpack
