// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees Boost. Everything is asynchronous with a deadline: a synchronous read of
// Beast's waits for as long as it takes, whatever the socket's own time limits say.
#include <utility>  // Before Boost 1.74, whose awaitable.hpp needs it in C++20.

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_static_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>

#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::haply {

namespace {
namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using beast::error_code;
using Clock = std::chrono::steady_clock;  // CLOCK_MONOTONIC, as monotonicNs().

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kLookNs = 100 * kMs;  // At the stop token.
constexpr std::int64_t kGoodbyeNs = 50 * kMs;
/// The service's own messages have two kilobytes for each device.
constexpr std::size_t kMostBytes = 65536;

Clock::time_point timeOf(std::int64_t ns) {
  return Clock::time_point(std::chrono::nanoseconds(ns));
}

/// What is under way at one time, and whether it has ended. Handlers refer to it and to nothing
/// that may be gone before them.
struct Operation {
  bool ended = true;
  error_code error;
  auto handler() {
    ended = false;
    return [this](const error_code& why, auto&&...) {
      ended = true;
      error = why;
    };
  }
};

/// Programs that this one starts must not inherit a session: it would live on with them, and with
/// it the last force. Asio opens its sockets without that, and a flag that is set later comes too
/// late where another thread starts a program.
error_code openAlone(tcp::socket& socket, const tcp& protocol) {
  const int descriptor =
      ::socket(protocol.family(), protocol.type() | SOCK_CLOEXEC, protocol.protocol());
  error_code error;
  if (descriptor < 0) {
    error.assign(errno, boost::system::system_category());
    return error;
  }
  socket.assign(protocol, descriptor, error);
  if (error) ::close(descriptor);
  return error;
}

/// To whoever else may hold the connection, too: to close a descriptor ends it for its last holder.
void end(tcp::socket& socket) {
  error_code ignored;
  socket.shutdown(tcp::socket::shutdown_both, ignored);
  socket.close(ignored);
}

/// @return false: it is still under way
bool run(asio::io_context& io, const Operation& operation, std::int64_t until_ns,
         const std::stop_token& stop = {}) {
  io.restart();
  while (!operation.ended && io.poll_one() != 0) {
  }
  while (!operation.ended && !stop.stop_requested()) {
    const std::int64_t now_ns = monotonicNs();
    if (now_ns >= until_ns) break;
    io.run_one_until(timeOf(std::min(until_ns, now_ns + kLookNs)));
  }
  return operation.ended;
}

class BeastPort : public Port {
 public:
  ~BeastPort() override {
    if (open_ && sending_.ended) {
      closing_.ended = true;
      stream_.async_close(beast::websocket::close_code::going_away, closing_.handler());
      run(io_, closing_, monotonicNs() + kGoodbyeNs);
    }
    end(socket());
    // What was under way ends now; it refers to this.
    io_.restart();
    io_.run();
  }

  /// @return false: not in time, or nobody takes it
  bool reach(const tcp::endpoint& there, std::int64_t until_ns, const std::stop_token& stop) {
    if (openAlone(socket(), there.protocol())) return false;
    socket().async_connect(there, receiving_.handler());
    return run(io_, receiving_, until_ns, stop) && !receiving_.error;
  }
  /// @return false: not in time, or not what was asked for
  bool shakeHands(const std::string& host, std::int64_t until_ns, const std::stop_token& stop) {
    error_code ignored;
    socket().set_option(tcp::no_delay(true), ignored);
    stream_.read_message_max(kMostBytes);
    stream_.text(true);
    Operation& hands = receiving_;
    stream_.async_handshake(host, "/", hands.handler());
    open_ = run(io_, hands, until_ns, stop) && !hands.error;
    return open_;
  }

  PortResult send(std::string_view text, std::int64_t until_ns) override {
    if (!open_ || !sending_.ended || text.size() > out_.size()) return PortResult::gone;
    text.copy(out_.data(), text.size());
    stream_.async_write(asio::buffer(out_.data(), text.size()), sending_.handler());
    if (!run(io_, sending_, until_ns)) return PortResult::timeout;
    if (sending_.error) open_ = false;
    return sending_.error ? PortResult::gone : PortResult::ok;
  }

  Incoming receive(std::int64_t until_ns) override {
    if (!open_) return {PortResult::gone, {}};
    if (!reading_) {
      reading_ = true;
      in_.clear();
      stream_.async_read(in_, receiving_.handler());
    }
    if (!run(io_, receiving_, until_ns)) return {};
    reading_ = false;
    if (receiving_.error) {
      open_ = false;
      return {PortResult::gone, {}};
    }
    const auto bytes = in_.cdata();
    return {PortResult::ok, {static_cast<const char*>(bytes.data()), bytes.size()}};
  }

 private:
  tcp::socket& socket() { return beast::get_lowest_layer(stream_); }

