#pragma once
/// Takes a tray's copies apart (section 4): what leaves by a straight way, as rays suggest and exact sweeps confirm
/// (4.4); what leaves by any way, found by flood fill (4.1, 4.2); what leaves only as a group that moves as one.

#include <functional>
#include <list>
#include <optional>
#include <utility>
#include <vector>

#include "disassembly/subassembly.hpp"
#include "spectralpack/disassembly.hpp"

namespace spectralpack {

class Disassembler {
  public:
    using Left = std::function<void(int left, int all)>;  ///< told how many movable copies still stand

    struct Rules {
        /// The steps of a plan that was there before (null: none), which are tried where nothing else is found.
        const std::vector<RemovalStep>* told = nullptr;
        /// top: upwards, the uppermost first (docs/algorithm/disassembly.md, step 9).
        Unpack unpack = Unpack::any;
        /// With Unpack::top, a part that never moves: the walls of a container that may give way. What has no other way
        /// out leaves straight through them, or as told.
        std::optional<std::size_t> walls = {};
    };

    /// `parts` are named by their index. `options` is referred to, and so is what is told.
    Disassembler(const DisassemblyOptions& options, std::vector<Body> parts, Left left, const Rules& rules);
    Disassembler(const DisassemblyOptions& options, std::vector<Body> parts, Left left)
        : Disassembler(options, std::move(parts), std::move(left), Rules{}) {}
    ~Disassembler();

    /// Takes out all that comes out, which does not depend on the order: what leaves is in nobody's way any more.
    /// (Where walls give way, all that comes out without them, if a plan for it is told.) May be called again after
    /// discard(). Ends early when stopped.
    void run();

    const std::vector<RemovalStep>& steps() const { return steps_; }
    /// Positions in steps() of those that the walls gave way to, ascending.
    const std::vector<int>& through_walls() const { return through_walls_; }
    /// Movable copies that have neither left nor been discarded.
    int standing() const { return standing_; }
    /// Copies that hold each other, fixed ones among them: each a subassembly of which no copy and no group of copies
    /// that was looked at can leave; ascending. After a run that was not stopped these are all that stand, but for
    /// fixed ones that nothing is left with.
    std::vector<std::vector<int>> stuck() const;
    /// The copy is not part of the tray any more, without a step.
    void discard(int part);
    const InterlockCounts& counts() const { return counts_; }

  private:
    class Dismantler;

    const DisassemblyOptions& options_;
    Left left_;
    Rules rules_;
    std::list<Dismantler> dismantlers_;
    std::vector<RemovalStep> steps_;
    std::vector<int> through_walls_;
    InterlockCounts counts_;
    int all_ = 0, standing_ = 0;  // movable copies
};

}  // namespace spectralpack
