// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/usbip_server.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/rt/realtime_thread.h"

namespace relievo::emulator {

namespace {
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kReturnSubmit = 3, kReturnUnlink = 4;
constexpr std::size_t kHeader = 48;
constexpr std::uint32_t kMostTransfer = 1U << 20U;
constexpr std::uint16_t kVersion = 0x0111;
constexpr std::uint16_t kListRequest = 0x8005, kImportRequest = 0x8003;

void put16(Bytes& out, std::uint32_t value) {
  out.push_back(static_cast<std::uint8_t>(value >> 8U));
  out.push_back(static_cast<std::uint8_t>(value));
}
void put32(Bytes& out, std::uint32_t value) {
  put16(out, value >> 16U);
  put16(out, value & 0xffffU);
}
void putText(Bytes& out, std::string_view text, std::size_t size) {
  Bytes padded(text.begin(), text.end());
  padded.resize(size);
  out.insert(out.end(), padded.begin(), padded.end());
}
std::uint32_t get32(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24U |
         static_cast<std::uint32_t>(bytes[at + 1]) << 16U |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8U | bytes[at + 3];
}

Bytes stringDescriptor(std::uint8_t index) {
  constexpr std::array<std::string_view, 4> kTexts{"", "NOVINT", "FALCON HAPTIC", "EMULATED"};
  if (index == 0) return {4, 3, 0x09, 0x04};
  if (index >= kTexts.size()) return {};
  Bytes bytes{static_cast<std::uint8_t>(2 + 2 * kTexts[index].size()), 3};
  for (const char c : kTexts[index]) {
    bytes.push_back(static_cast<std::uint8_t>(c));
    bytes.push_back(0);
  }
  return bytes;
}

/// Requests that every device answers (USB 2.0, section 9.4). Nothing: stall.
std::optional<Bytes> standardRequest(const std::array<std::uint8_t, 8>& setup) {
  constexpr int kGetStatus = 0, kGetDescriptor = 6, kGetConfiguration = 8, kSetConfiguration = 9,
                kSetInterface = 11, kClearFeature = 1;
  switch (setup[1]) {
    case kGetStatus:
      return Bytes{0, 0};
    case kGetConfiguration:
      return Bytes{1};
    case kSetConfiguration:
    case kSetInterface:
    case kClearFeature:
      return Bytes{};
    case kGetDescriptor:
      if (setup[3] == 1) return FalconEmulator::deviceDescriptor();
      if (setup[3] == 2) return FalconEmulator::configurationDescriptor();
      if (setup[3] == 3) {
        Bytes text = stringDescriptor(setup[2]);
        if (!text.empty()) return text;
      }
      return std::nullopt;
    default:
      return std::nullopt;
  }
}
}  // namespace

struct UsbipServer::Impl {
  int socket;
  std::shared_ptr<SharedFalcon> falcon;
  bool negotiating;

  struct Transfer {
    std::uint32_t sequence = 0;
    bool in = false;
    std::uint32_t length = 0;
    Bytes data;
  };
  std::list<Transfer> waiting;
  Bytes received;
  bool open = true;

  void send(const Bytes& bytes) {
    std::size_t sent = 0;
    while (open && sent < bytes.size()) {
      const ssize_t n = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) {
        open = false;
      } else {
        sent += static_cast<std::size_t>(n);
      }
    }
  }
  void reply(std::uint32_t sequence, int status, const Bytes& data, std::size_t length) {
    Bytes out;
    for (const std::uint32_t word :
         {kReturnSubmit, sequence, 0U, 0U, 0U, static_cast<std::uint32_t>(status),
          static_cast<std::uint32_t>(length), 0U, 0U, 0U, 0U, 0U}) {
      put32(out, word);
    }
    out.insert(out.end(), data.begin(), data.end());
    send(out);
  }

  bool takeNegotiation();
  bool takeCommand();
  void submit(std::span<const std::uint8_t> header, Bytes data);
  void control(std::uint32_t sequence, bool in, std::span<const std::uint8_t> header);
  void unlink(std::uint32_t sequence, std::uint32_t victim);
  void serveWaiting();
};

/// @return false: more bytes are needed
bool UsbipServer::Impl::takeNegotiation() {
  constexpr std::size_t kRequest = 8, kBusId = 32;
  if (received.size() < kRequest) return false;
  const unsigned code = received[2] * 256U + received[3];
  const bool import = code == kImportRequest;
  if (!import && code != kListRequest) {
    open = false;
    return false;
  }
  const std::size_t size = kRequest + (import ? kBusId : 0);
  if (received.size() < size) return false;
  received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(size));
  Bytes out;
  put16(out, kVersion);
  put16(out, code & 0x7fffU);
  put32(out, 0);
  if (!import) put32(out, 1);  // One device.
  putText(out, "/sys/devices/relievo/1-1", 256);
  putText(out, "1-1", kBusId);
  put32(out, 1);
  put32(out, 2);
  put32(out, 2);  // Full speed.
  put16(out, 0x0403);
  put16(out, 0xcb48);
  put16(out, 0x0600);
  out.insert(out.end(),
             {0, 0, 0, 1, 1, 1});  // Class by interface; one configuration, one interface.
  if (!import) out.insert(out.end(), {0xff, 0xff, 0xff, 0});
  send(out);
  negotiating = !import;
  return true;
}

