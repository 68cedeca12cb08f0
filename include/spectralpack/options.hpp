#pragma once
/// Every option of `pack`, with its default. The single place where defaults stand.

#include <cstdint>
#include <optional>
#include <string>

#include "spectralpack/disassembly.hpp"
#include "spectralpack/geometry.hpp"

namespace spectralpack {

enum class Interlock { off, place, post };

/// Which copies of a set that hold each other are taken out first, before it is seen who may stay after all. smallest:
/// the paper's rule, the smallest boxes until they exceed a tenth of all; lightest: the one with the least material;
/// thinnest: the one with the least material for its box (cages, rings and springs rather than what is in them).
enum class TakeOut { smallest, lightest, thinnest };
/// Whether copies may be placed that cannot be drawn apart even by themselves, like links of a chain: what then holds
/// each other is found afterwards and taken out, as in the paper.
enum class Links { allow, avoid };
enum class Order { size, input, random, volume, mixed };
/// What a tray that cannot hold all is filled with. fair: large copies first, then as much as fits; the others look for
/// the most material, the most copies, or those that are worth most together, and may leave large ones out.
enum class Goal { fair, volume, copies, value };
enum class EngineKind { automatic, cpu, cuda, reference };
enum class HeightReference { bottom, top };
enum class Minimise { none, box };

struct VerifyWith {
    EngineKind engine = EngineKind::reference;
    int sample = 0;  ///< about how many placements to verify, chosen by seed; 0: every one

    bool operator==(const VerifyWith&) const = default;
};

/// The grid that is taken where nobody says which: dx in mm, and orientations.
inline constexpr double kUsualVoxel = 2;
inline constexpr const char* kUsualRotations = "90";

/// More would only wait for each other.
inline constexpr int kMostThreads = 1024;

struct PackOptions {
    Vec3 tray{480, 245, 200};  ///< container size, mm
    int trays = 1;             ///< containers to fill, at most; 0: as many as it takes
    /// Of several trays one is full once so many parts found no place in it; 0: never before all were tried.
    int try_per_tray = 1000;
    std::optional<std::string> printer;  ///< preset that other values come from; kept for the record
    /// dx, mm; none: kUsualVoxel, with `improve` half of it where there is the time (docs/improving.md).
    std::optional<double> voxel;
    int detail = 2;  ///< s: collisions between copies are decided on voxels of dx / s
    /// As orientations.hpp has them; none: kUsualRotations, with `improve` also "+box" where there is the time.
    std::optional<std::string> rotations;
    bool upright = false;                   ///< parts that say nothing of their orientations keep their top up
    double gap = 0.2;                       ///< least distance between two copies, mm
    double wall_gap = 0;                    ///< least distance to the container, mm
    bool refine = true;                     ///< continuous refinement (section 3.2)
    Interlock interlock = Interlock::post;  ///< section 4
    Links links = Links::avoid;             ///< with Interlock::post
    TakeOut take_out = TakeOut::thinnest;   ///< the same
    std::optional<Unpack> unpack;           ///< none: top in boxes, any in container meshes
    std::optional<double> ray_spacing;      ///< mm, of rays that look for ways out (section 4.4); none: 4 dx / s
    std::optional<double> height_penalty;   ///< p of equation 5; none: appendix A.2
    /// None: at the top without a ceiling and in trays that hold all that is left, else at the bottom; at the bottom
    /// where a height penalty is given, and with `fill`.
    std::optional<HeightReference> height_at;
    bool open_height = false;  ///< least height; the tray's z is the reference height (0: its longer side)
    Minimise minimise = Minimise::none;
    bool fill = false;                     ///< as many copies as fit, in the shares that the counts give
    std::optional<double> max_density;     ///< share of the container that copies may take
    std::optional<double> max_layer_fill;  ///< share of a layer's area that cross-sections may take
    Order order = Order::size;
    int restarts = 1;  ///< orders to pack in, of which the best is kept
    int beam = 1;      ///< states that a beam search over orders keeps; 1: none
    Goal goal = Goal::fair;
    /// Seconds to make the first packing better; 0: the rest of the time for placing; none: it stays as it is. Kept for
    /// the record, the caller holds the clock (Job::enough_improved).
    std::optional<int> improve;
    int improve_steps = 0;  ///< orders tried to that end, at most; 0: as many as there is time for
    EngineKind engine = EngineKind::automatic;
    int threads = 0;  ///< 0: all the machine has; at most kMostThreads
    std::uint64_t seed = 0;
    std::int64_t memory = 0;  ///< bytes the run may use; 0: what the machine has free
    std::optional<VerifyWith> verify_with;
    std::optional<double> time_limit;  ///< seconds; kept for the record, the caller holds the clock
};

}  // namespace spectralpack
