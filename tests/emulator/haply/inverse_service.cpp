// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/haply/inverse_service.h"

#include <utility>  // Before Boost 1.74, whose awaitable.hpp needs it in C++20.

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <poll.h>

#include <chrono>
#include <list>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "haptics/rt/realtime_thread.h"

namespace relievo::emulator {

namespace {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;

/// A real service answers thousands of times a second, and so must this one on a busy computer;
/// where the system refuses, it is as late as others.
void beOnTime() {
  constexpr int kPriority = 60;  // Below all threads of relievo's own.
  [[maybe_unused]] const RealtimeGrant grant = requestRealtime(kPriority, {});
}

constexpr int kLookMs = 20;  // At the stop token.

std::int64_t nowNs() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}
void sleepMs(int ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

/// @return false: stopped
bool waitFor(int descriptor, const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, kLookMs) > 0) return true;
  }
  return false;
}

/// An unmasked frame of text, as servers send them.
std::string frameOf(const std::string& text) {
  std::string frame(1, '\x81');
  if (text.size() < 126) {
    frame += static_cast<char>(text.size());
  } else {
    frame += '\x7e';
    frame += static_cast<char>(text.size() >> 8U & 255U);
    frame += static_cast<char>(text.size() & 255U);
  }
  return frame + text;
}
}  // namespace

struct InverseService::Impl {
  std::mutex mutex;
  HaplyWorld world;
  asio::io_context io;
  tcp::acceptor acceptor{io}, events_acceptor{io};
  std::list<std::jthread> sessions, listeners;  // Of the accepting threads.
  std::jthread clock, accepting, accepting_listeners;

  bool hasFault(HaplyFault one) {
    const std::lock_guard lock(mutex);
    return world.hasFault(one);
  }
  void tellVersion(tcp::socket& socket);
  void serve(tcp::socket socket, const std::stop_token& stop);
  void session(websocket::stream<tcp::socket>& stream, const std::stop_token& stop);
  bool say(websocket::stream<tcp::socket>& stream, const std::string& text);
  void listen(const tcp::endpoint& there, tcp::acceptor& at) const;
  void tellEvents(tcp::socket socket, const std::stop_token& stop);
  bool tellEvent(websocket::stream<tcp::socket>& stream, const std::string& text);
};

void InverseService::Impl::tellVersion(tcp::socket& socket) {
  http::response<http::string_body> response(http::status::ok, 11);
  response.set(http::field::content_type, "application/json");
  {
    const std::lock_guard lock(mutex);
    response.body() = world.versionText();
  }
  response.prepare_payload();
  error_code ignored;
  http::write(socket, response, ignored);
}

void InverseService::Impl::serve(tcp::socket socket, const std::stop_token& stop) {
  beOnTime();
  error_code error;
  socket.set_option(tcp::no_delay(true), error);
  beast::flat_buffer buffer;
  http::request<http::string_body> request;
  if (!waitFor(socket.native_handle(), stop)) return;
  http::read(socket, buffer, request, error);
  if (error) return;
  if (!websocket::is_upgrade(request)) return tellVersion(socket);
  websocket::stream<tcp::socket> stream(std::move(socket));
  stream.accept(request, error);
  if (error) return;
  session(stream, stop);
  const std::lock_guard lock(mutex);
  world.endSession(nowNs());
}

/// @return false: the session ends
bool InverseService::Impl::say(websocket::stream<tcp::socket>& stream, const std::string& text) {
  error_code error;
  stream.text(true);
  if (hasFault(HaplyFault::closes)) {
    stream.close(websocket::close_code::going_away, error);
    return false;
  }
  if (hasFault(HaplyFault::ping)) stream.ping({}, error);
  if (hasFault(HaplyFault::huge_frame)) {
    stream.write(asio::buffer(std::string(std::size_t{70} << 10U, ' ')), error);
  } else if (hasFault(HaplyFault::byte_pieces)) {
    for (const char c : frameOf(text)) asio::write(stream.next_layer(), asio::buffer(&c, 1), error);
  } else if (hasFault(HaplyFault::fragments)) {
    constexpr std::size_t kPiece = 100;
    for (std::size_t at = 0; at < text.size() && !error; at += kPiece) {
      const bool last = at + kPiece >= text.size();
      stream.write_some(last, asio::buffer(text.substr(at, kPiece)), error);
    }
  } else {
    stream.write(asio::buffer(text), error);
  }
  return !error;
}

