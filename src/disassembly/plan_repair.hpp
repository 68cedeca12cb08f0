#pragma once
/// A disassembly plan that more copies are let into: those that were discarded so that the rest came apart and that may
/// stay after all, and new ones. What goes as before is not planned again.

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "disassembly/disassembler.hpp"

namespace spectralpack {

class PlanRepair {
  public:
    /// After how many steps a part was discarded that was not.
    static constexpr std::size_t kStayed = std::numeric_limits<std::size_t>::max();
    /// So many are planned for anew at most where nothing else is asked for: more take long, and seldom come apart.
    static constexpr std::size_t kMostAnew = 50;

    /// The plan of `parts`, named by their index, and after how many of its steps each was discarded. `options` is
    /// referred to; it knows the names.
    PlanRepair(const DisassemblyOptions& options, std::vector<Body> parts, const std::vector<RemovalStep>& steps,
               std::vector<std::size_t> discarded_after);
    PlanRepair(const PlanRepair&) = delete;
    PlanRepair& operator=(const PlanRepair&) = delete;

    /// Lets a discarded part stand where it stood, if a plan for all is found. It leaves before the first step that it
    /// is in the way of, or else, with those whose way it is in then and those whose way they are in, last: these are
    /// taken apart anew, by themselves. The others go as before. Where they hold each other, lighter ones than the part
    /// may be discarded instead. Nothing changes where they hold each other all the same, or are more than `most`.
    bool let_back(int part, std::size_t most = kMostAnew);

    /// Likewise for a new part, of another name, for which nobody is discarded.
    bool let_in(int name, Body part, std::size_t most = kMostAnew);
    /// A new part that leaves before all others.
    void put_first(int name, Body part, std::vector<Vec3> path);

    bool out(int part) const { return is_out(static_cast<std::size_t>(part)); }
    /// The plan now, by names. Groups still name parts that are out.
    std::vector<RemovalStep> steps() const;
    int fills() const { return fills_; }

  private:
    using Members = std::vector<std::size_t>;
    using Path = std::vector<Vec3>;
    struct Step {
        RemovalStep step;    ///< by index
        std::size_t number;  ///< ascending; those of the first plan come first
    };
    class Letting;
    /// An index, and a step's number or how many there were.
    using Since = std::pair<std::size_t, std::size_t>;
    /// What members that stand by themselves come to.
    struct TakenApart {
        std::vector<RemovalStep> steps;
        std::vector<Since> discarded;
    };

    bool is_out(std::size_t part) const { return discarded_after_[part] != kStayed; }
    bool let(std::size_t part, std::size_t most, bool instead);
    void add(int name, Body part, std::size_t discarded_after);
    void remove_last();
    Members movers(const RemovalStep& step) const;
    bool free_of(const Members& movers, const Path& path, const Members& others) const;
    void gather(const Members& standing);
    std::optional<Path> way_out(std::size_t part, const Members& standing);
    std::optional<TakenApart> take_apart(const Members& members, std::size_t part, bool instead);
    std::optional<int> lightest_of(const std::vector<std::vector<int>>& stuck, const Members& members,
                                   std::size_t part) const;
    DisassemblyOptions options_of(const Members& members) const;
    std::vector<Body> parts_of(const Members& members) const;

    const DisassemblyOptions& options_;
    std::vector<Body> parts_;
    std::vector<double> weights_;  // voxels
    std::vector<int> names_;
    std::vector<Step> steps_;
    std::vector<std::size_t> discarded_after_;
    std::size_t next_number_ = 0;
    Members last_stuck_;  // held the last part that no plan was found with
    int fills_ = 0;

    // Those that stood when a way out was last asked for: most stand then as well when it is asked for again.
    static constexpr std::size_t kAway = std::numeric_limits<std::size_t>::max();
    DisassemblyOptions by_index_;
    std::optional<Subassembly> subassembly_;
    std::vector<std::size_t> places_;  // in the subassembly, by part; kAway: not there
};

}  // namespace spectralpack
