#pragma once
/// Takes a tray's copies apart (section 4): what leaves by a straight way, as rays suggest and exact sweeps confirm
/// (4.4); what leaves by any way, found by flood fill (4.1, 4.2); what leaves only as a group that moves as one.

#include <functional>
#include <list>
#include <vector>

#include "disassembly/subassembly.hpp"
#include "spectralpack/disassembly.hpp"

namespace spectralpack {

class Disassembler {
  public:
    using Left = std::function<void(int left, int all)>;  ///< told how many movable copies still stand

    /// `parts` are named by their index. `options` is referred to, and so is `told`: the steps of a plan that was there
    /// before (null: none), which are tried where nothing else is found.
    Disassembler(const DisassemblyOptions& options, std::vector<Body> parts, Left left,
                 const std::vector<RemovalStep>* told = nullptr);
    ~Disassembler();

    /// Takes out all that comes out, which does not depend on the order: what leaves is in nobody's way any more.
    /// May be called again after discard(). Ends early when stopped.
    void run();

    const std::vector<RemovalStep>& steps() const { return steps_; }
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
    const std::vector<RemovalStep>* told_;
    std::list<Dismantler> dismantlers_;
    std::vector<RemovalStep> steps_;
    InterlockCounts counts_;
    int all_ = 0, standing_ = 0;  // movable copies
};

}  // namespace spectralpack
