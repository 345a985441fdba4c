// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/usb_bus.h"

#include <poll.h>
#include <ctime>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <utility>

#include "core/base/failure.h"
#include "core/base/late_library.h"
#include "haptics/device/falcon/emergency_stop.h"
#include "haptics/device/falcon/libusb_functions.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::falcon {

namespace {
LibusbFunctions loadedLibusb() {
  LateLibrary library("libusb-1.0.so.0");
  LibusbFunctions functions;
#define RELIEVO_FIND(name) library.find("libusb_" #name, functions.name);
  RELIEVO_LIBUSB_FUNCTIONS(RELIEVO_FIND)
#undef RELIEVO_FIND
  functions.problem = library.problem();
  return functions;
}
}  // namespace

const LibusbFunctions& usb() {
  static const LibusbFunctions kFunctions = loadedLibusb();
  return kFunctions;
}

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr unsigned kControlTimeoutMs = 1000, kWriteTimeoutMs = 100;
constexpr std::uint8_t kToChip = 0x40;  // Vendor request, host to device.

timeval timeLeft(std::int64_t until_ns) {
  const std::int64_t us = std::max<std::int64_t>(0, until_ns - monotonicNs()) / 1000;
  return {.tv_sec = us / 1'000'000, .tv_usec = us % 1'000'000};
}

bool isFalcon(libusb_device* device) {
  libusb_device_descriptor descriptor{};
  return usb().get_device_descriptor(device, &descriptor) == 0 &&
         descriptor.idVendor == kVendorId && descriptor.idProduct == kProductId;
}

/// All devices, and none of them lost.
class DeviceList {
 public:
  explicit DeviceList(libusb_context* context) : count_(usb().get_device_list(context, &list_)) {}
  ~DeviceList() {
    if (count_ >= 0) usb().free_device_list(list_, 1);
  }
  DeviceList(const DeviceList&) = delete;
  DeviceList& operator=(const DeviceList&) = delete;
  std::span<libusb_device*> devices() const {
    return {list_, static_cast<std::size_t>(std::max<ssize_t>(0, count_))};
  }

 private:
  libusb_device** list_ = nullptr;
  ssize_t count_;
};

/// "1-2.4", as the system names it; empty where it does not say.
std::string portOf(libusb_device* device) {
  constexpr int kDeepest = 7;  // Of the standard.
  std::array<std::uint8_t, kDeepest> numbers{};
  const int depth = usb().get_port_numbers(device, numbers.data(), kDeepest);
  if (depth <= 0) return {};
  std::string port = std::to_string(usb().get_bus_number(device));
  for (int i = 0; i < depth; ++i) {
    port += (i == 0 ? "-" : ".") + std::to_string(numbers.at(static_cast<std::size_t>(i)));
  }
  return port;
}

/// As the system has read it: no access to the device is needed for it.
std::string serialAt(const std::string& port) {
  if (port.empty()) return {};
  std::ifstream file("/sys/bus/usb/devices/" + port + "/serial");
  std::string line;
  std::getline(file, line);
  constexpr std::size_t kMost = 40;
  std::string serial;
  for (const char c : line) {
    const bool printed = std::isgraph(static_cast<unsigned char>(c)) != 0;
    if (printed && serial.size() < kMost) serial += c;
  }
  return serial;
}

SeenFalcon seen(libusb_device* device) {
  const int speed = usb().get_device_speed(device);
  const std::string port = portOf(device);
  return {.serial = serialAt(port),
          .port = port,
          .bus = usb().get_bus_number(device),
          .address = usb().get_device_address(device),
          .speed_mbit = speed == LIBUSB_SPEED_FULL   ? 12
                        : speed == LIBUSB_SPEED_HIGH ? 480
                                                     : 0};
}

/// The descriptor of the device's node: the one that libusb waits on for room to write.
int nodeOf(libusb_context* context) {
  const libusb_pollfd** list = usb().get_pollfds(context);
  int node = -1;
  for (const libusb_pollfd** fd = list; fd != nullptr && *fd != nullptr; ++fd) {
    if (((*fd)->events & POLLOUT) != 0) node = (*fd)->fd;
  }
  usb().free_pollfds(list);
  return node;
}

