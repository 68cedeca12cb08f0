#include "interrupting.hpp"

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace py = pybind11;

namespace spectralpack::python {
namespace {

constexpr std::chrono::milliseconds kLook{20};

/// A thread that does the work, and tells when it is done.
class Worker {
  public:
    explicit Worker(const std::function<void()>& work)
        : thread_([this, &work] {
              try {
                  work();
              } catch (...) {
                  failure_ = std::current_exception();
              }
              const std::lock_guard lock(mutex_);
              done_ = true;
              changed_.notify_all();
          }) {}
    ~Worker() { thread_.join(); }

    bool done_within(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, time, [&] { return done_; });
    }
    std::exception_ptr failure() const { return failure_; }  ///< once it is done

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool done_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace

bool interruptible(const std::function<void()>& work, const std::function<void()>& stop, const Watch& watch) {
    int interrupts = 0;
    std::exception_ptr failure;
    {
        const py::gil_scoped_release release;
        Worker worker(work);
        while (!worker.done_within(kLook)) {
            if (watch) watch();
            const py::gil_scoped_acquire acquire;
            if (PyErr_CheckSignals() == 0) continue;
            PyErr_Clear();  // a KeyboardInterrupt, as a rule
            ++interrupts;
            stop();
        }
        failure = worker.failure();
    }
    if (interrupts > 1) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
        throw py::error_already_set();
    }
    if (failure) std::rethrow_exception(failure);
    return interrupts > 0;
}

void interruptible(const std::function<void(const StopToken&)>& work) {
    StopSource source;
    const bool interrupted =
        interruptible([&] { work(source.token()); }, [&] { source.request(StopReason::cancelled); }, {});
    if (!interrupted) return;
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
}

}  // namespace spectralpack::python
