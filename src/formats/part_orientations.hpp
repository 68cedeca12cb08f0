#pragma once
/// A part's orientations as job files and packing files hold them: "any", "fixed", "upright",
/// {"axes": ["+z", "-x"], "yaw": 90} or {"matrices": [3 rows of 3 numbers, ...]}.

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "formats/json_node.hpp"
#include "spectralpack/orientations.hpp"

namespace spectralpack {

/// Throws InputError with the path of the value that makes no sense: an axis or a step that is none, a matrix that is
/// sheared, scaled or mirrored.
PartOrientations part_orientations_of(const Node& node);

/// "any", "fixed", "upright", or axes that may point up, with blanks between: "+z -x". None for anything else.
std::optional<PartOrientations> part_orientations_in(std::string_view text);

nlohmann::ordered_json part_orientations_json(const PartOrientations& orientations);

}  // namespace spectralpack
