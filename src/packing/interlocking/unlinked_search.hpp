#pragma once
/// Placement where no two copies hold each other: an engine whose best_placement() never answers with a position from
/// which the copy could not be drawn away from some copy that stands even if nothing else stood. Such pairs, linked
/// rings above all, are most of what is interlocked in a dense packing; what three or more copies do together is left
/// to taking the tray apart.
///
/// Definition: a position q of an orientation is unlinked if, for every object b of the tray, link_sample(A) can be
/// moved from q to where A is outside of b's box by single steps along x, y and z through positions where it does not
/// meet b, all in the voxels that collisions are decided on (dx / s). The best unlinked placement is the best placement
/// (conventions.md) among the candidates that the shape admits and that are also unlinked.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "search/forwarding_search.hpp"
#include "voxel/outlines.hpp"

namespace spectralpack {

/// What stands for a solid where links are looked for: a row_sample() of it. What is thinner than the rows are apart
/// may slip between them, and a link be missed.
BitGrid link_sample(const BitGrid& solid);

class UnlinkedSearch : public ForwardingSearch {
  public:
    /// `engine` outlives it.
    explicit UnlinkedSearch(PlacementSearch& engine);
    ~UnlinkedSearch() override;

    /// Asks the engine, which asks back of each candidate that would be the best so far. Most can be drawn straight
    /// away from every copy whose box they reach into, as outlines tell; for the others walks outwards answer, each
    /// past one object, in cells of positions first, and are remembered as long as copies of the same shape are asked
    /// about. Their answers are remembered longer: local search asks about the same pairs over and over.
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    std::int64_t memory() const override { return engine_.memory() + bytes_; }
    void forget() override;

    /// From now on outlines and answers may take so many bytes, where that is more than kept_in() says.
    void keep_answers(std::int64_t bytes) { answers_ = bytes; }

    /// Bytes of what is kept at most because it may be asked again, in a tray of so many voxels that collisions are
    /// decided on: outlines and answers, and one shape's walks.
    struct Kept {
        std::int64_t outlines, walks;
        std::int64_t all() const { return outlines + walks; }
    };
    static Kept kept_in(std::int64_t voxels) {
        constexpr std::int64_t kMost = std::int64_t{64} << 20, kEnough = std::int64_t{16} << 20;
        return {std::min(kMost, voxels / 2), std::min({kMost, voxels, std::max(kEnough, voxels / 3)})};
    }

  private:
    struct Form;
    struct Known;
    class Asking;

    /// A solid that stands in a tray; held, so that no other takes its address.
    struct Standing {
        std::shared_ptr<const BitGrid> solid;
        std::shared_ptr<const Outlines> outlines;
    };
    void forget_poses();

    std::uint64_t followed_ = 0;  // the tray whose objects the known is of
    Kept kept_{};                 // in that
    std::int64_t answers_ = 0;
    std::map<const BitGrid*, Standing> standing_;                        // those that have been asked for
    std::map<std::uint64_t, std::vector<std::unique_ptr<Form>>> forms_;  // by shape and orientation
    std::atomic<std::int64_t> bytes_ = 0;                                // of both
    std::unique_ptr<Known> known_;  // of that tray's objects and the shape asked about last
};

/// The same with an engine of its own.
std::unique_ptr<PlacementSearch> make_unlinked_search(std::unique_ptr<PlacementSearch> engine);

}  // namespace spectralpack
