#include "http/event_stream.hpp"

#include <charconv>
#include <chrono>
#include <fstream>

namespace spectralpack::server {
namespace {

constexpr auto kTellEvery = std::chrono::milliseconds(100);
constexpr auto kSignOfLife = std::chrono::seconds(15);
constexpr std::size_t kMostTold = 256 << 10;

class EventStream : public std::enable_shared_from_this<EventStream> {
  public:
    EventStream(Stream stream, Routes& routes, std::string job, const std::string& last, std::function<void()> done)
        : stream_(std::move(stream)),
          timer_(stream_.get_executor()),
          routes_(routes),
          id_(std::move(job)),
          done_(std::move(done)) {
        read_place(last);
    }
    ~EventStream() { done_(); }
    EventStream(const EventStream&) = delete;
    EventStream& operator=(const EventStream&) = delete;

    void begin() {
        text_ =
            "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n";
        for (const auto& [name, value] : kSafety) {
            text_ += std::string(name) + ": " + value + "\r\n";
        }
        text_ += "\r\nretry: 1000\n\n";
        write();
    }

  private:
    /// Ids are RUN-BYTES: so much of that run's events has been told.
    void read_place(const std::string& last) {
        const std::size_t dash = last.find('-');
        if (dash == std::string::npos) return;
        std::from_chars(last.data(), last.data() + dash, run_);
        std::from_chars(last.data() + dash + 1, last.data() + last.size(), told_);
    }

    void look() {
        text_.clear();
        if (!routes_.jobs().contains(id_)) return;  // which ends it
        const Job& job = routes_.jobs().at(id_);
        if (run_ != job.run) {
            if (run_ != 0) text_ += "event: anew\ndata: {}\n\n";
            run_ = job.run;
            told_ = 0;
        }
        if (state_.empty()) tell_state(job);
        tell_lines(job);
        tell_state(job);
        const auto now = std::chrono::steady_clock::now();
        if (text_.empty() && now - last_sign_ > kSignOfLife) text_ = ": still here\n\n";
        if (!text_.empty()) {
            last_sign_ = now;
            return write();
        }
        timer_.expires_after(kTellEvery);
        timer_.async_wait([self = shared_from_this()](const ErrorCode& error) {
            if (!error) self->look();
        });
    }

    void tell_lines(const Job& job) {
        std::ifstream file(job.folder.events(), std::ios::binary);
        if (!file) return;
        file.seekg(static_cast<std::streamoff>(told_));
        std::string lines(kMostTold, '\0');
        file.read(lines.data(), static_cast<std::streamsize>(lines.size()));
        lines.resize(static_cast<std::size_t>(file.gcount()));
        lines.resize(lines.rfind('\n') + 1);  // whole ones; npos + 1 is 0
        for (std::size_t begin = 0; begin < lines.size();) {
            const std::size_t end = lines.find('\n', begin);
            told_ += end + 1 - begin;
            if (lines[begin] == '{') {
                text_ += "event: line\nid: " + std::to_string(run_) + "-" + std::to_string(told_) + "\ndata: ";
                text_.append(lines, begin, end - begin);
                text_ += "\n\n";
            }
            begin = end + 1;
        }
    }

    /// Not of every step of its progress, which the lines tell.
    void tell_state(const Job& job) {
        if (change_ == job.change && place_ == routes_.runs().queue_place(job)) return;
        change_ = job.change;
        place_ = routes_.runs().queue_place(job);
        Json state = job_json(job, place_);
        state["progress"] = state["bytes"] = state["changed"] = nullptr;
        std::string known = state.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (known == state_) return;
        state_ = std::move(known);
        text_ += "event: state\ndata: " + job_json(job, place_).dump(-1, ' ', false, Json::error_handler_t::replace) +
                 "\n\n";
    }

    void write() {
        stream_.expires_after(std::chrono::seconds(routes_.settings().limits.idle_seconds));
        boost::asio::async_write(stream_, boost::asio::buffer(text_),
                                 [self = shared_from_this()](const ErrorCode& error, std::size_t) {
                                     if (error) return;
                                     self->stream_.expires_never();
                                     self->look();
                                 });
    }

    Stream stream_;
    boost::asio::steady_timer timer_;
    Routes& routes_;
    std::string id_, text_, state_;
    std::function<void()> done_;
    int run_ = 0, change_ = -1, place_ = 0;
    std::uint64_t told_ = 0;
    std::chrono::steady_clock::time_point last_sign_ = std::chrono::steady_clock::now();
};

}  // namespace

void watch_job(Stream stream, Routes& routes, const std::string& job, const std::string& last,
               std::function<void()> done) {
    std::make_shared<EventStream>(std::move(stream), routes, job, last, std::move(done))->begin();
}

}  // namespace spectralpack::server
