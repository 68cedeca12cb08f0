#pragma once
/// Voxelised parts, made shortly before they are needed, by threads that would have nothing to do, and dropped after
/// their last copy, so that thousands of distinct parts do not have to be held at once. What a tray leaves over is kept
/// for the next one as far as the memory goes.

#include <functional>
#include <memory>
#include <vector>

#include "core/ahead.hpp"
#include "core/parallel.hpp"
#include "packing/order/order.hpp"
#include "search/shape.hpp"

namespace spectralpack {

class ShapeStore {
  public:
    /// Makes the shape of a part with these threads; called from several threads at once for different parts.
    using Make = std::function<std::shared_ptr<const Shape>(int part, const Workers& workers)>;

    /// Parts held at most of those not asked for so far, with the one that is: enough to keep the threads busy, few
    /// enough to hold.
    static constexpr int kAhead = 8;
    /// Where ways out are looked for as well, which takes longer than making voxels.
    static constexpr int kAheadOfWays = 4;
    /// So many of parts with so many orientations: fewer of those with many, whose making is work enough for all
    /// threads.
    static int ahead(std::size_t orientations);

    /// `keep`: bytes of shapes that may be held from one tray to the next. `ahead`: as kAhead.
    ShapeStore(Make make, const Workers& workers, std::int64_t keep = 0, int ahead = kAhead);

    /// `copies`: the order in which one tray will ask for shapes; fixes what is made ahead and when a shape is dropped.
    /// `ahead`: fewer than the store's.
    void start_tray(const std::vector<Copy>& copies, int ahead = kAhead);

    /// From now on at() throws Stopped where a shape would have to be made once `stop` is requested.
    void stop_with(const StopToken& stop);

    /// The shape of copies[i].part. Calls come with i ascending, about; the next distinct parts are begun. Throws what
    /// `make` throws.
    const Shape& at(std::size_t i);

    /// copies[i] is done with, `placed` or left over; the shape goes with the part's last copy.
    void release(std::size_t i, bool placed);

    double seconds() const { return seconds_; }  ///< spent on shapes by those who asked for them, for the record

  private:
    using Making = Ahead<std::shared_ptr<const Shape>>;

    void begin_next(std::size_t now);
    void drop(std::size_t part);

    std::vector<Copy> copies_;
    Make make_;
    Workers workers_, alone_{1};
    double seconds_ = 0;
    std::int64_t keep_;                                 // bytes that may still be held for later trays
    std::size_t most_ahead_, ahead_;                    // at all; in this tray
    std::size_t next_ = 0;                              // of copies_: those before have been begun or made
    std::size_t begun_ = 0;                             // parts, those not asked for so far
    std::vector<std::shared_ptr<const Shape>> shapes_;  // by part, as are the next four
    std::vector<std::unique_ptr<Making>> making_;       // of parts that are begun
    std::vector<std::int64_t> kept_;                    // bytes taken from keep_
    std::vector<int> remaining_;                        // copies to come in this tray
    std::vector<bool> left_over_;                       // some copy found no place in this tray
};

}  // namespace spectralpack
