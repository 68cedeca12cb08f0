#pragma once
/// Takes one subassembly apart, for Disassembler: the tray, or a group that has left it.

#include <optional>
#include <vector>

#include "disassembly/disassembler.hpp"
#include "disassembly/graph/blocking_graph.hpp"
#include "disassembly/ways_out.hpp"

namespace spectralpack {

class Disassembler::Dismantler {
  public:
    using Members = Subassembly::Members;

    Dismantler(Disassembler& owner, std::vector<int> names, std::vector<Body> parts, Unpack unpack);
    /// `members` of `founder`, which are about to leave it as one; what is known of them still holds.
    Dismantler(const Dismantler& founder, const Members& members, std::vector<std::optional<Flooded>> known);

    const Subassembly& subassembly() const { return subassembly_; }
    void run();
    bool discard(int name);

  private:
    /// Ways tried at a time. Not the number of threads: which edges are found must not depend on it.
    static constexpr std::size_t kBatch = 8;

    /// Known to have no way out as things stand.
    bool stuck(std::size_t i) const { return known_[i] && known_[i]->closed_region; }

    void remove(std::size_t i);
    /// `members` leave by `path` as one.
    void leave(const Members& members, Subassembly::Path path);
    /// Those not known to meet anyone in that direction, the highest first.
    Members ready(AxisDirection direction) const;
    Members highest_first(Members members) const;
    /// What a sweep found, for later ones.
    void learn(const Subassembly::Straight& way, AxisDirection direction);

    // Each takes out what its name says, if it can; true when it did.
    bool leave_straight();
    bool leave_straight(AxisDirection direction, bool all);
    bool leave_by_flood();
    bool leave_as_group(std::size_t most);
    bool leave_as_told();
    bool leave_beside_the_grid();
    void found_subassembly(const Members& group, Subassembly::Path path);

    /// Finds a way out for each of these, or that there is none. False: stopped.
    bool flood(const Members& members);

    // From the top (from_the_top.cpp).
    bool leave_by_hand();
    bool leave_from_the_top();
    void find_ways_up();
    Members standing_by_turn() const;
    bool know(Members::const_iterator begin, Members::const_iterator end);
    bool leave_by_few_moves(const Members& members);
    bool leave_by_a_winding_way();
    bool leave_through_the_walls();
    bool leave_straight_through_the_walls();
    /// So many stand that a group of all is no group: walls that give way are not among them.
    std::size_t standing() const;

    Disassembler& owner_;
    Subassembly subassembly_;
    BlockingGraph graph_;
    std::vector<std::optional<Flooded>> known_;  // of those asked about: a way for good, or the closed region
    std::vector<std::size_t> turns_;             // the order of flood fills, the highest first
    std::size_t turn_ = 0;
    bool few_moves_first_;  // ways of many moves come after groups
    bool from_the_top_ = false;
    std::vector<std::optional<Subassembly::Path>> up_;  // from the top: straight ways up, for good
    std::optional<std::size_t> walls_;                  // that give way
};

}  // namespace spectralpack
