/// 3MF: the package around the model, and the resolving of items and components into meshes.

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "core/stopped.hpp"
#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/threemf_model.hpp"
#include "formats/xml_parser.hpp"
#include "formats/zip_archive.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr std::string_view kModelRelationship = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

// Bounds on what a small file may grow to. Coordinates as text deflate to a fifth; hundredfold is
// no mesh.
constexpr std::uint64_t kFreeBytes = 16 << 20, kMostGrowth = 100;
/// Objects of components may nest this deep ...
constexpr int kMostLevels = 32;
/// ... and copies, by items that turn an object differently and by components, may come to so many
/// objects, and to so many triangles beside so many times those the file holds (6,596 copies of 549
/// meshes: 12 times).
constexpr std::uint64_t kMostObjects = 1'000'000, kFreeTriangles = 4'000'000, kMostRepeats = 32;

/// Sums saturate here, so that a small file cannot wrap them.
constexpr std::uint64_t kPlenty = std::uint64_t{1} << 40;

class RelationshipParser : public XmlHandler {
  public:
    RelationshipParser(const std::string& file, const std::string& entry) : parser(file, entry, *this) {}

    void on_start(const XmlName& name, const XmlAttributes& attributes) override {
        const char* type = attributes.find("Type");
        const char* found = attributes.find("Target");
        if (name.local == "Relationship" && type && found && type == kModelRelationship && target.empty()) {
            target = found;
        }
    }
    void on_end() override {}
    void on_prefix(std::string_view, std::string_view) override {}

    XmlParser parser;
    std::string target;
};

/// What an object comes to when its components are followed: objects met, itself included, and
/// their triangles.
/// True for "23 fan-shroud" of a fan-shroud.
bool is_numbered(std::string_view text, std::string_view name) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    return digits > 0 && text.size() > digits && text[digits] == ' ' && text.substr(digits + 1) == name;
}

struct Extent {
    std::uint64_t objects = 1, triangles = 0;
};

/// What makes two items instances of one shape: bits, not numbers, so that it orders any matrix.
using ShapeKey = std::pair<ObjectKey, std::array<std::uint64_t, 9>>;

ShapeKey shape_key(const ModelItem& item) {
    ShapeKey key{item.object, {}};
    for (std::size_t i = 0; i < 9; ++i) {
        const double entry = item.transform.linear.rows[i / 3][static_cast<int>(i % 3)];
        key.second[i] = std::bit_cast<std::uint64_t>(entry + 0.0);
    }
    return key;
}

class Reader {
  public:
    explicit Reader(const MeshBytes& source)
        : source_(source),
          zip_(source.file, source.bytes),
          bytes_left_(kFreeBytes + kMostGrowth * source.bytes.size()) {}

    std::vector<LoadedMesh> read() {
        root_ = root_entry();
        load_part(root_);
        const ModelPart& model = parts_.at(root_);
        if (model.items.empty()) throw InputError(source_.file, root_, "nothing is to be built: there are no items");
        std::vector<LoadedMesh> loaded;
        std::map<ShapeKey, std::size_t> known;  // index in `loaded`
        std::size_t unprintable = 0, supports = 0;
        for (const ModelItem& item : model.items) {
            const ModelObject& object = find(item.object);
            if (!item.printable) {
                ++unprintable;
            } else if (object.type != "model" && object.type != "surface") {
                ++supports;
            } else if (const auto [at, is_new] = known.try_emplace(shape_key(item), loaded.size()); is_new) {
                loaded.push_back(load(item, object));
            } else {
                ++loaded[at->second].instances;
            }
        }
        if (loaded.empty()) throw InputError(source_.file, root_, "nothing is to be built: no item is printable");
        note(loaded.front(), unprintable, "marked as not printable");
        note(loaded.front(), supports, "support or of no known type");
        make_names_differ(loaded);
        return loaded;
    }

  private:
    /// Unpacks through one allowance for the whole archive.
    void unpack(const std::string& entry, const std::function<void(std::string_view)>& consume) {
        zip_.unpack(entry, bytes_left_, [&](std::string_view piece) {
            throw_if_stopped(source_.stop);
            bytes_left_ -= piece.size();
            consume(piece);
        });
    }

    std::string root_entry() {
        const std::string relationships = "_rels/.rels";
        if (!zip_.has(relationships)) throw InputError(source_.file, "", "is a ZIP archive, but not a 3MF");
        RelationshipParser relations(source_.file, relationships);
        unpack(relationships, [&](std::string_view piece) { relations.parser.feed(piece); });
        relations.parser.finish();
        if (relations.target.empty()) throw InputError(source_.file, relationships, "names no 3D model");
        return relations.target.substr(relations.target.front() == '/' ? 1 : 0);
    }

