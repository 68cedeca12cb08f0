#pragma once
/// Two engines answering the same questions: what --verify-with runs. Equal at every step, the
/// packings are equal.

#include "core/random.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

/// Which calls the oracle answers too. Decided by seed and call number alone, so a repeated run
/// verifies the same calls.
struct VerifyingOptions {
    std::int64_t sample = 0;          ///< about so many of the expected calls; 0: every call
    std::int64_t expected_calls = 1;  ///< of best_placement; free positions are sampled at the same rate
    std::uint64_t seed = 0;
};

/// Answers with `engine`; `oracle` answers the calls of the sample on the same tray. Throws
/// InternalError that tells shape, orientation, tray version and both answers at the first
/// difference: found or none, orientation, position, proximity, cost, neighbours; free positions
/// bit by bit. Answers ended by the stop token are not compared.
class VerifyingSearch final : public PlacementSearch {
  public:
    VerifyingSearch(std::unique_ptr<PlacementSearch> engine, std::unique_ptr<PlacementSearch> oracle,
                    const VerifyingOptions& options);

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override;
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override;
    std::unique_ptr<FreeTileReader> free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                               const FreeQuery& query) override;
    const char* name() const override { return engine_->name(); }
    std::int64_t memory() const override { return engine_->memory() + oracle_->memory(); }
    void forget() override {
        engine_->forget();
        oracle_->forget();
    }

    std::int64_t verified() const { return verified_; }  ///< answers compared so far, all of them equal

  private:
    bool in_sample(std::uint64_t call, std::uint64_t kind) const;

    std::unique_ptr<PlacementSearch> engine_, oracle_;
    VerifyingOptions options_;
    std::uint64_t placements_ = 0, free_queries_ = 0;  ///< calls so far
    std::int64_t verified_ = 0;
};

}  // namespace spectralpack
