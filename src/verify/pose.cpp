#include "verify/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/words.hpp"

namespace spectralpack {
namespace {

bool is_finite(const Transform& transform) {
    double sum = transform.translation.x + transform.translation.y + transform.translation.z;
    for (const Vec3& row : transform.linear.rows) {
        sum += row.x + row.y + row.z;
    }
    return std::isfinite(sum);
}

/// Greatest entry of |M - 1|.
double difference_from_identity(const Mat3& m) {
    double worst = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            worst = std::max(worst, std::abs(m.rows[row][column] - (row == column ? 1 : 0)));
        }
    }
    return worst;
}

}  // namespace

PoseVerdict judge_pose(const Transform& transform, double scale) {
    if (!is_finite(transform)) {
        return {"has a transform with numbers that are not finite", std::numeric_limits<double>::infinity()};
    }
    const Mat3 rotation = 1 / scale * transform.linear;
    const Mat3 gram = transposed(rotation) * rotation;
    PoseVerdict verdict{"", difference_from_identity(gram)};
    const double square = (gram.rows[0].x + gram.rows[1].y + gram.rows[2].z) / 3;
    if (determinant(rotation) <= 0) {
        verdict.fault = determinant(rotation) < 0 ? "is mirrored" : "is flattened by its transform";
    } else if (verdict.deviation > kRotationTolerance) {
        const bool even = difference_from_identity(1 / square * gram) <= kRotationTolerance;
        verdict.fault =
            even ? "is scaled by " + short_number(std::sqrt(square) * scale) + ", not by " + short_number(scale)
                 : "is sheared or scaled unevenly";
    }
    return verdict;
}

}  // namespace spectralpack
