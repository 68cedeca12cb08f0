#pragma once
/// How the library talks while it works: it never prints. One vocabulary for what happens to a packing, which progress
/// displays, journals, pages and clusters all speak. All calls come from the thread that called in.

#include <cstdint>
#include <optional>
#include <string>

#include "spectralpack/geometry.hpp"
#include "spectralpack/improvement.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct Scene;

enum class Phase { load, voxelize, search, disassemble, reinsert, check, render, write, improve };

struct Progress {
    Phase phase = Phase::load;
    std::int64_t done = 0;
    std::int64_t total = 0;
    /// Of the packing so far, 0..1; only in Phase::search. None where the container has no ceiling to fill up to.
    std::optional<double> density = 0;
    double work = 0;            ///< share of the phase's expected work that is done, 0..1
    std::int64_t verified = 0;  ///< placements a second engine answered alike so far; only with --verify-with
    std::optional<Improved> improved = {};  ///< only in Phase::improve
    int order = 0, orders = 0;              ///< where several orders are packed in: which, from 1, of how many
};

enum class EventKind {
    tray_begun,      ///< the tray holds its fixed copies and nothing else, also where it held more before
    copy_placed,     ///< the copy stands in the tray, at `transform`
    copy_moved,      ///< it stands elsewhere now, in the same tray
    copy_taken_out,  ///< it stands nowhere any more
    copy_put_back,   ///< one that was taken out stands again, perhaps elsewhere
    tray_finished,   ///< nothing of the tray changes from here on, unless it is begun anew
};

/// One thing that happened. A packing is what its events add up to: whoever applies them in order holds, after
/// tray_finished, that tray's copies as the result has them (their order aside).
struct Event {
    EventKind kind = EventKind::tray_begun;
    int tray = 0;         ///< from 0
    int part = -1;        ///< index into Packing::parts; -1 for events about a tray
    int copy = -1;        ///< 0 .. count - 1 of that part; likewise
    int orientation = 0;  ///< index in the part's orientation set
    Transform transform;  ///< from the mesh's own coordinates to the container's; holds unit and scale

    bool operator==(const Event&) const = default;
};

/// Told what happens; overrides what it wants to know. Exceptions that leave it end the run.
class Listener {
  public:
    virtual ~Listener() = default;
    virtual void on_event(const Event&) {}
    virtual void on_progress(const Progress&) {}
    /// The trays that are finished, as a packing of their own, each time that another is begun. What is not in them is
    /// among its left over as not tried.
    virtual void on_trays(const Scene&) {}
    /// Something the user should know that stops nothing; once for each cause, naming the parts it is so of.
    virtual void on_warning(const std::string&) {}
};

/// What a caller holds on to while the library works: nobody needs to listen, or to be able to stop it.
struct Control {
    Listener* listener = nullptr;
    StopToken stop = {};
};

}  // namespace spectralpack
