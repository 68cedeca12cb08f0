#include "http/session.hpp"

#include <array>
#include <chrono>
#include <limits>
#include <optional>

#include <spectralpack/error.hpp>

#include "http/beast.hpp"
#include "http/event_stream.hpp"
#include "jobs/names.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

constexpr std::uint32_t kMostHeaderBytes = 16 << 10;
constexpr std::uint64_t kMostBodyBytes = 16 << 20;  // of what is held in memory: job files
constexpr std::uint64_t kLookAtDiskEvery = 64 << 20;
constexpr std::uint64_t kMostDrained = 64 << 20;
constexpr auto kLongestUpload = std::chrono::hours(1);
constexpr auto kLongestDrain = std::chrono::seconds(3);

std::string_view text_of(beast::string_view text) { return {text.data(), text.size()}; }

/// "/api/jobs?find=x%20y" in its parts. False where it is no such thing.
bool read_target(std::string_view target, Request& request) {
    if (!target.starts_with('/')) return false;
    const std::size_t mark = target.find('?');
    std::string_view path = target.substr(1, mark == std::string_view::npos ? mark : mark - 1);
    while (!path.empty()) {
        const std::size_t end = path.find('/');
        std::string part;
        if (!percent_decoded(path.substr(0, end), part) || part.empty()) return false;
        request.path.push_back(std::move(part));
        if (end == std::string_view::npos) break;
        path = path.substr(end + 1);
    }
    std::string_view query = mark == std::string_view::npos ? std::string_view{} : target.substr(mark + 1);
    while (!query.empty()) {
        const std::size_t end = query.find('&');
        const std::string_view pair = query.substr(0, end);
        query = end == std::string_view::npos ? std::string_view{} : query.substr(end + 1);
        const std::size_t equals = pair.find('=');
        std::string name, value;
        if (!percent_decoded(pair.substr(0, equals), name)) return false;
        if (equals != std::string_view::npos && !percent_decoded(pair.substr(equals + 1), value)) return false;
        request.query[name] = value;
    }
    return true;
}

