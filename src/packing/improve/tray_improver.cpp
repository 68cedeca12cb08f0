#include "packing/improve/tray_improver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "packing/improve/order_moves.hpp"
#include "packing/order/order.hpp"
#include "packing/tray/compaction.hpp"

namespace spectralpack {
namespace {

constexpr double kNoise = 6;            // mm: copies whose tops differ by less are as urgent
constexpr std::int64_t kPatience = 40;  // searches without gain that end a start, times the copies
constexpr double kMissing = 1e5;        // mm, the same: copies without a place come before all others
constexpr double kRounding = 1e-9;      // of worths
constexpr std::int64_t kCalm = 3;       // steps without a better layout, after which the last is compacted
constexpr int kWorthCompacting = 1;     // layers above the best so far that compaction may make good

}  // namespace

TrayImprover::TrayImprover(StartedTray& started, const RefineOptions& refining, PrefixPacking::ShapeOf shape_of,
                           TrayImproverOptions options, const Workers& workers, const ImproverStops& stops)
    : started_(started),
      refining_(refining),
      workers_(workers),
      options_(std::move(options)),
      stop_(stops.stop),
      judge_(options_.copies, options_.measures),
      packing_(started, std::move(shape_of), stops.enough) {
    begin_start(0);
}

void TrayImprover::begin_start(int number) {
    start_ = number;
    fresh_ = true;
    random_ = RandomStream(numbered_seed(options_.seed, number));
    order_ = number == 0 ? options_.copies : perturbed(options_.copies, options_.ranks, random_);
}

std::vector<Copy> TrayImprover::next_order() {
    const OrderMoves moves{[&](std::size_t place) {
                               const PackedStep& step = layout_[place];
                               if (step.placed) return judge_.top(*step.placed);
                               return kMissing + kNoise * std::log(judge_.worth(step.copy.part) + kRounding);
                           },
                           kNoise,
                           [&](const Copy& a, const Copy& b) {
                               const auto rank = [&](const Copy& copy) {
                                   return options_.ranks[static_cast<std::size_t>(copy.part)];
                               };
                               return rank(a) == rank(b) && options_.may_pass(a, b);
                           }};
    return moved_order(order_, moves, random_);
}

std::optional<ImprovedLayout> TrayImprover::step() {
    if (!fresh_ && packing_.searches() - last_gain_ > kPatience * std::ssize(options_.copies)) begin_start(start_ + 1);
    const std::vector<Copy> order = fresh_ ? order_ : next_order();
    const auto is_hopeless = [&](const std::vector<PackedStep>& steps) {
        return !fresh_ && judge_.exceeds(steps, value_);
    };
    const PrefixPacking::Outcome outcome = packing_.pack(order, layout_, is_hopeless);
    if (outcome == PrefixPacking::Outcome::stopped) return std::nullopt;
    ++steps_;
    if (outcome == PrefixPacking::Outcome::packed) accept(order);
    const bool calm = steps_ - promised_at_ >= kCalm;
    return calm ? compare() : std::nullopt;
}

void TrayImprover::accept(const std::vector<Copy>& order) {
    const LayoutValue value = judge_.value(packing_.steps());
    if (!fresh_ && value > value_) return;
    if (fresh_ || value < value_) last_gain_ = packing_.searches();
    fresh_ = false;
    order_ = order;
    layout_ = packing_.steps();
    value_ = value;
    const auto promises = [&](const ImprovedLayout& than) {
        return value.missing < than.value.missing ||
               (value.missing == than.value.missing && value.top <= than.value.top + kWorthCompacting);
    };
    if ((best_ && !promises(*best_)) || (promising_ && !(value < promising_->value))) return;
    promising_ = ImprovedLayout{placed_of(layout_), value, 0};
    promised_at_ = steps_;
}

std::optional<ImprovedLayout> TrayImprover::compare() {
    if (!promising_) return std::nullopt;
    ImprovedLayout layout = *std::exchange(promising_, std::nullopt);
    if (options_.compact) {
        std::optional<Caps> caps;  // what it holds in the tray stays
        if (started_.caps()) caps = *started_.caps();
        compact({refining_, started_.standing()}, started_.surfaces(), caps ? &*caps : nullptr, layout.placed, workers_,
                stop_);
    }
    layout.size = options_.size_of(layout.placed);
    const auto before = [](const ImprovedLayout& a, const ImprovedLayout& b) {
        return a.value.missing != b.value.missing ? a.value.missing < b.value.missing : a.size < b.size;
    };
    if (best_ && !before(layout, *best_)) return std::nullopt;
    best_ = layout;
    return layout;
}

}  // namespace spectralpack