class UsbPort;

struct Read {
  libusb_transfer* transfer = nullptr;
  UsbPort* port = nullptr;
  std::array<std::uint8_t, kPacketBytes> bytes{};
  bool under_way = false;
};

/// What the system may still write to after the port is gone.
struct Transfers {
  std::array<Read, 2> reads;  // Two, so that one is always queued.
  libusb_transfer* out = nullptr;
  std::array<std::uint8_t, kPacketBytes> out_bytes{};
};

class UsbPort : public Port {
 public:
  UsbPort(libusb_context* context, libusb_device_handle* handle)
      : context_(context), handle_(handle), last_words_(std::in_place, nodeOf(context)) {
    for (Read& read : transfers_->reads) {
      read.transfer = usb().alloc_transfer(0);
      read.port = this;
      libusb_fill_bulk_transfer(read.transfer, handle_, kEndpointIn, read.bytes.data(),
                                static_cast<int>(read.bytes.size()), &UsbPort::onRead, &read, 0);
      submit(read);
    }
    transfers_->out = usb().alloc_transfer(0);
  }

  ~UsbPort() override {
    // The last frame carries zero: it has its time. Its own limit ends before this one.
    const std::int64_t sent_by = monotonicNs() + (kWriteTimeoutMs + 50) * kMs;
    while (writing_ && !gone_ && monotonicNs() < sent_by) handleEvents(sent_by);
    closing_ = true;
    for (Read& read : transfers_->reads) {
      if (read.under_way) usb().cancel_transfer(read.transfer);
    }
    if (writing_) usb().cancel_transfer(transfers_->out);
    const std::int64_t give_up = monotonicNs() + 2000 * kMs;
    while (busy() && monotonicNs() < give_up) handleEvents(monotonicNs() + 100 * kMs);
    last_words_.reset();                  // The node's number may soon be another file's.
    usb().release_interface(handle_, 0);  // And the kernel's driver, if there was one, comes back.
    usb().close(handle_);
    if (busy()) {  // Never freed while the kernel may write to them.
      for (Read& read : transfers_->reads) read.port = nullptr;
      transfers_->out->user_data = nullptr;
      static_cast<void>(transfers_.release());
      return;
    }
    for (Read& read : transfers_->reads) usb().free_transfer(read.transfer);
    usb().free_transfer(transfers_->out);
  }

