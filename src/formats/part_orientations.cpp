#include "formats/part_orientations.hpp"

#include <algorithm>
#include <utility>

#include "model/rotation_samples.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

using Kind = PartOrientations::Kind;

/// "+x".
std::string axis_text(const SignedAxis& axis) {
    return {axis.positive ? '+' : '-', static_cast<char>('x' + axis.axis)};
}

std::optional<SignedAxis> axis_in(std::string_view text) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool positive : {true, false}) {
            if (text == axis_text({axis, positive})) return SignedAxis{axis, positive};
        }
    }
    return std::nullopt;
}

SignedAxis axis_of(const Node& node) {
    if (const auto axis = axis_in(node.text())) return *axis;
    node.fail("must be one of +x, -x, +y, -y, +z, -z");
}

double step_of(const Node& node) {
    const double step = node.positive();
    try {
        require_step(step, "it");
    } catch (const UsageError&) {
        node.fail("must be an angle in degrees, 6 or more, that divides 360");
    }
    return step;
}

Mat3 rotation_of(const Node& node) {
    node.expect_size(3);
    Mat3 matrix;
    for (std::size_t row = 0; row < 3; ++row) {
        matrix.rows[row] = vector_of(node.element(row));
    }
    const auto rotation = as_rotation(matrix);
    if (!rotation) {
        node.fail(determinant(matrix) < 0 ? "must not mirror the part" : "must be a rotation (within 1e-6)");
    }
    return *rotation;
}

}  // namespace

PartOrientations part_orientations_of(const Node& node) {
    PartOrientations orientations;
    if (node.is_text()) {
        orientations.kind = node.one_of<Kind>();
        return orientations;
    }
    node.expect_keys({"axes", "yaw", "matrices"});
    const auto axes = node.find("axes"), yaw = node.find("yaw"), matrices = node.find("matrices");
    if (axes.has_value() == matrices.has_value()) node.fail("must have either axes or matrices");
    if (axes) {
        orientations.kind = Kind::axes;
        axes->for_each([&](const Node& axis) { orientations.up.push_back(axis_of(axis)); });
        if (orientations.up.empty()) axes->fail("must name an axis");
        if (yaw) orientations.yaw = step_of(*yaw);
    } else {
        if (yaw) yaw->fail("goes with axes only");
        orientations.kind = Kind::matrices;
        matrices->for_each([&](const Node& matrix) { orientations.matrices.push_back(rotation_of(matrix)); });
        if (orientations.matrices.empty()) matrices->fail("must hold a matrix");
    }
    return orientations;
}

std::optional<PartOrientations> part_orientations_in(std::string_view text) {
    PartOrientations orientations;
    if (const auto kind = from_string<Kind>(text)) {
        orientations.kind = *kind;
        return orientations;
    }
    orientations.kind = Kind::axes;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (word.empty()) continue;
        const auto axis = axis_in(word);
        if (!axis) return std::nullopt;
        orientations.up.push_back(*axis);
    }
    if (orientations.up.empty()) return std::nullopt;
    return orientations;
}

nlohmann::ordered_json part_orientations_json(const PartOrientations& orientations) {
    using Json = nlohmann::ordered_json;
    if (orientations.kind == Kind::axes) {
        Json axes = Json::array();
        for (const SignedAxis& axis : orientations.up) {
            axes.push_back(axis_text(axis));
        }
        return {{"axes", std::move(axes)}, {"yaw", orientations.yaw ? Json(*orientations.yaw) : Json(nullptr)}};
    }
    if (orientations.kind == Kind::matrices) {
        Json matrices = Json::array();
        for (const Mat3& matrix : orientations.matrices) {
            Json rows = Json::array();
            for (const Vec3& row : matrix.rows) {
                rows.push_back({row.x, row.y, row.z});
            }
            matrices.push_back(std::move(rows));
        }
        return {{"matrices", std::move(matrices)}};
    }
    return to_string(orientations.kind);
}

}  // namespace spectralpack
