#pragma once
/// The orientations a part may take: an ordered set of rotations (paper section 3.1, "Orientations Sampling"). The
/// index in it breaks ties between equal costs, so the order is part of the definition.

#include <optional>
#include <string>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// What --rotations asks for.
struct RotationSpec {
    enum class Sampling { none, euler, icosahedron };
    Sampling sampling = Sampling::euler;
    double step = 90;      ///< euler: degrees
    int subdivisions = 0;  ///< icosahedron
    bool box = false;      ///< the 24 turns of the part's minimum bounding box as well

    bool operator==(const RotationSpec&) const = default;
};

/// "none", an angle in degrees, "icosahedron" or "icosahedron:N", each also with "+box". Throws UsageError.
RotationSpec parse_rotations(const std::string& rotations);

/// The turn about the vertical between two neighbours of the sampling: its step; 360 for none.
double yaw_step(const RotationSpec& rotations);

/// A direction along a coordinate axis of the part.
struct SignedAxis {
    int axis = 2;
    bool positive = true;

    bool operator==(const SignedAxis&) const = default;
};

/// What a job says of one part's orientations.
struct PartOrientations {
    enum class Kind {
        any,       ///< the job's --rotations
        fixed,     ///< as in the file
        upright,   ///< turned about the vertical only, at the job's step
        axes,      ///< one of `up` points up, turned about the vertical by multiples of `yaw`
        matrices,  ///< these
    };
    Kind kind = Kind::any;
    std::vector<SignedAxis> up;
    std::optional<double> yaw;   ///< degrees; none: the job's step
    std::vector<Mat3> matrices;  ///< rotations

    bool operator==(const PartOrientations&) const = default;
};

/// `matrix` with rounding taken off (Gram-Schmidt on its rows); none where it is not a rotation within 1e-6: sheared,
/// scaled or mirrored.
std::optional<Mat3> as_rotation(const Mat3& matrix);

/// The part's orientation set. any: the job's sampling, then, with +box, C_i F for the 24 rotations C_i of the cube
/// (in the order of euler_orientations(90)) and F = `box_frame`, which turns the part so that its minimum bounding box
/// lies along the axes; the identity adds nothing. Equal matrices are kept once, the first. Throws UsageError.
std::vector<Mat3> orientation_set(const RotationSpec& rotations, const PartOrientations& part,
                                  const Mat3& box_frame = {});

/// The set of a part without constraints, its box frame being the axes.
std::vector<Mat3> orientation_set(const std::string& rotations);

}  // namespace spectralpack
