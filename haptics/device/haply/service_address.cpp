// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/service_address.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <system_error>

#include "core/base/failure.h"

namespace relievo::haply {

namespace {
/// Numbers alone: to look up a name takes as long as it takes.
bool isHost(const std::string& text) {
  in6_addr ignored{};  // Large enough for either.
  return ::inet_pton(AF_INET, text.c_str(), &ignored) == 1 ||
         ::inet_pton(AF_INET6, text.c_str(), &ignored) == 1;
}
}  // namespace

std::optional<ServiceAddress> addressOf(std::string_view text) {
  ServiceAddress address;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    address.host = text.substr(0, colon);
    text.remove_prefix(colon + 1);
    if (address.host.starts_with('[') && address.host.ends_with(']')) {
      address.host = address.host.substr(1, address.host.size() - 2);
    }
  }
  std::uint16_t port = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  if (!whole || port == 0 || !isHost(address.host)) return std::nullopt;
  address.ports = {port};
  address.events_port = 0;  // Nobody knows where it is.
  return address;
}

namespace {
std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}
std::string namedAddress() {
  return environment("RELIEVO_HAPLY_SERVICE");
}
/// What is no port is none.
std::optional<std::uint16_t> namedEventsPort() {
  const std::string text = environment("RELIEVO_HAPLY_EVENTS");
  if (text.empty()) return std::nullopt;
  std::uint16_t port = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, port);
  return read.ec == std::errc() && read.ptr == end ? port : std::uint16_t{0};
}
std::int64_t namedPatienceNs() {
  const std::string text = environment("RELIEVO_HAPLY_PATIENCE_S");
  constexpr std::int64_t kLongestS = 3600;
  std::int64_t seconds = 0;
  std::from_chars(text.data(), text.data() + text.size(), seconds);
  return seconds > 0 && seconds <= kLongestS ? seconds * 1'000'000'000 : kPatienceNs;
}
}  // namespace

ServiceAddress serviceAddress() {
  const std::string named = namedAddress();
  auto address = named.empty() ? std::optional<ServiceAddress>(ServiceAddress{}) : addressOf(named);
  if (!address) throw failure<MessageId::haply_address_unknown>(named);
  address->patience_ns = namedPatienceNs();
  address->events_port = namedEventsPort().value_or(address->events_port);
  return *std::move(address);
}

bool isServiceThere() {
  const std::string named = namedAddress();
  const auto address =
      named.empty() ? std::optional<ServiceAddress>(ServiceAddress{}) : addressOf(named);
  return hasInverseService() && address && isListenedTo(*address);
}

namespace {
/// Of loopback the answer comes at once. The table of the system's connections, /proc/net/tcp,
/// takes eight milliseconds.
bool takesConnections(const sockaddr_in& there) {
  constexpr int kPatienceMs = 100;  // Only where packets to this computer itself are thrown away.
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return false;
  bool takes = ::connect(descriptor, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
  pollfd waiting{.fd = descriptor, .events = POLLOUT, .revents = 0};
  if (!takes && errno == EINPROGRESS && ::poll(&waiting, 1, kPatienceMs) > 0) {
    int error = 0;
    socklen_t size = sizeof error;
    takes = ::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
  }
  ::close(descriptor);
  return takes;
}
}  // namespace

bool isListenedTo(const ServiceAddress& address) {
  sockaddr_in there{};
  there.sin_family = AF_INET;
  const bool is_here = address.host.starts_with("127.") &&
                       ::inet_pton(AF_INET, address.host.c_str(), &there.sin_addr) == 1;
  return !is_here ||
         std::any_of(address.ports.begin(), address.ports.end(), [&there](std::uint16_t port) {
           there.sin_port = htons(port);
           return takesConnections(there);
         });
}

}  // namespace relievo::haply
