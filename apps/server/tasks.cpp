#include "tasks.hpp"

#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

constexpr std::size_t kMostWaiting = 1000;

}  // namespace

void Tasks::start(Command command, Processes::Ended ended) {
    if (waiting_.size() >= kMostWaiting) throw Refusal(kBusy, "too much is asked for at once: try again in a minute");
    command.memory = settings_.limits.task_memory;
    command.processor_seconds = settings_.limits.task_seconds;
    waiting_.emplace_back(std::move(command), std::move(ended));
    start_next();
}

Command Tasks::child(std::vector<std::string> arguments, const std::filesystem::path& folder) const {
    arguments.insert(arguments.begin(), {settings_.self.string(), "--child"});
    return {std::move(arguments), folder, {}, {}};
}

void Tasks::start_next() {
    while (running_ < settings_.limits.tasks && !waiting_.empty()) {
        auto [command, ended] = std::move(waiting_.front());
        waiting_.pop_front();
        ++running_;
        processes_.start(command, [this, ended = std::move(ended)](Ending ending) {
            --running_;
            ended(ending);
            start_next();
        });
    }
}

}  // namespace spectralpack::server