  asio::io_context io_{1};
  beast::websocket::stream<tcp::socket> stream_{io_};
  beast::flat_static_buffer<kMostBytes> in_;
  std::array<char, 1024> out_{};
  Operation sending_, receiving_, closing_;
  bool open_ = false, reading_ = false;
};

/// GET /version, in a connection of its own.
class VersionQuestion {
 public:
  ~VersionQuestion() {
    end(socket_);
    io_.restart();
    io_.run();
  }
  /// @return the body; nothing: nobody answers so
  std::optional<std::string> ask(const tcp::endpoint& there, const std::string& host,
                                 std::int64_t until_ns, const std::stop_token& stop) {
    if (const error_code error = openAlone(socket_, there.protocol())) {
      throw boost::system::system_error(error);
    }
    socket_.async_connect(there, step_.handler());
    refused_ = run(io_, step_, until_ns, stop) && step_.error;
    if (!step_.ended || step_.error) return std::nullopt;
    request_.version(11);
    request_.method(beast::http::verb::get);
    request_.target("/version");
    request_.set(beast::http::field::host, host);
    request_.set(beast::http::field::connection, "close");
    beast::http::async_write(socket_, request_, step_.handler());
    if (!run(io_, step_, until_ns, stop) || step_.error) return std::nullopt;
    parser_.body_limit(kMostBytes);
    beast::http::async_read(socket_, buffer_, parser_, step_.handler());
    if (!run(io_, step_, until_ns, stop) || step_.error) return std::nullopt;
    return parser_.get().body();
  }
  bool refused() const { return refused_; }

 private:
  asio::io_context io_{1};
  tcp::socket socket_{io_};
  beast::http::request<beast::http::empty_body> request_;
  beast::http::response_parser<beast::http::string_body> parser_;
  beast::flat_static_buffer<kMostBytes> buffer_;
  Operation step_;
  bool refused_ = false;
};

class BeastService : public Service {
 public:
  explicit BeastService(ServiceAddress address)
      : address_(std::move(address)), port_(address_.ports.front()) {}

  std::string address() const override { return address_.host + ":" + std::to_string(port_); }
  std::int64_t patienceNs() const override { return address_.patience_ns; }
  std::int64_t now() const override { return monotonicNs(); }
  void sleepUntil(std::int64_t time_ns) override { relievo::sleepUntil(time_ns); }

  Connection connect(const std::stop_token& stop) override {
    error_code bad;
    const auto host = asio::ip::make_address(address_.host, bad);
    if (bad) return {.reached = Reached::absent};
    // Whoever speaks as the service does is it; the first other answer is told.
    Connection best;
    for (const std::uint16_t port : address_.ports) {
      Connection connection = tryTo({host, port}, stop);
      if (connection.reached == Reached::connected || best.reached == Reached::absent) {
        if (connection.reached != Reached::absent) port_ = port;
        best = std::move(connection);
      }
      if (best.reached == Reached::connected) break;
    }
    return best;
  }

 private:
  /// The device's thread may not throw: that no descriptor is left is a reason like others.
  Connection tryTo(const tcp::endpoint& there, const std::stop_token& stop) const {
    try {
      return connectTo(there, stop);
    } catch (const std::exception& error) {
      return {.reached = Reached::other, .detail = error.what()};
    }
  }

  Connection connectTo(const tcp::endpoint& there, const std::stop_token& stop) const {
    const std::string host = address_.host + ":" + std::to_string(there.port());
    const std::int64_t until_ns = monotonicNs() + address_.patience_ns;
    Connection connection;
    const auto question = std::make_unique<VersionQuestion>();
    const auto body = question->ask(there, host, until_ns, stop);
    if (question->refused()) return connection;
    const auto version = body ? readVersion(*body) : std::nullopt;
    if (!version) {
      connection.reached = Reached::other;
      connection.detail = body ? "no version" : "no answer";
      return connection;
    }
    connection.version = *version;
    connection.reached = Reached::too_old;
    if (!isSpokenBy(*version)) return connection;
    connection.reached = Reached::other;
    connection.detail = "no WebSocket";
    auto session = std::make_unique<BeastPort>();
    const bool reached = session->reach(there, until_ns, stop);
    if (!reached || !session->shakeHands(host, until_ns, stop)) return connection;
    connection.reached = Reached::connected;
    connection.port = std::move(session);
    return connection;
  }

  ServiceAddress address_;
  std::uint16_t port_;
};
}  // namespace

std::unique_ptr<Service> inverseService(ServiceAddress address) {
  return std::make_unique<BeastService>(std::move(address));
}

std::unique_ptr<Port> eventPort(const ServiceAddress& address, const std::stop_token& stop) {
  try {
    error_code bad;
    const auto host = asio::ip::make_address(address.host, bad);
    if (bad) return nullptr;
    const std::int64_t until_ns = monotonicNs() + address.patience_ns;
    auto session = std::make_unique<BeastPort>();
    const bool reached = session->reach({host, address.events_port}, until_ns, stop);
    const std::string name = address.host + ":" + std::to_string(address.events_port);
    if (!reached || !session->shakeHands(name, until_ns, stop)) return nullptr;
    return session;
  } catch (const std::exception&) {
    return nullptr;  // No descriptor is left, say.
  }
}

bool hasInverseService() {
  return true;
}

}  // namespace relievo::haply