/// "attachment" with the name in ASCII, and as it is (RFC 6266).
std::string disposition(const std::string& name) {
    std::string plain, encoded;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool simple = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                            c == '_' || c == '.';
        plain += simple || c == ' ' ? c : '_';
        constexpr std::string_view kDigits = "0123456789ABCDEF";
        encoded += simple ? std::string(1, c) : std::string{'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
    return "attachment; filename=\"" + plain + "\"; filename*=UTF-8''" + encoded;
}

class Session : public std::enable_shared_from_this<Session> {
  public:
    Session(boost::asio::ip::tcp::socket socket, Routes& routes, const Guard& guard, std::function<void()> done)
        : stream_(std::move(socket)), routes_(routes), guard_(guard), done_(std::move(done)) {}
    ~Session() {
        if (done_) done_();
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void read_header() {
        head_.emplace();
        head_->header_limit(kMostHeaderBytes);
        // Each way of reading the body has its own. None at all would refuse every body in Boost 1.74.
        head_->body_limit(std::numeric_limits<std::uint64_t>::max());
        stay_awhile();
        http::async_read_header(stream_, buffer_, *head_,
                                [self = shared_from_this()](const ErrorCode& error, std::size_t) {
                                    if (!error) return self->on_header();
                                    if (error == http::error::header_limit)
                                        self->refuse(431, "the request's head is too long");
                                });
    }

  private:
    void stay_awhile() { stream_.expires_after(std::chrono::seconds(routes_.settings().limits.idle_seconds)); }

    /// Answers what `work` throws.
    template <class Work>
    void guarded(const Work& work) {
        try {
            work();
        } catch (const Refusal& refusal) {
            refuse(refusal.status(), refusal.what());
        } catch (const Error& error) {
            refuse(error.kind() == ErrorKind::resource ? kNoRoom : kBroken, error.what());
        } catch (const std::exception& error) {
            refuse(kBroken, std::string("a mistake of ours: ") + error.what());
        }
    }

    void on_header() {
        guarded([&] {
            const auto& head = head_->get();
            keeps_alive_ = head.keep_alive();
            only_head_ = head.method() == http::verb::head;
            request_ = {};
            request_.method = only_head_ ? "GET" : std::string(text_of(head.method_string()));
            if (!read_target(text_of(head.target()), request_))
                throw Refusal(kBadRequest, "the address makes no sense");
            request_.if_none_match = std::string(text_of(head[http::field::if_none_match]));
            request_.last_event_id = std::string(text_of(head["Last-Event-ID"]));
            request_.takes_gzip = text_of(head[http::field::accept_encoding]).find("gzip") != std::string_view::npos;
            guard_.require(
                {text_of(head[http::field::host]), text_of(head[http::field::origin]), text_of(head["Sec-Fetch-Site"]),
                 text_of(head[http::field::authorization]), text_of(head[http::field::cookie])},
                routes_.is_open(request_));
            if (routes_.is_upload(request_)) return begin_upload();
            if (routes_.is_watching(request_)) return watch();
            read_body();
        });
    }

    bool waits_for_go() const { return beast::iequals(head_->get()[http::field::expect], "100-continue"); }

    /// Some send the body only when they are told that it is wanted.
    template <class Next>
    void say_go(Next next) {
        if (!waits_for_go()) return next();
        static constexpr std::string_view kGo = "HTTP/1.1 100 Continue\r\n\r\n";
        boost::asio::async_write(stream_, boost::asio::buffer(kGo),
                                 [self = shared_from_this(), next](const ErrorCode& error, std::size_t) {
                                     if (!error) next();
                                 });
    }

    void read_body() {
        if (head_->content_length() && *head_->content_length() > kMostBodyBytes) {
            throw Refusal(kTooLarge, "what was sent is larger than this address takes");
        }
        body_.emplace(std::move(*head_));
        body_->body_limit(kMostBodyBytes);
        say_go([self = shared_from_this()] {
            self->stay_awhile();
            http::async_read(self->stream_, self->buffer_, *self->body_, [self](const ErrorCode& error, std::size_t) {
                if (error == http::error::body_limit) {
                    self->refuse(kTooLarge, "what was sent is larger than this address takes");
                } else if (!error) {
                    self->on_body();
                }
            });
        });
    }

    void on_body() {
        guarded([&] {
            request_.body = std::move(body_->get().body());
            // A reply may come when the connection has long been waiting for a process.
            stream_.expires_never();
            routes_.answer(request_, guard_,
                           [self = shared_from_this()](Response response) { self->write(std::move(response)); });
        });
    }

    void watch() {
        if (!is_job_id(request_.path[2])) throw Refusal(kNotThere, "there is no such job");
        const Job& job = routes_.jobs().at(request_.path[2]);
        watch_job(std::move(stream_), routes_, job.id, request_.last_event_id, std::move(done_));
        done_ = nullptr;
    }

    void begin_upload() {
        const std::uint64_t announced = head_->content_length() ? *head_->content_length() : 0;
        upload_ = routes_.begin_upload(request_, announced);
        file_.emplace(std::move(*head_));
        file_->body_limit(upload_.most_bytes);
        ErrorCode error;
        file_->get().body().open(upload_.to.c_str(), beast::file_mode::write, error);
        if (error) throw Refusal(kNoRoom, "the file cannot be kept: " + error.message());
        upload_ends_ = std::chrono::steady_clock::now() + kLongestUpload;
        received_ = 0;
        say_go([self = shared_from_this()] { self->read_upload(); });
    }

    /// Piece by piece, so that who sends slowly but goes on sending is not let go, and who stops is.
    void read_upload() {
        if (file_->is_done()) return finish_upload();
        stay_awhile();
        http::async_read_some(stream_, buffer_, *file_,
                              [self = shared_from_this()](const ErrorCode& error, std::size_t bytes) {
                                  self->guarded([&] { self->on_piece(error, bytes); });
                              });
    }

    void on_piece(const ErrorCode& error, std::size_t bytes) {
        if (!error) {
            const std::uint64_t before = received_ / kLookAtDiskEvery;
            received_ += bytes;
            const bool full = received_ / kLookAtDiskEvery != before && !routes_.has_room();
            const bool late = std::chrono::steady_clock::now() > upload_ends_;
            if (!full && !late) return read_upload();
            drop_upload();
            throw full ? Refusal(kNoRoom, "the disk is nearly full")
                       : Refusal(408, "sending the file took over an hour");
        }
        drop_upload();
        if (error == http::error::body_limit) {
            throw Refusal(kTooLarge, upload_.name + " is larger than allowed");
        }
        if (error.category() == boost::system::system_category() || error == boost::system::errc::no_space_on_device) {
            if (error == boost::system::errc::no_space_on_device) throw Refusal(kNoRoom, "the disk is full");
        }
        // Otherwise the other end is gone.
    }

    void drop_upload() {
        file_.reset();
        std::error_code none;
        std::filesystem::remove(upload_.to, none);
    }

    void finish_upload() {
        file_->get().body().close();
        file_.reset();
        guarded([&] {
            try {
                write(routes_.end_upload(upload_));
            } catch (...) {
                drop_upload();
                throw;
            }
        });
    }

    /// What of the request was not read is not looked at, so that the connection cannot be used again.
    void refuse(int status, const std::string& sentence) {
        keeps_alive_ = false;
        write(error_response(status, sentence));
    }

    template <class Body>
    void prepare(http::response<Body>& message, const Response& response) const {
        message.version(11);
        message.result(static_cast<unsigned>(response.status));
        bool has_policy = false, has_cache = false;
        for (const auto& [name, value] : response.headers) {
            message.insert(name, value);
            has_policy = has_policy || name == "Content-Security-Policy";
            has_cache = has_cache || name == "Cache-Control";
        }
        for (const auto& [name, value] : kSafety) {
            if (!has_policy || std::string_view(name) != "Content-Security-Policy") message.set(name, value);
        }
        if (!has_cache) message.set(http::field::cache_control, "no-store");
        if (!response.type.empty()) message.set(http::field::content_type, response.type);
        if (!response.download.empty()) message.set(http::field::content_disposition, disposition(response.download));
        message.keep_alive(keeps_alive_);
    }

    template <class Body>
    void send(http::response<Body> message) {
        auto kept = std::make_shared<http::response<Body>>(std::move(message));
        auto serializer = std::make_shared<http::response_serializer<Body>>(*kept);
        serializer->limit(kPiece);
        if (only_head_) serializer->split(true);
        send_on(std::move(kept), std::move(serializer));
    }

    /// Piece by piece, as uploads are read.
    template <class Kept, class Serializer>
    void send_on(Kept kept, Serializer serializer) {
        stay_awhile();
        const auto wrote = [self = shared_from_this(), kept, serializer](const ErrorCode& error, std::size_t) {
            if (error && error != http::error::need_buffer) return;
            if (serializer->is_done() || (self->only_head_ && serializer->is_header_done())) return self->on_written();
            self->send_on(kept, serializer);
        };
        http::async_write_some(stream_, *serializer, wrote);
    }

    void write(Response response) {
        if (response.file.empty()) {
            http::response<http::string_body> message;
            prepare(message, response);
            message.body() = std::move(response.body);
            message.prepare_payload();
            if (response.status == 204 || response.status == 304) message.erase(http::field::content_length);
            return send(std::move(message));
        }
        http::file_body::value_type file;
        ErrorCode error;
        file.open(response.file.c_str(), beast::file_mode::scan, error);
        if (error) return refuse(kNotThere, "the file is no longer there");
        http::response<http::file_body> message;
        prepare(message, response);
        message.body() = std::move(file);
        message.prepare_payload();
        send(std::move(message));
    }

    void on_written() {
        if (keeps_alive_) return read_header();
        ErrorCode none;
        stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, none);
        drain_ends_ = std::chrono::steady_clock::now() + kLongestDrain;
        drained_ = 0;
        drain();
    }

    /// Who is still sending would not see the answer if the connection were closed under it.
    void drain() {
        stream_.expires_at(drain_ends_);
        stream_.async_read_some(boost::asio::buffer(scrap_),
                                [self = shared_from_this()](const ErrorCode& error, std::size_t bytes) {
                                    self->drained_ += bytes;
                                    if (!error && self->drained_ < kMostDrained) self->drain();
                                });
    }

    static constexpr std::size_t kPiece = 64 << 10;

    Stream stream_;
    beast::flat_buffer buffer_{kMostHeaderBytes + kPiece};
    std::optional<http::request_parser<http::empty_body>> head_;
    std::optional<http::request_parser<http::string_body>> body_;
    std::optional<http::request_parser<http::file_body>> file_;
    Routes& routes_;
    const Guard& guard_;
    std::function<void()> done_;
    Request request_;
    Upload upload_;
    std::array<char, 16 << 10> scrap_{};
    std::uint64_t received_ = 0, drained_ = 0;
    std::chrono::steady_clock::time_point upload_ends_, drain_ends_;
    bool keeps_alive_ = false, only_head_ = false;
};

}  // namespace

void serve(boost::asio::ip::tcp::socket socket, Routes& routes, const Guard& guard, std::function<void()> done) {
    std::make_shared<Session>(std::move(socket), routes, guard, std::move(done))->read_header();
}

}  // namespace spectralpack::server
