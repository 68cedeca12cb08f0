#include "search/verifying_search.hpp"

#include <sstream>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

std::ostream& operator<<(std::ostream& out, const VoxelIndex& v) {
    return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

std::ostream& operator<<(std::ostream& out, const Cost& cost) {
    return out << '(' << cost.primary << ", " << cost.secondary << ')';
}

std::ostringstream exact_text() {
    std::ostringstream text;
    text.precision(17);  // tells any two doubles apart
    return text;
}

/// "7 (index 2)": the job's number of the orientation and the shape's.
std::string orientation_text(const Shape& shape, int index) {
    const bool valid = index >= 0 && index < static_cast<int>(shape.orientations.size());
    return (valid ? std::to_string(shape.orientations[static_cast<std::size_t>(index)].orientation)
                  : "none of the shape's") +
           " (index " + std::to_string(index) + ')';
}

std::string describe(const Shape& shape, const std::optional<BestPlacement>& best) {
    if (!best) return "none";
    std::ostringstream text = exact_text();
    text << "orientation " << orientation_text(shape, best->index) << " at " << best->position << ", proximity "
         << best->proximity << ", cost " << best->cost << ", neighbours";
    for (const Cost& cost : best->neighbours) {
        text << ' ' << cost;
    }
    return text.str();
}

std::string describe(const FreePositions& free) {
    std::ostringstream text = exact_text();
    const Extent& e = free.free.extent();
    text << free.free.count() << " free positions of " << e.x << " x " << e.y << " x " << e.z << " from "
         << free.origin;
    return text.str();
}

/// The first position at which two answers of the same extent differ.
std::string first_difference(const FreePositions& a, const FreePositions& b) {
    if (!(a.origin == b.origin && a.free.extent() == b.free.extent())) return "";
    std::ostringstream text = exact_text();
    const Extent& e = a.free.extent();
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; ++y) {
            for (int x = 0; x < e.x; ++x) {
                if (a.free.get(x, y, z) == b.free.get(x, y, z)) continue;
                text << "; first at " << a.origin + VoxelIndex{x, y, z};
                return text.str();
            }
        }
    }
    return "";
}

[[noreturn]] void fail(const PlacementSearch& engine, const PlacementSearch& oracle, const std::string& question,
                       const Tray& tray, const Shape& shape, const std::string& answer, const std::string& expected) {
    std::ostringstream text;
    text << "engines differ in the " << question << " of shape " << shape.id << " in tray " << tray.instance()
         << ", version " << tray.version() << ": " << engine.name() << " says " << answer << "; " << oracle.name()
         << " says " << expected;
    throw InternalError(text.str());
}

}  // namespace

VerifyingSearch::VerifyingSearch(std::unique_ptr<PlacementSearch> engine, std::unique_ptr<PlacementSearch> oracle,
                                 const VerifyingOptions& options)
    : engine_(std::move(engine)), oracle_(std::move(oracle)), options_(options) {}

bool VerifyingSearch::in_sample(std::uint64_t call, std::uint64_t kind) const {
    if (options_.sample <= 0 || options_.sample >= options_.expected_calls) return true;
    // A stream per call: its first number depends on seed, call and kind only.
    RandomStream seeds(options_.seed);
    RandomStream random(seeds.next() ^ (2 * call + kind));
    return random.below(static_cast<std::uint64_t>(options_.expected_calls)) <
           static_cast<std::uint64_t>(options_.sample);
}

SearchResult VerifyingSearch::best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                             const StopToken& stop) {
    const bool verify = in_sample(placements_++, 0);
    SearchResult answer = engine_->best_placement(tray, shape, model, stop);
    if (!verify || answer.stopped) return answer;
    const SearchResult expected = oracle_->best_placement(tray, shape, model, stop);
    if (expected.stopped) return answer;
    if (answer.best != expected.best) {
        fail(*engine_, *oracle_, "best placement", tray, shape, describe(shape, answer.best),
             describe(shape, expected.best));
    }
    ++verified_;
    return answer;
}

FreePositions VerifyingSearch::free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) {
    const bool verify = in_sample(free_queries_++, 1);
    FreePositions answer = engine_->free_positions(tray, shape, index, query);
    if (!verify) return answer;
    const FreePositions expected = oracle_->free_positions(tray, shape, index, query);
    if (!(answer.origin == expected.origin && answer.free == expected.free)) {
        std::ostringstream question;
        question << "free positions (orientation " << orientation_text(shape, index);
        if (query.without) question << ", without object " << *query.without;
        question << ", padding " << query.padding << ')';
        fail(*engine_, *oracle_, question.str(), tray, shape, describe(answer),
             describe(expected) + first_difference(answer, expected));
    }
    ++verified_;
    return answer;
}

std::unique_ptr<FreeTileReader> VerifyingSearch::free_tiles(const Tray& tray, std::shared_ptr<const BitGrid> solid,
                                                            const FreeQuery& query) {
    // All rows at once, by free_positions() above, where they are to be compared.
    if (in_sample(free_queries_, 1)) return PlacementSearch::free_tiles(tray, solid, query);
    ++free_queries_;
    return engine_->free_tiles(tray, std::move(solid), query);
}

}  // namespace spectralpack