  PortResult request(const BridgeRequest& request) override {
    if (gone_) return PortResult::gone;
    const int result = usb().control_transfer(handle_, kToChip, request.request, request.value,
                                              request.index, nullptr, 0, kControlTimeoutMs);
    if (result == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
    if (gone_) return PortResult::gone;
    return result < 0 ? PortResult::timeout : PortResult::ok;
  }

  PortResult write(std::span<const std::uint8_t> bytes) override {
    const std::int64_t give_up = monotonicNs() + (kWriteTimeoutMs + 50) * kMs;
    while (writing_ && !gone_ && monotonicNs() < give_up) handleEvents(give_up);
    if (gone_) return PortResult::gone;
    if (EmergencyStop::spoken()) return PortResult::timeout;
    if (writing_ || !written_ || bytes.size() > transfers_->out_bytes.size()) {
      written_ = true;  // Told once; the next write is tried again.
      return PortResult::timeout;
    }
    std::copy(bytes.begin(), bytes.end(), transfers_->out_bytes.begin());
    libusb_fill_bulk_transfer(transfers_->out, handle_, kEndpointOut, transfers_->out_bytes.data(),
                              static_cast<int>(bytes.size()), &UsbPort::onWritten, this,
                              kWriteTimeoutMs);
    const int result = usb().submit_transfer(transfers_->out);
    if (result == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
    if (gone_) return PortResult::gone;
    if (result != 0) return PortResult::timeout;
    writing_ = true;
    return PortResult::ok;
  }

  Incoming read(std::span<std::uint8_t> into, std::int64_t until_ns) override {
    while (true) {
      if (std::exchange(failed_, false)) {
        read_again_ns_ = monotonicNs() + 5 * kMs;
        return {0, PortResult::failed};
      }
      if (received_ > 0 || damaged_) {
        const std::size_t bytes = std::min(into.size(), received_);
        std::copy_n(buffer_.begin(), bytes, into.begin());
        std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(bytes),
                  buffer_.begin() + static_cast<std::ptrdiff_t>(received_), buffer_.begin());
        received_ -= bytes;
        return {bytes, PortResult::ok, std::exchange(damaged_, false)};
      }
      if (gone_) return {0, PortResult::gone};
      const std::int64_t now = monotonicNs();
      if (now >= until_ns) return {0, PortResult::timeout};
      if (EmergencyStop::spoken()) {  // Whoever says them has the node to themselves.
        sleepUntil(std::min(until_ns, now + kMs));
        return {0, PortResult::timeout};
      }
      readAgain(now);
      if (!failed_) handleEvents(reads() ? until_ns : std::min(until_ns, read_again_ns_));
    }
  }

  void discardInput() override {
    handleEvents(monotonicNs());
    received_ = 0;
  }
  bool clearToSend() const override { return line_.clear_to_send; }
  LineErrors lineErrors() const override { return errors_; }

 private:
  bool busy() const {
    return writing_ || std::any_of(transfers_->reads.begin(), transfers_->reads.end(),
                                   [](const Read& read) { return read.under_way; });
  }
  bool reads() const {
    return std::all_of(transfers_->reads.begin(), transfers_->reads.end(),
                       [](const Read& read) { return read.under_way; });
  }

  void readAgain(std::int64_t now_ns) {
    if (reads() || now_ns < read_again_ns_) return;
    if (std::exchange(stalled_, false)) usb().clear_halt(handle_, kEndpointIn);
    for (Read& read : transfers_->reads) {
      if (!read.under_way && !failed_ && !gone_) submit(read);
    }
  }

  void submit(Read& read) {
    const int result = usb().submit_transfer(read.transfer);
    read.under_way = result == 0;
    if (result == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
    if (result != 0) failed_ = true;
  }

  void handleEvents(std::int64_t until_ns) {
    timeval left = timeLeft(until_ns);
    const int result = usb().handle_events_timeout_completed(context_, &left, nullptr);
    if (result == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
    // Whoever waits for events tries again: not as fast as they fail.
    if (result != 0 && !gone_) sleepUntil(std::min(until_ns, monotonicNs() + kMs));
  }

  void take(std::span<const std::uint8_t> packet) {
    line_ = {};
    std::array<std::uint8_t, kPacketBytes> payload{};
    const std::size_t bytes = stripStatus(packet, payload, line_);
    errors_.add(line_);
    if (line_.damaged()) {
      damaged_ = true;
      received_ = 0;
    }
    const std::size_t room = buffer_.size() - received_;
    const std::size_t kept = std::min(bytes, room);
    std::copy_n(payload.begin(), kept, buffer_.begin() + static_cast<std::ptrdiff_t>(received_));
    received_ += kept;
  }

  static void LIBUSB_CALL onRead(libusb_transfer* transfer) {
    auto& read = *static_cast<Read*>(transfer->user_data);
    read.under_way = false;
    if (read.port == nullptr) return;
    UsbPort& port = *read.port;
    if (transfer->status == LIBUSB_TRANSFER_COMPLETED) {
      port.take({read.bytes.data(), static_cast<std::size_t>(transfer->actual_length)});
      if (!port.gone_ && !port.closing_) port.submit(read);
    } else if (transfer->status == LIBUSB_TRANSFER_NO_DEVICE) {
      port.gone_ = true;
    } else if (transfer->status != LIBUSB_TRANSFER_CANCELLED) {
      // Only this direction: what is written still arrives. read() submits it again, in a while.
      port.failed_ = true;
      port.stalled_ = port.stalled_ || transfer->status == LIBUSB_TRANSFER_STALL;
    }
  }

  static void LIBUSB_CALL onWritten(libusb_transfer* transfer) {
    if (transfer->user_data == nullptr) return;
    UsbPort& port = *static_cast<UsbPort*>(transfer->user_data);
    port.writing_ = false;
    port.written_ = transfer->status == LIBUSB_TRANSFER_COMPLETED;
    if (transfer->status == LIBUSB_TRANSFER_NO_DEVICE) port.gone_ = true;
  }

  libusb_context* context_;
  libusb_device_handle* handle_;
  std::optional<EmergencyStop> last_words_;
  std::unique_ptr<Transfers> transfers_ = std::make_unique<Transfers>();
  std::array<std::uint8_t, 4096> buffer_{};
  std::size_t received_ = 0;
  LineStatus line_;
  LineErrors errors_;
  std::int64_t read_again_ns_ = 0;
  bool damaged_ = false;                   // Not told yet.
  bool failed_ = false, stalled_ = false;  // Of reading; not told yet, not cleared yet.
  bool writing_ = false, written_ = true, gone_ = false, closing_ = false;
};
}  // namespace

namespace {
/// A libusb that counts Falcons coming and going.
struct PlugCounter {
  libusb_context* context = nullptr;
  libusb_hotplug_callback_handle callback = 0;
  bool hears_plugs = false;
  int plugs = 0, plugs_told = 0;

  static int LIBUSB_CALL onPlug(libusb_context* /*context*/, libusb_device* /*device*/,
                                libusb_hotplug_event /*event*/, void* self) {
    ++static_cast<PlugCounter*>(self)->plugs;
    return 0;
  }
  /// @return what libusb says; 0: it can be used
  int begin() {
    if (!usb().problem.empty()) return LIBUSB_ERROR_NOT_SUPPORTED;
    const int result = usb().init(&context);
    if (result != 0) {
      context = nullptr;
      return result;
    }
    hears_plugs =
        usb().has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0 &&
        usb().hotplug_register_callback(
            context, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT,
            LIBUSB_HOTPLUG_NO_FLAGS, kVendorId, kProductId, LIBUSB_HOTPLUG_MATCH_ANY, &onPlug, this,
            &callback) == 0;
    return 0;
  }
  void end() {
    if (context == nullptr) return;
    if (hears_plugs) usb().hotplug_deregister_callback(context, callback);
    usb().exit(context);
    context = nullptr;
  }
};
}  // namespace

struct PlugWatch::Impl : PlugCounter {};
struct UsbBus::Impl : PlugCounter {};

PlugWatch::PlugWatch() : impl_(std::make_unique<Impl>()) {
  if (impl_->begin() != 0) impl_->context = nullptr;
}

PlugWatch::~PlugWatch() {
  impl_->end();
}

bool PlugWatch::changed() {
  if (impl_->context == nullptr) return false;
  timeval at_once{};
  usb().handle_events_timeout_completed(impl_->context, &at_once, nullptr);
  return std::exchange(impl_->plugs_told, impl_->plugs) != impl_->plugs;
}

UsbBus::UsbBus(FalconChoice choice) : impl_(std::make_unique<Impl>()), search_(std::move(choice)) {
  if (const int result = impl_->begin(); result != 0) {
    throw failure<MessageId::usb_not_usable>(usb().problem.empty() ? usb().strerror(result)
                                                                   : usb().problem.c_str());
  }
}

UsbBus::~UsbBus() {
  impl_->end();
}

Opening UsbBus::open() {
  Opening opening = openSeen();
  // Where no udev service tells of plugs (containers, small systems), or where it told while nobody
  // listened, a libusb goes on seeing what it saw first; a new one looks anew.
  const bool outdated =
      opening.presence == Presence::broken ||
      (opening.presence == Presence::absent && search_.among(seenFalcons()).falcon != nullptr);
  if (outdated) {
    impl_->end();
    impl_->begin();
    opening = openSeen();
  }
  return opening;
}

Opening UsbBus::openSeen() {
  Opening opening;
  if (impl_->context == nullptr) {
    opening.presence = Presence::broken;
    opening.detail = said<MessageId::usb_unusable>();
    return opening;
  }
  const DeviceList list(impl_->context);
  std::vector<libusb_device*> devices;
  std::vector<SeenFalcon> there;
  for (libusb_device* device : list.devices()) {
    if (!isFalcon(device)) continue;
    devices.push_back(device);
    there.push_back(seen(device));
  }
  const FalconSearch::Found found = search_.among(there);
  if (found.falcon == nullptr) {
    opening.presence = found.several ? Presence::several : Presence::absent;
    opening.wanted = search_.choice().any() ? std::string() : nameOf(search_.choice());
    opening.others = found.others;
    return opening;
  }
  opening.which = *found.falcon;
  open(devices[static_cast<std::size_t>(found.falcon - there.data())], opening);
  if (opening.presence == Presence::present) search_.keep(opening.which);
  return opening;
}

void UsbBus::open(libusb_device* device, Opening& opening) {
  libusb_device_handle* handle = nullptr;
  int result = usb().open(device, &handle);
  if (result == 0) {
    usb().set_auto_detach_kernel_driver(handle, 1);
    result = usb().claim_interface(handle, 0);
    if (result == 0) {
      opening.presence = Presence::present;
      opening.port = std::make_unique<UsbPort>(impl_->context, handle);
      return;
    }
    usb().close(handle);
  }
  switch (result) {
    case LIBUSB_ERROR_ACCESS:
      opening.presence = Presence::forbidden;
      break;
    case LIBUSB_ERROR_BUSY:
      opening.presence = Presence::busy;
      break;
    case LIBUSB_ERROR_NO_DEVICE:
      break;  // Left while we looked.
    default:
      opening.presence = Presence::broken;
      opening.detail = said<MessageId::quoted>(usb().strerror(result));
  }
}

void UsbBus::waitForChange(std::int64_t until_ns) {
  if (impl_->context == nullptr) return sleepUntil(until_ns);
  const int before = impl_->plugs;
  do {
    timeval left = timeLeft(until_ns);
    if (usb().handle_events_timeout_completed(impl_->context, &left, nullptr) != 0) {
      sleepUntil(std::min(until_ns, monotonicNs() + kMs));
    }
  } while (impl_->plugs == before && monotonicNs() < until_ns);
}

std::int64_t UsbBus::now() {
  return monotonicNs();
}

std::int64_t UsbBus::slept() {
  timespec with_sleep{};
  clock_gettime(CLOCK_BOOTTIME, &with_sleep);
  const std::int64_t boot_ns = with_sleep.tv_sec * 1'000'000'000 + with_sleep.tv_nsec;
  // The clocks are read one after the other: whole seconds only.
  return (boot_ns - monotonicNs() + 500 * kMs) / 1'000'000'000 * 1'000'000'000;
}

FalconChoice settled(const FalconChoice& choice) {
  if (!choice.any()) return choice;
  const std::vector<SeenFalcon> there = seenFalcons();
  return there.size() == 1 ? shortestChoice(there.front(), there) : choice;
}

std::vector<SeenFalcon> seenFalcons() {
  libusb_context* context = nullptr;
  if (!usb().problem.empty() || usb().init(&context) != 0) return {};
  std::vector<SeenFalcon> there;
  {
    const DeviceList list(context);
    for (libusb_device* device : list.devices()) {
      if (isFalcon(device)) there.push_back(seen(device));
    }
  }
  usb().exit(context);
  std::sort(there.begin(), there.end(),
            [](const SeenFalcon& a, const SeenFalcon& b) { return a.port < b.port; });
  return there;
}

std::string libusbProblem() {
  return usb().problem;
}

std::string libusbVersion() {
  if (!usb().problem.empty()) return "not installed";
  const libusb_version* const version = usb().get_version();
  return std::to_string(version->major) + "." + std::to_string(version->minor) + "." +
         std::to_string(version->micro);
}

}  // namespace relievo::falcon