    void load_part(const std::string& entry) {
        if (parts_.contains(entry)) return;
        ModelPart part = parse_model_part(source_.file, entry, [&](const auto& consume) { unpack(entry, consume); });
        if (entry != root_ && part.unit != parts_.at(root_).unit) {
            throw InputError(source_.file, entry, "its unit is not that of " + root_);
        }
        for (const auto& [key, object] : part.objects) {
            held_triangles_ += object.mesh.triangles.size();
        }
        parts_.emplace(entry, std::move(part));
    }

    const ModelObject& find(const ObjectKey& key) {
        load_part(key.part);
        const ModelPart& part = parts_.at(key.part);
        const auto found = part.objects.find(key);
        if (found == part.objects.end()) fail(key, "is referred to, but not in the file");
        return found->second;
    }

    LoadedMesh load(const ModelItem& item, const ModelObject& object) {
        LoadedMesh loaded;
        const std::string own_name = object.part_number.empty() ? object.name : object.part_number;
        // Items of ours are called by the copy's number and the object's name.
        loaded.name = item.part_number.empty() || is_numbered(item.part_number, own_name) ? own_name : item.part_number;
        loaded.object = name_of(item.object);
        loaded.item_transform = item.transform;
        loaded.unit = parts_.at(root_).unit;
        const Extent extent = extent_of(item.object, 0);
        objects_ += extent.objects;
        triangles_ += extent.triangles;
        if (objects_ > kMostObjects || triangles_ > kFreeTriangles + kMostRepeats * held_triangles_) {
            fail(item.object, "its components and items multiply beyond measure");
        }
        append(loaded.mesh, item.object, item.transform);
        return loaded;
    }

    std::string name_of(const ObjectKey& key) const { return key.part == root_ ? key.id : key.part + "#" + key.id; }

    /// Each object once.
    Extent extent_of(const ObjectKey& key, int level) {
        if (const auto known = extents_.find(key); known != extents_.end()) return known->second;
        if (level > kMostLevels) fail(key, "its components are nested too deep or contain themselves");
        const ModelObject& object = find(key);
        Extent extent{1, object.mesh.triangles.size()};
        for (const ModelComponent& component : object.components) {
            const Extent part = extent_of(component.object, level + 1);
            extent.objects = std::min(extent.objects + part.objects, kPlenty);
            extent.triangles = std::min(extent.triangles + part.triangles, kPlenty);
        }
        extents_.emplace(key, extent);
        return extent;
    }

    void append(Mesh& mesh, const ObjectKey& key, const Transform& transform) {
        throw_if_stopped(source_.stop);
        const ModelObject& object = find(key);
        spectralpack::append(mesh, transformed(object.mesh, transform));
        for (const ModelComponent& component : object.components) {
            append(mesh, component.object, transform * component.transform);
        }
    }

    static void note(LoadedMesh& loaded, std::size_t items, const std::string& what) {
        if (items == 0) return;
        loaded.warnings.push_back({"has " + std::to_string(items) +
                                       (items == 1 ? " build item that is " : " build items that are ") + what +
                                       " and left out",
                                   "have build items that are " + what + " and left out"});
    }

    void make_names_differ(std::vector<LoadedMesh>& loaded) const {
        for (LoadedMesh& mesh : loaded) {
            if (!mesh.name.empty()) continue;
            mesh.name = loaded.size() == 1 ? source_.stem : source_.stem + "-" + *mesh.object;
        }
    }

    [[noreturn]] void fail(const ObjectKey& key, const std::string& cause) const {
        throw InputError(source_.file, key.part + " object " + quoted_excerpt(key.id), cause);
    }

    const MeshBytes& source_;
    ZipReader zip_;
    std::uint64_t bytes_left_;
    std::string root_;
    std::map<std::string, ModelPart> parts_;
    std::map<ObjectKey, Extent> extents_;
    std::uint64_t held_triangles_ = 0;           ///< of the parts read so far
    std::uint64_t objects_ = 0, triangles_ = 0;  ///< of what was loaded, copies included
};

}  // namespace

std::vector<ParsedMesh> parse_3mf(const MeshBytes& source) {
    std::vector<ParsedMesh> parsed;
    for (LoadedMesh& loaded : Reader(source).read()) {
        parsed.push_back({std::move(loaded)});
    }
    return parsed;
}

}  // namespace spectralpack
