#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>

#include <spectralpack/names.hpp>
#include <spectralpack/pack.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "interrupting.hpp"
#include "jobs.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Ends parts of a run when their time is over, as the command line does, but that no files are written.
class Clocks {
  public:
    Clocks(const PackOptions& options, Clock::time_point start)
        : start_(start), limit_(options.time_limit), improve_(options.improve) {
        if (options.interlock != Interlock::off) placing_ = 0.7;
    }

    StopToken stop() const { return stop_.token(); }
    void hand_to(Job& job) const {
        job.enough_orders = half_.token();
        job.enough_placed = placed_.token();
        job.enough_improved = improved_.token();
    }

    void end_all(StopReason reason) {
        for (StopSource* source : {&half_, &improved_, &placed_, &stop_}) {
            source->request(reason);
        }
    }
    /// Called once improving begins, by the thread that works.
    void begin_improving() {
        if (improving_since_ < 0) improving_since_ = since(start_);
    }
    void look() {
        const double now = since(start_);
        if (improve_ && *improve_ > 0 && improving_since_ >= 0 && now >= improving_since_ + *improve_) {
            improved_.request(StopReason::time_limit);
        }
        if (!limit_) return;
        if (now >= 0.5 * placing_ * *limit_) half_.request(StopReason::time_limit);
        if (now >= placing_ * *limit_) {
            improved_.request(StopReason::time_limit);
            placed_.request(StopReason::time_limit);
        }
        if (now >= *limit_) end_all(StopReason::time_limit);
    }

  private:
    Clock::time_point start_;
    std::optional<double> limit_;
    std::optional<int> improve_;
    double placing_ = 1;
    std::atomic<double> improving_since_{-1};
    StopSource half_, improved_, placed_, stop_;
};

py::dict dict_of(const Progress& progress, double seconds) {
    py::dict result;
    result["phase"] = std::string(to_string(progress.phase));
    result["done"] = progress.done;
    result["total"] = progress.total;
    result["work"] = progress.work;
    result["density"] = progress.density;
    result["seconds"] = seconds;
    if (progress.improved) {
        result["what"] = std::string(to_string(progress.improved->what));
        result["before"] = progress.improved->before;
        result["now"] = progress.improved->now;
    }
    return result;
}

py::dict dict_of(const Event& event) {
    py::dict result;
    result["kind"] = std::string(to_string(event.kind));
    result["tray"] = event.tray;
    if (event.part >= 0) {
        result["part"] = event.part;
        result["copy"] = event.copy;
        result["orientation"] = event.orientation;
        result["transform"] = matrix_of(event.transform);
    }
    return result;
}

/// Tells Python callables, at most so often, and ends the run where one raises.
class CallingListener : public Listener {
  public:
    CallingListener(const py::object& progress, const py::object& on_event, Clocks& clocks, Clock::time_point start)
        : progress_(progress), on_event_(on_event), clocks_(clocks), start_(start) {}

    void on_progress(const Progress& progress) override {
        if (progress.phase == Phase::improve) clocks_.begin_improving();
        if (progress_.is_none()) return;
        const double now = since(start_);
        if (progress.phase == told_phase_ && now < told_ + kPause) return;
        told_phase_ = progress.phase;
        told_ = now;
        call([&] { progress_(dict_of(progress, now)); });
    }
    void on_event(const Event& event) override {
        if (!on_event_.is_none()) call([&] { on_event_(dict_of(event)); });
    }
    void on_warning(const std::string& text) override { remarks_.push_back(text); }

    const std::vector<std::string>& remarks() const { return remarks_; }
    /// What a callable raised, with the interpreter's lock.
    void rethrow() {
        if (!raised_) return;
        py::error_already_set error = std::move(*raised_);
        raised_.reset();
        throw error;
    }

  private:
    static constexpr double kPause = 0.1;  // seconds

    template <class Call>
    void call(const Call& call) {
        const py::gil_scoped_acquire acquire;
        if (raised_) return;
        try {
            call();
        } catch (py::error_already_set& error) {
            raised_.emplace(std::move(error));
            clocks_.end_all(StopReason::cancelled);
        }
    }

    const py::object &progress_, &on_event_;
    Clocks& clocks_;
    Clock::time_point start_;
    std::optional<Phase> told_phase_;
    double told_ = 0;
    std::vector<std::string> remarks_;
    std::optional<py::error_already_set> raised_;
};

void remark(const std::string& text) {
    const py::object category = py::module_::import("spectralpack._core").attr("Remark");
    if (PyErr_WarnEx(category.ptr(), text.c_str(), 2) != 0) throw py::error_already_set();
}

std::shared_ptr<KeptPacking> pack_it(const KeptJob& kept, const py::object& progress, const py::object& on_event,
                                     const std::optional<std::filesystem::path>& journal) {
    const Clock::time_point start = Clock::now();
    Job job = kept.job;
    if (job.parts.empty()) throw UsageError("the job has no parts: add() some");
    Clocks clocks(job.options, start);
    clocks.hand_to(job);
    CallingListener listener(progress, on_event, clocks, start);
    JournalOptions journal_options;
    if (journal) journal_options.file = *journal;
    PackResult result;
    interruptible(
        [&] {
            result = pack(job, {&listener, clocks.stop()}, journal_options);
        },
        [&] { clocks.end_all(StopReason::cancelled); }, [&] { clocks.look(); });
    listener.rethrow();
    auto packing = std::make_shared<KeptPacking>();
    packing->scene = {std::move(result.packing), std::move(result.meshes)};
    packing->stopped = result.stopped;
    packing->unusable = std::move(result.unusable);
    for (const std::string& text : listener.remarks()) {
        remark(text);
    }
    for (const InputError& error : packing->unusable) {
        remark(error.what());
    }
    if (!result.failure) return packing;
    const py::object exception = exception_of(*result.failure);
    exception.attr("packing") = packing;
    raise(exception);
}

py::dict estimate_it(const KeptJob& kept) {
    Estimate estimated;
    interruptible([&](const StopToken& stop) { estimated = estimate(kept.job, {nullptr, stop}); });
    py::dict result;
    result["size"] = tuple_of(estimated.container);
    result["grid"] = py::make_tuple(estimated.grid.x, estimated.grid.y, estimated.grid.z);
    result["voxel"] = estimated.voxel;
    result["orientations"] = estimated.orientations;
    result["parts"] = estimated.parts;
    result["copies"] = estimated.copies;
    result["left_over"] = estimated.left_over;
    result["memory"] = estimated.memory;
    result["memory_limit"] = estimated.memory_limit;
    result["box_ratio"] = estimated.box_ratio;
    result["volume_ratio"] = estimated.volume_ratio;
    result["too_large"] = estimated.too_large;
    return result;
}

}  // namespace

void bind_runs(py::module_& module) {
    module.def("pack", &pack_it, py::arg("job"), py::arg("progress") = py::none(), py::arg("on_event") = py::none(),
               py::arg("journal") = py::none());
    module.def("estimate", &estimate_it, py::arg("job"));
}

}  // namespace spectralpack::python
