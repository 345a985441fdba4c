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

std::optional<ServiceAddress> addressOf(std::string_view text) {
  ServiceAddress address;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    address.host = text.substr(0, colon);
    text.remove_prefix(colon + 1);
  }
  std::uint16_t port = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  if (!whole || port == 0 || address.host.empty()) return std::nullopt;
  address.ports = {port};
  return address;
}

namespace {
std::string namedAddress() {
  const char* const named = std::getenv("RELIEVO_HAPLY_SERVICE");
  return named == nullptr ? std::string() : named;
}
}  // namespace

ServiceAddress serviceAddress() {
  const std::string named = namedAddress();
  if (named.empty()) return {};
  auto address = addressOf(named);
  if (!address) throw failure<MessageId::haply_address_unknown>(named);
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
