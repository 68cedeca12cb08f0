#pragma once
/// What happens in trays, as the public events that a listener gets.

#include <vector>

#include "api/load.hpp"
#include "packing/job/packing_job.hpp"
#include "packing/tray/tray_observer.hpp"
#include "spectralpack/events.hpp"

namespace spectralpack {

class TrayEvents final : public TrayObserver {
  public:
    /// Both outlive it.
    TrayEvents(const std::vector<JobPart>& parts, const LoadedJob& loaded, Listener& listener)
        : parts_(parts), loaded_(loaded), listener_(listener) {}

    /// Copies of its own that stand already (Job::keep) are told of as placed.
    void tray_begun(int number) override {
        tray_ = number;
        tell(EventKind::tray_begun);
        for (const auto& [tray, copy] : loaded_.fixed) {
            const std::set<int>& standing = loaded_.standing[static_cast<std::size_t>(copy.part)];
            if (tray != tray_ || !standing.contains(copy.copy)) continue;
            listener_.on_event({EventKind::copy_placed, tray_, copy.part, copy.copy, copy.orientation, copy.transform});
        }
    }
    void copy_placed(const PlacedCopy& placed) override { tell(EventKind::copy_placed, placed); }
    void copy_moved(const PlacedCopy& placed) override { tell(EventKind::copy_moved, placed); }
    void copy_taken_out(const PlacedCopy& placed) override { tell(EventKind::copy_taken_out, placed); }
    void copy_put_back(const PlacedCopy& placed) override { tell(EventKind::copy_put_back, placed); }
    void tray_finished() override { tell(EventKind::tray_finished); }

  private:
    void tell(EventKind kind) const { listener_.on_event({kind, tray_, -1, -1, 0, {}}); }
    void tell(EventKind kind, const PlacedCopy& placed) const {
        const auto& [part, number] = placed.copy;
        listener_.on_event({kind, tray_, part, number, placed.orientation,
                            parts_[static_cast<std::size_t>(part)].transform_of(placed)});
    }

    const std::vector<JobPart>& parts_;
    const LoadedJob& loaded_;
    Listener& listener_;
    int tray_ = 0;
};

}  // namespace spectralpack
