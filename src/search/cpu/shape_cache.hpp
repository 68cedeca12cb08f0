#pragma once
/// What is kept of shapes from search to search in the same tray, within a budget; what was least useful for its size
/// goes first. Forgetting any of it costs time, never the answer.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "search/cpu/scan/incumbent.hpp"
#include "search/cpu/scan/position_state.hpp"
#include "search/cpu/shapes/orientation_lists.hpp"

namespace spectralpack {

class ShapeCache {
  public:
    explicit ShapeCache(std::int64_t budget) : budget_(budget) {}

    struct Entry {
        std::vector<PositionState> states;    ///< by orientation of the shape
        std::vector<OrientationRuns> runs;    ///< likewise; made when first needed
        std::vector<OrientationLists> lists;  ///< likewise
        std::vector<ScoredPosition> seeds;    ///< good places that the last search found and did not choose
        int listed_classes = 0;               ///< that had objects when lists were made
        bool listed_in_bytes = false;         ///< they are for sums in bytes
        int listed_phi_bound = 0;             ///< they serve as long as no phi is above it
        std::uint64_t version = 0;            ///< of the tables that the states belong to
        ObjectId objects = 0;                 ///< that the tray had had at that version
        CostModel model;                      ///< what those are made for
        std::int64_t state_bytes = 0, bytes = 0;
        std::int64_t hits = 0;
        bool known = false;  ///< something is, of some position
        std::uint64_t last_use = 0;
    };

    /// The shape's entry, its states brought up to the tables' version and the model; a fresh one where there is none.
    /// Stays until the next call.
    Entry& at(const Shape& shape, const Tray& tray, TrayTables& tables, const CostModel& model, const Workers& workers);

    /// Makes the lists of `open` orientations, whose runs there are, where there are none for the tables as they are,
    /// and counts what the entry holds. The cache may be over its budget until the next call of at().
    void make_lists(Entry& entry, const std::vector<bool>& open, const TrayTables& tables, const Workers& workers);

    std::int64_t bytes() const { return bytes_; }

  private:
    Entry fresh(const Shape& shape, const Tray& tray);
    void evict_for(std::int64_t bytes);

    std::int64_t budget_;
    std::int64_t bytes_ = 0;
    std::uint64_t epoch_ = 0, uses_ = 0;
    std::unordered_map<std::uint64_t, Entry> entries_;
};

/// Which orientations have candidates left; of those that the shape's only_near rules out none are from now on.
/// `margin`: overhang() of the shape.
std::vector<bool> open_orientations(const Shape& shape, int margin, std::vector<PositionState>& states);

/// Places that the next copy may take: those that lost in this search, then earlier ones.
std::vector<ScoredPosition> seeds_after(const Incumbent& incumbent, const std::vector<ScoredPosition>& before);

}  // namespace spectralpack