bool UsbipServer::Impl::takeCommand() {
  if (received.size() < kHeader) return false;
  const std::span<const std::uint8_t> bytes(received);
  const std::uint32_t command = get32(bytes, 0);
  const bool out = get32(bytes, 12) == 0;
  const std::uint32_t length = get32(bytes, 24);
  if ((command != kSubmit && command != kUnlink) ||
      (command == kSubmit && length > kMostTransfer)) {
    open = false;
    return false;
  }
  const std::size_t data = command == kSubmit && out ? length : 0;
  if (received.size() < kHeader + data) return false;
  const Bytes header(received.begin(), received.begin() + kHeader);
  Bytes content(received.begin() + kHeader,
                received.begin() + static_cast<std::ptrdiff_t>(kHeader + data));
  received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(kHeader + data));
  if (command == kUnlink) {
    unlink(get32(header, 4), get32(header, 20));
  } else {
    submit(header, std::move(content));
  }
  return true;
}

void UsbipServer::Impl::submit(std::span<const std::uint8_t> header, Bytes data) {
  const std::uint32_t sequence = get32(header, 4), endpoint = get32(header, 16);
  const bool in = get32(header, 12) != 0;
  if (endpoint == 0) {
    control(sequence, in, header);
  } else {
    waiting.push_back({sequence, in, get32(header, 24), std::move(data)});
  }
}

void UsbipServer::Impl::control(std::uint32_t sequence, bool in,
                                std::span<const std::uint8_t> header) {
  std::array<std::uint8_t, 8> setup{};
  std::copy_n(header.begin() + 40, setup.size(), setup.begin());
  const std::size_t length = get32(header, 24);
  std::optional<Bytes> answer;
  if ((setup[0] & 0x60U) == 0) {
    answer = standardRequest(setup);
  } else {
    Bytes room(std::min<std::size_t>(length, 64));
    const auto bytes =
        falcon->with([&](FalconEmulator& f) { return f.control(setup, room, monotonicNs()); });
    if (bytes) {
      room.resize(*bytes);
      answer = room;
    }
  }
  if (!answer) {
    reply(sequence, -EPIPE, {}, 0);
    return;
  }
  if (answer->size() > length) answer->resize(length);
  reply(sequence, 0, in ? *answer : Bytes{}, in ? answer->size() : length);
}

void UsbipServer::Impl::unlink(std::uint32_t sequence, std::uint32_t victim) {
  const auto found = std::find_if(waiting.begin(), waiting.end(),
                                  [victim](const Transfer& t) { return t.sequence == victim; });
  const int status = found == waiting.end() ? 0 : -ECONNRESET;
  if (found != waiting.end()) waiting.erase(found);
  Bytes out;
  for (const std::uint32_t word : {kReturnUnlink, sequence, 0U, 0U, 0U,
                                   static_cast<std::uint32_t>(status), 0U, 0U, 0U, 0U, 0U, 0U}) {
    put32(out, word);
  }
  send(out);
}

void UsbipServer::Impl::serveWaiting() {
  const std::int64_t now = monotonicNs();
  for (auto transfer = waiting.begin(); transfer != waiting.end();) {
    std::optional<Bytes> packet;
    const bool done = falcon->with([&](FalconEmulator& f) {
      if (!transfer->in) return f.bulkOut(transfer->data, now);
      packet = f.bulkIn(now);
      return packet.has_value();
    });
    if (!done) {
      ++transfer;
      continue;
    }
    if (packet && packet->size() > transfer->length) {
      reply(transfer->sequence, -EOVERFLOW, {}, 0);
    } else {
      reply(transfer->sequence, 0, packet.value_or(Bytes{}),
            packet ? packet->size() : transfer->data.size());
    }
    transfer = waiting.erase(transfer);
  }
}

UsbipServer::UsbipServer(int socket, std::shared_ptr<SharedFalcon> falcon, bool negotiate)
    : impl_(std::make_unique<Impl>()) {
  impl_->socket = socket;
  impl_->falcon = std::move(falcon);
  impl_->negotiating = negotiate;
}

UsbipServer::~UsbipServer() {
  close(impl_->socket);
}

void UsbipServer::serve(const std::stop_token& stop) {
  Impl& s = *impl_;
  while (s.open && !stop.stop_requested()) {
    if (!s.falcon->with([](FalconEmulator& f) { return f.plugged(); })) return;
    while (s.open && (s.negotiating ? s.takeNegotiation() : s.takeCommand())) {
    }
    s.serveWaiting();
    // Until bytes come or the chip's latency timer lets a packet go.
    constexpr std::int64_t kLongestNs = 20'000'000;
    const std::int64_t now = monotonicNs();
    const bool reading = std::any_of(s.waiting.begin(), s.waiting.end(),
                                     [](const Impl::Transfer& t) { return t.in; });
    std::int64_t wait = kLongestNs;
    if (reading) {
      wait = std::clamp<std::int64_t>(
          s.falcon->with([&](FalconEmulator& f) { return f.nextIn(now); }) - now, 0, kLongestNs);
    }
    const timespec timeout{.tv_sec = 0, .tv_nsec = wait};
    pollfd poll{.fd = s.socket, .events = POLLIN, .revents = 0};
    if (ppoll(&poll, 1, &timeout, nullptr) <= 0) continue;
    std::array<std::uint8_t, 4096> bytes{};
    const ssize_t n = recv(s.socket, bytes.data(), bytes.size(), 0);
    if (n <= 0) return;
    s.received.insert(s.received.end(), bytes.begin(), bytes.begin() + n);
  }
}

int attachToVhci() {
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) return -1;
  const int attach = open("/sys/devices/platform/vhci_hcd.0/attach", O_WRONLY | O_CLOEXEC);
  if (attach < 0) return -1;
  // Port, descriptor, bus and device number, full speed.
  const std::string text = "0 " + std::to_string(pair[1]) + " 65538 2";
  const bool done = write(attach, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(attach);
  close(pair[1]);
  return done ? pair[0] : -1;
}

}  // namespace relievo::emulator
