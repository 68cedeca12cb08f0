#pragma once
/// What a run has decided, kept outside of packing so that a run that was killed can go on (docs/reliability.md).
///
/// Packing is deterministic: given the same job, all that takes long is known once these answers are. So it tells each
/// as it is made, and before it works on one it asks whether a run before has made it. Decisions belong to fillings, of
/// which each is one tray filled once, perhaps to be given up; they come in the same order in every run.

#include <cstdint>
#include <optional>
#include <vector>

#include "packing/tray/filled_tray.hpp"
#include "spectralpack/disassembly.hpp"

namespace spectralpack {

/// The answer of find_place().
struct FoundPlace {
    Copy copy;
    int layers = 0;  ///< of the tray then: under an open ceiling it may have grown
    std::optional<BestPlacement> best;
};

/// Where a copy came to stand by refinement, mm, as Settled has it.
struct SettledCopy {
    Copy copy;
    Vec3 offset;
};

/// A tray before it is taken apart.
struct PackedTray {
    int layers = 0;
    GreedyResult result;
};

/// What taking it apart came to.
struct TakenApart {
    std::vector<int> out;  ///< indices of what was in the way of that, ascending
    Disassembly plan;      ///< of the others, by their index once those are out
    InterlockCounts counts;
};

/// What improving a tray has come to; each takes the place of the one before.
struct ImprovedTray {
    std::int64_t steps = 0;
    int starts = 0;
    double seconds = 0;  ///< spent
    int x = 0, y = 0;    ///< voxels of the best's base, where that was searched for
    FilledTray tray;     ///< the best
};

/// For one thread. What is recalled of a filling comes in the order in which it was kept.
class Decisions {
  public:
    virtual ~Decisions() = default;

    /// What follows is about another filling.
    virtual void begin_filling() = 0;

    // The next such decision of the filling; none: it was not made before. Throws InternalError where the next answer
    // is about another copy than `copy`.
    virtual std::optional<FoundPlace> recall_place(const Copy& copy) = 0;
    virtual std::optional<SettledCopy> recall_settled(const Copy& copy) = 0;
    virtual std::optional<PackedTray> recall_packed() = 0;
    virtual std::optional<TakenApart> recall_taken_apart() = 0;
    virtual std::optional<FilledTray> recall_filled() = 0;
    virtual std::optional<ImprovedTray> recall_improved() = 0;

    // What was not recalled and is decided now. Exceptions that leave them end the packing.
    virtual void keep(const FoundPlace& found) = 0;
    virtual void keep(const SettledCopy& settled) = 0;
    virtual void keep(const PackedTray& packed) = 0;
    virtual void keep(const TakenApart& taken_apart) = 0;
    virtual void keep(const FilledTray& filled) = 0;
    virtual void keep(const ImprovedTray& improved) = 0;
};

}  // namespace spectralpack