void InverseService::Impl::session(websocket::stream<tcp::socket>& stream,
                                   const std::stop_token& stop) {
  error_code error;
  std::string answer;
  {
    const std::lock_guard lock(mutex);
    answer = world.inventory(nowNs());
  }
  if (!say(stream, answer)) return;
  beast::flat_buffer in;
  while (waitFor(stream.next_layer().native_handle(), stop)) {
    in.clear();
    stream.read(in, error);
    if (error) return;
    {
      const std::lock_guard lock(mutex);
      answer = world.answer({static_cast<const char*>(in.cdata().data()), in.size()}, nowNs());
    }
    if (hasFault(HaplyFault::silent)) continue;
    if (hasFault(HaplyFault::late_3_ms)) sleepMs(3);
    if (hasFault(HaplyFault::late_10_ms)) sleepMs(10);
    if (hasFault(HaplyFault::late_30_ms)) sleepMs(30);
    if (!say(stream, answer)) return;
    if (hasFault(HaplyFault::two_answers) && !say(stream, answer)) return;
  }
}

void InverseService::Impl::listen(const tcp::endpoint& there, tcp::acceptor& at) const {
  at.open(there.protocol());
  at.set_option(tcp::acceptor::reuse_address(true));
  at.bind(there);
  at.listen();
}

/// @return false: the session ends
bool InverseService::Impl::tellEvent(websocket::stream<tcp::socket>& stream,
                                     const std::string& text) {
  error_code error;
  stream.text(true);
  if (hasFault(HaplyFault::events_garbage)) {
    const std::string huge = "{\"name\":\"" + std::string(30'000, 'x') + "\"}";
    for (const std::string& garbage :
         {text.substr(0, text.size() / 2), std::string("[1,"), std::string("\"\\ud800\""), huge,
          std::string(R"({"name":"device-sings","data":7})")}) {
      stream.write(asio::buffer(garbage), error);
    }
  }
  stream.write(asio::buffer(text), error);
  return !error && !hasFault(HaplyFault::events_close);
}

/// What comes from now on; whatever the other side says is not heard.
void InverseService::Impl::tellEvents(tcp::socket socket, const std::stop_token& stop) {
  if (hasFault(HaplyFault::events_refused)) return;
  error_code error;
  websocket::stream<tcp::socket> stream(std::move(socket));
  if (!waitFor(stream.next_layer().native_handle(), stop)) return;
  std::size_t told = 0;
  {
    const std::lock_guard lock(mutex);
    told = world.events.size();
  }
  stream.accept(error);
  while (!error && !stop.stop_requested()) {
    std::vector<std::string> news;
    {
      const std::lock_guard lock(mutex);
      news.assign(world.events.begin() + static_cast<std::ptrdiff_t>(told), world.events.end());
    }
    told += news.size();
    for (const std::string& text : news) {
      if (!tellEvent(stream, text)) return;
    }
    sleepMs(5);
  }
}

InverseService::InverseService(std::uint16_t port, std::uint16_t events_port)
    : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  const asio::ip::address here = asio::ip::make_address("127.0.0.1");
  impl.listen({here, port}, impl.acceptor);
  impl.listen({here, events_port}, impl.events_acceptor);
  impl.accepting_listeners = std::jthread([&impl](const std::stop_token& stop) {
    while (waitFor(impl.events_acceptor.native_handle(), stop)) {
      error_code error;
      tcp::socket socket(impl.io);
      impl.events_acceptor.accept(socket, error);
      if (error) continue;
      impl.listeners.emplace_back(
          [&impl, s = std::move(socket)](const std::stop_token& end) mutable {
            impl.tellEvents(std::move(s), end);
          });
    }
    impl.listeners.clear();
  });
  impl.clock = std::jthread([&impl](const std::stop_token& stop) {
    beOnTime();  // It holds the lock that sessions wait for.
    while (!stop.stop_requested()) {
      sleepMs(1);
      const std::lock_guard lock(impl.mutex);
      impl.world.advance(nowNs());
    }
  });
  impl.accepting = std::jthread([&impl](const std::stop_token& stop) {
    while (waitFor(impl.acceptor.native_handle(), stop)) {
      error_code error;
      tcp::socket socket(impl.io);
      impl.acceptor.accept(socket, error);
      if (error) continue;
      impl.sessions.emplace_back(
          [&impl, s = std::move(socket)](const std::stop_token& end) mutable {
            impl.serve(std::move(s), end);
          });
    }
    impl.sessions.clear();
  });
}

InverseService::~InverseService() {
  impl_->accepting = {};
  impl_->accepting_listeners = {};
  impl_->clock = {};
}

std::uint16_t InverseService::port() const {
  return impl_->acceptor.local_endpoint().port();
}

std::uint16_t InverseService::eventsPort() const {
  return impl_->events_acceptor.local_endpoint().port();
}

HaplyWorld& InverseService::world() {
  return impl_->world;
}

InverseService::Alone::Alone(InverseService& service) : service_(service) {
  service_.impl_->mutex.lock();
}
InverseService::Alone::~Alone() {
  service_.impl_->mutex.unlock();
}

}  // namespace relievo::emulator
