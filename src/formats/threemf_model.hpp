#pragma once
/// The model part of a 3MF (core specification 1.3) as it is written, nothing resolved yet.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// Which object: its id, in which model part (production extension: another than the one that
/// refers to it).
struct ObjectKey {
    std::string part;  ///< entry of the archive, without leading slash
    std::string id;

    auto operator<=>(const ObjectKey&) const = default;
};

struct ModelComponent {
    ObjectKey object;
    Transform transform;
};

struct ModelObject {
    std::string type = "model";
    std::string name, part_number;
    Mesh mesh;  ///< empty for an object of components
    std::vector<ModelComponent> components;
};

struct ModelItem {
    ObjectKey object;
    Transform transform;
    std::string part_number;
    bool printable = true;
};

struct ModelPart {
    double unit = 1;  ///< mm
    std::map<ObjectKey, ModelObject> objects;
    std::vector<ModelItem> items;
};

/// Hands the text of a model part over piece by piece.
using TextSource = std::function<void(const std::function<void(std::string_view)>&)>;

/// Parses the model part `entry` of `file`. Throws InputError for what the specification forbids or
/// what needs an extension that changes geometry and is not known here.
ModelPart parse_model_part(const std::string& file, const std::string& entry, const TextSource& text);

}  // namespace spectralpack
