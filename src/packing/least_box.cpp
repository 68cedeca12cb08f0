#include "packing/least_box.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace spectralpack {
namespace {

constexpr double kSides[] = {1, 0.84, 1.19, 0.71, 1.41};
constexpr double kAspects[] = {1, 1.4, 2};
constexpr int kFirstStep = 6;  // a part of the side

class BaseSearch {
  public:
    BaseSearch(const BaseSize& least, const BaseSize& most, const PackOnBase& pack)
        : least_(least), most_(most), pack_(pack) {}

    void run(int side) {
        for (const double size : kSides) {
            for (const double aspect : kAspects) {
                const double long_side = side * size * std::sqrt(aspect), short_side = long_side / aspect;
                attempt({static_cast<int>(std::lround(long_side)), static_cast<int>(std::lround(short_side))});
            }
        }
        for (int part = kFirstStep; best_ && !stopped_; part *= 2) {
            const int dx = std::max(1, base_.x / part), dy = std::max(1, base_.y / part);
            for (bool better = true; better && !stopped_;) {
                const BoxScore before = *best_;
                const BaseSize from = base_;
                for (const auto& [x, y] : {BaseSize{-dx, 0}, BaseSize{0, -dy}, BaseSize{dx, 0}, BaseSize{0, dy}}) {
                    attempt({from.x + x, from.y + y});
                }
                better = *best_ < before;
            }
            if (dx == 1 && dy == 1) return;
        }
    }

  private:
    void attempt(BaseSize base) {
        base = {std::clamp(base.x, least_.x, most_.x), std::clamp(base.y, least_.y, most_.y)};
        if (stopped_ || !tried_.insert(base).second) return;
        const std::optional<BoxScore> score = pack_(base);
        stopped_ = !score;
        if (score && (!best_ || *score < *best_)) {
            best_ = score;
            base_ = base;
        }
    }

    BaseSize least_, most_;
    const PackOnBase& pack_;
    std::set<BaseSize> tried_;
    std::optional<BoxScore> best_;
    BaseSize base_;
    bool stopped_ = false;
};

}  // namespace

void search_bases(int side, const BaseSize& least, const BaseSize& most, const PackOnBase& pack) {
    BaseSearch(least, most, pack).run(side);
}

}  // namespace spectralpack
