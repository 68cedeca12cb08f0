#pragma once
/// An engine that answers as another one does, but for the best placement, of which who derives from it has its own
/// idea.

#include <cstdint>
#include <memory>
#include <utility>

#include "search/placement_search.hpp"

namespace spectralpack {

/// What is admitted is another matter than what is free: to the engine shapes of which not every candidate is are
/// shapes of their own, with these bits in their ids.
inline constexpr std::uint64_t kReachableIds = std::uint64_t{1} << 63, kUnlinkedIds = std::uint64_t{1} << 62;

class ForwardingSearch : public PlacementSearch {
  public:
    /// `engine` outlives it.
    explicit ForwardingSearch(PlacementSearch& engine) : engine_(engine) {}

    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return engine_.free_positions(tray, shape, index, query);
    }
    std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                               const FreeQuery& query) override {
        return engine_.free_tiles(tray, std::move(solid), query);
    }
    const char* name() const override { return engine_.name(); }
    std::int64_t memory() const override { return engine_.memory(); }
    void forget() override { engine_.forget(); }

  protected:
    PlacementSearch& engine_;
};

}  // namespace spectralpack
