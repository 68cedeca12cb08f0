#pragma once
/// Packs a job into trays, as often as strategies ask for it.

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "core/parallel.hpp"
#include "packing/job/packing_job.hpp"
#include "spectralpack/events.hpp"

namespace spectralpack {

using TellProgress = std::function<void(const Progress&)>;

/// One packing of the job.
struct PackingPass {
    const std::vector<Copy>& copies;  ///< the job's, in the order to try
    const FillOptions& fill;
    StopToken stop;
    TellProgress tell;                 ///< Phase::search
    TrayObserver* observer = nullptr;  ///< null: nobody is told
};

class TraysPacker {
  public:
    /// `job` and `engine`, which answers all that is asked, outlive it, and so do `decisions` (null: none).
    TraysPacker(const PackingJob& job, PlacementSearch& engine, const Workers& workers, Decisions* decisions = nullptr);

    const PackingJob& job() const { return job_; }
    const Workers& workers() const { return workers_; }

    /// `result` is filled as it goes, so that it holds what was done when an exception leaves this function.
    void pack(const PackingPass& pass, TraysResult& result);

    /// For strategies that fill trays by themselves.
    struct FillerUse {
        const FillOptions& fill;
        StopToken stop;
        TrayObserver* observer = nullptr;  ///< null: nobody is told
        bool decides = false;              ///< what is decided is kept, and recalled
    };
    void with_filler(const FillerUse& use, const std::function<void(TrayFiller&)>& work);

    Decisions* decisions() const { return decisions_; }  ///< null: none

    /// The voxels of a part that may be asked about any number of times.
    std::shared_ptr<const Shape> lasting_shape(int part);

    /// From now on `told` gets the trays that are finished each time that another is begun, in passes with an observer.
    void tell_of_trays(std::function<void(const TraysResult&)> told) { trays_told_ = std::move(told); }

    /// From now on the voxels of all parts are held from one packing to the next.
    void keep_shapes() { keeps_shapes_ = true; }

    /// Spent in all packings, for the record.
    struct Seconds {
        double voxelize = 0, refine = 0;
        double untangle = 0;  ///< also of packings that were given up
    };
    const Seconds& seconds() const { return seconds_; }

  private:
    /// The voxels made last of those that several parts have: a set may name one mesh in thousands of rows, one after
    /// the other. Used by several threads.
    class LastShared {
      public:
        std::shared_ptr<const Shape> find(std::uint64_t id);  ///< null where it is another
        void put(std::uint64_t id, std::shared_ptr<const Shape> shape);

      private:
        std::mutex mutex_;
        std::uint64_t id_ = 0;  // of none
        std::shared_ptr<const Shape> shape_;
    };

    void pack(const PackingPass& pass, TrayFiller& filler, TraysResult& result);
    std::shared_ptr<const Shape> shape_of(int part, int count, const TraySetup& tray, const Workers& workers);

    const PackingJob& job_;
    PlacementSearch& engine_;
    Workers workers_;
    std::vector<std::uint64_t> shape_ids_;            // by part
    std::vector<std::shared_ptr<const Shape>> kept_;  // by part
    std::vector<bool> shared_;                        // by part: others have its voxels, too
    LastShared last_shared_;
    bool keeps_shapes_ = false;
    Decisions* decisions_;
    std::function<void(const TraysResult&)> trays_told_;
    Seconds seconds_;
};

}  // namespace spectralpack
