#pragma once
/// A disassembly plan (section 4): how a tray's copies come apart by translations alone.
///
/// Copies in one subassembly stand together; at first that is the whole tray. A step of one placement takes it away
/// from its subassembly for good. A step of several takes them out as one rigid body, and from then on they are a
/// subassembly of their own, as if in a tray to themselves: they stand to each other as they did, later steps take them
/// apart among themselves, and what they leave behind is judged without them. Nothing is taken back.

#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// By which rule the copies of a tray leave it. any: by any way, whatever is free, as if the container's walls were not
/// there (unless it is physical). top: the uppermost first of those that are free, as one digs, over the container's
/// top, past its walls and keep-outs; only what then has no way out leaves by any.
enum class Unpack { any, top };

/// One copy, or several as one rigid group, leave their subassembly.
struct RemovalStep {
    std::vector<int>
        placements;  ///< indices into TrayPacking::placements, ascending; all of one subassembly, not all of it
    /// Translations made one after the other from where the placements stand in the packing (the way their subassembly
    /// has gone before does not matter: it moved as one), mm; each keeps clear of what is left of the subassembly. The
    /// last one ends wholly outside the bounding box of that. Empty where nothing is left of it.
    std::vector<Vec3> path;

    bool operator==(const RemovalStep&) const = default;
};

/// How the copies of a packing came apart, for the record.
struct InterlockCounts {
    int straight = 0;    ///< copies that left by a straight way
    int flooded = 0;     ///< by a way with corners, nearly all of them found by flood fill
    int groups = 0;      ///< several that left as one rigid body
    int fills = 0;       ///< flood fills, those that found no way included
    int removed = 0;     ///< copies taken out of the packing because they were interlocked
    int reinserted = 0;  ///< of those, put back where they can be taken out
    int added = 0;       ///< copies that had found no place before and did so then

    InterlockCounts operator+(const InterlockCounts& other) const {
        return {straight + other.straight, flooded + other.flooded,       groups + other.groups, fills + other.fills,
                removed + other.removed,   reinserted + other.reinserted, added + other.added};
    }
};

struct Disassembly {
    /// Every copy that is not fixed has one step of its own, also after it left in a group, and also where it is the
    /// last of its subassembly. Fixed ones that stood in a build that was topped up (Placement::before) have one as
    /// well where all of them come out, and else none; other fixed ones never move. Of the container's walls only
    /// physical ones hold anything.
    bool complete = false;
    std::vector<RemovalStep> steps;  ///< in order: each sees only what earlier ones left of its subassembly
    /// What the plan does not take apart: sets of placements that hold each other, where known. With these empty and
    /// `complete` false, the search for a plan was ended early.
    std::vector<std::vector<int>> interlocked;
    Unpack unpack = Unpack::any;  ///< the rule that the steps follow
    /// With Unpack::top: positions in `steps` of those that leave the tray by any way, through walls or keep-outs,
    /// ascending. All others that leave the tray end above the container's top and keep clear of both.
    std::vector<int> through_walls = {};
};

}  // namespace spectralpack
