#include "packing/tray/tray_observer.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "disassembly/scenes.hpp"
#include "packing/job/least_box.hpp"
#include "packing/job/order_search.hpp"
#include "support/sanitized.hpp"

namespace spectralpack {
namespace {

/// Orientation, position and offset. Which object it is in the tray is nobody's business.
using Place = std::tuple<int, int, int, int, double, double, double>;

/// What was told comes to.
class Told final : public TrayObserver {
  public:
    void tray_begun(int number) override {
        anew_ += trays_.contains(number) && !trays_[number].empty();
        trays_[number].clear();
        out_.clear();
        number_ = number;
        open_ = true;
    }
    void copy_placed(const PlacedCopy& placed) override { EXPECT_TRUE(add(placed) && !out_.contains(placed.copy)); }
    void copy_moved(const PlacedCopy& placed) override {
        const auto at = tray().find(placed.copy);
        ASSERT_NE(at, tray().end()) << "does not stand";
        at->second = place_of(placed);
    }
    void copy_taken_out(const PlacedCopy& placed) override {
        const auto at = tray().find(placed.copy);
        ASSERT_NE(at, tray().end()) << "does not stand";
        EXPECT_EQ(at->second, place_of(placed));
        tray().erase(at);
        out_.insert(placed.copy);
    }
    void copy_put_back(const PlacedCopy& placed) override {
        EXPECT_EQ(out_.erase(placed.copy), 1u) << "was not taken out";
        EXPECT_TRUE(add(placed));
        ++put_back_;
    }
    void tray_finished() override {
        EXPECT_TRUE(open_);
        left_out_ += out_.empty() ? 0 : 1;
        open_ = false;
    }

    void expect_holds(const TraysResult& result) const {
        EXPECT_FALSE(open_);
        EXPECT_GE(trays_.size(), result.trays.size());
        for (const auto& [number, copies] : trays_) {
            std::map<Copy, Place> expected;
            if (number < static_cast<int>(result.trays.size())) {
                for (const PlacedCopy& placed : result.trays[static_cast<std::size_t>(number)].placed) {
                    expected.emplace(placed.copy, place_of(placed));
                }
            }
            EXPECT_EQ(copies, expected) << "tray " << number;
        }
    }

    /// Trays begun anew though they held something, copies put back, and trays that lack some in the end.
    int anew() const { return anew_; }
    int put_back() const { return put_back_; }
    int left_out() const { return left_out_; }

  private:
    static Place place_of(const PlacedCopy& placed) {
        return {placed.orientation, placed.position.x, placed.position.y, placed.position.z,
                placed.offset.x,    placed.offset.y,   placed.offset.z};
    }
    std::map<Copy, Place>& tray() { return trays_[number_]; }
    bool add(const PlacedCopy& placed) { return open_ && tray().emplace(placed.copy, place_of(placed)).second; }

    std::map<int, std::map<Copy, Place>> trays_;
    std::set<Copy> out_;  // of the tray that is open
    int number_ = -1;
    bool open_ = false;
    int anew_ = 0, put_back_ = 0, left_out_ = 0;
};

const auto kTurns = std::make_shared<const std::vector<Mat3>>(
    std::vector<Mat3>{Mat3{}, Mat3{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}});

/// A chest with a hole in its lid that is smaller than some parts that have room in it, and a few others.
PackingJob random_job(RandomStream& random) {
    const Mesh chest =
        test::merged(test::chest_mesh(14, 1, true), test::placed(test::frame_mesh(14, 5, 1), {0, 0, 13}));
    const Mesh meshes[] = {chest, test::cube_mesh(6), test::frame_mesh(16, 2, 2), test::box_mesh({0, 0, 0}, {10, 6, 4}),
                           test::cube_mesh(3)};
    const auto one_in = [&](std::uint64_t many) { return random.below(many) == 0; };
    PackingJob job;
    for (const Mesh& mesh : meshes) {
        const int count = 1 + static_cast<int>(random.below(4));
        job.parts.push_back({std::make_shared<const Mesh>(mesh), 1, 0, kTurns, signed_volume(mesh),
                             bounding_box(mesh).volume(), count});
        for (int copy = 0; copy < count; ++copy) {
            job.copies.push_back({static_cast<int>(job.parts.size()) - 1, copy});
        }
    }
    job.ranks.assign(job.parts.size(), 0);
    FillOptions& fill = job.fill;
    fill.container.size = {20 + static_cast<double>(random.below(6)), 20, 20};
    fill.tray.voxel_size = 1;
    fill.tray.size = fill.container.size;
    fill.refine = one_in(2);
    fill.interlock = one_in(5) ? Interlock::off : one_in(6) ? Interlock::place : Interlock::post;
    fill.links = Links::allow;
    fill.take_out = one_in(2) ? TakeOut::lightest : TakeOut::thinnest;
    fill.left = fill.to_put_back = [](int, int) {};
    if (one_in(3)) {
        fill.tray.ceiling = Ceiling::open;
        fill.tray.reference_layers = 20;
        fill.container.size.z = Box::kInfinity;
        fill.model = {1e8, HeightAt::top};
    } else if (one_in(3)) {
        job.limit.trays = 0;
    } else {
        job.in_shares = one_in(2);
    }
    job.room = fill.tray.size;
    job.held = 10;
    job.choose_heights = fill.tray.ceiling == Ceiling::closed && !job.in_shares && one_in(2);
    return job;
}

TEST(TrayObserver, WhatItIsToldOfAddsUpToThePacking) {
    int renumbered = 0, packed_anew = 0, put_back = 0, left_out = 0;
    for (std::uint64_t seed = 0; seed < test::trials<std::uint64_t>(60); ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const PackingJob job = random_job(random);
        const auto engine = make_cpu_search({}, Workers(1));
        TraysPacker packer(job, *engine, Workers(1));
        StopSource stop;
        int calls = 0;
        const int stop_at = random.below(4) == 0 ? 1 + static_cast<int>(random.below(40)) : -1;
        const TellProgress tell = [&](const Progress&) {
            if (++calls == stop_at) stop.request(StopReason::cancelled);
        };
        Told told;
        PackedJob packed;
        const bool is_open = job.fill.tray.ceiling == Ceiling::open;
        if (is_open && random.below(4) == 0) {
            pack_in_least_box(packer, {30, 30}, stop.token(), tell, &told, packed);
        } else if (!job.in_shares && random.below(3) == 0) {
            const BestOrderOptions orders{
                3, 2, seed, stop.token(), {}, [](int) { return make_cpu_search({}, Workers(1)); }};
            pack_in_best_order(packer, orders, tell, &told, packed);
        } else {
            packer.pack({job.copies, job.fill, stop.token(), tell, &told}, packed.trays);
        }
        told.expect_holds(packed.trays);
        if (job.in_shares) renumbered += told.anew();
        if (job.choose_heights) packed_anew += told.anew();
        put_back += told.put_back();
        left_out += told.left_out();
    }
    // Of the scenes each case is in some; of a few of them it may be in none.
    if (test::kSanitized) return;
    EXPECT_GT(renumbered, 0);
    EXPECT_GT(packed_anew, 0);
    EXPECT_GT(put_back, 0);
    EXPECT_GT(left_out, 0);
}

}  // namespace
}  // namespace spectralpack
