#pragma once
/// Every option of `pack`, with its default. The single place where defaults stand.

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/vec3.hpp"

namespace spectralpack {

enum class Interlock { off, place, post };
enum class Order { size, input, random };
enum class EngineKind { automatic, cpu, cuda, reference };
enum class HeightReference { bottom, top };

struct VerifyWith {
    EngineKind engine = EngineKind::reference;
    int sample = 0;  ///< about how many placements to verify, chosen by seed; 0: every one

    bool operator==(const VerifyWith&) const = default;
};

struct PackOptions {
    Vec3 tray{480, 245, 200};       ///< container size, mm
    double voxel = 2;               ///< dx, mm
    std::string rotations = "90";   ///< none, or an angle in degrees that divides 360
    double gap = 0.2;               ///< least distance between two copies, mm
    double wall_gap = 0;            ///< least distance to the container, mm
    bool refine = false;            ///< continuous refinement (section 3.2)
    Interlock interlock = Interlock::post;    ///< section 4: see that the packing comes apart
    std::optional<double> height_penalty;     ///< p of equation 5; none: appendix A.2
    HeightReference height_at = HeightReference::bottom;
    Order order = Order::size;
    EngineKind engine = EngineKind::automatic;
    int threads = 0;                ///< 0: all the machine has
    std::uint64_t seed = 0;
    std::int64_t memory = 0;        ///< bytes the run may use; 0: what the machine has free
    std::optional<VerifyWith> verify_with;
    std::optional<double> time_limit;  ///< seconds; kept for the record, the caller holds the clock
};

}  // namespace spectralpack
