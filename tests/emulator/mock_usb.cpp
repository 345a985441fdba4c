// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/mock_usb.h"

// Before linux/usbdevice_fs.h, whose requests it defines.
#include <sys/ioctl.h>

#include <glib-unix.h>
#include <linux/usbdevice_fs.h>
#include <sys/timerfd.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <future>
#include <list>
#include <mutex>
#include <string>
#include <utility>

#include "haptics/rt/realtime_thread.h"

namespace relievo::emulator {

namespace {
constexpr const char* kNode = "/dev/bus/usb/001/002";
std::string deviceAt(int number) {
  return "/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(number);
}
/// Longest time a request is held back. A held one keeps the client's other requests waiting.
constexpr std::int64_t kHoldNs = 5'000'000;
constexpr std::size_t kSetupBytes = 8;

std::string hex(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

/// @param number  of its port and, one more, of its node
std::string description(int number, const std::string& serial) {
  std::vector<std::uint8_t> descriptors = FalconEmulator::deviceDescriptor();
  const auto configuration = FalconEmulator::configurationDescriptor();
  descriptors.insert(descriptors.end(), configuration.begin(), configuration.end());
  const std::string node = std::to_string(number + 1);
  return "P: " + deviceAt(number) + "\nN: bus/usb/001/00" + node +
         "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: BUSNUM=001\nE: DEVNUM=00" + node +
         "\nE: DEVNAME=/dev/bus/usb/001/00" + node + "\nA: busnum=1\nA: devnum=" + node +
         "\nA: speed=12\nA: bConfigurationValue=1\n"
         "A: idVendor=0403\nA: idProduct=cb48\nA: serial=" +
         serial + "\nH: descriptors=" + hex(descriptors) + "\n";
}

/// Memory of the client's that an argument points to; null if the client has died meanwhile.
UMockdevIoctlData* memoryOf(UMockdevIoctlClient* client, gsize bytes) {
  // The argument is borrowed, what it resolves to is ours.
  return umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, bytes, nullptr);
}

/// Answers, unless nobody is there to hear.
void complete(UMockdevIoctlClient* client, glong result, int error) {
  if (umockdev_ioctl_client_get_connected(client) != 0) {
    umockdev_ioctl_client_complete(client, result, error);
  } else {
    umockdev_ioctl_client_abort(client);
  }
}

/// One transfer under way. Owns its two pieces of client memory.
struct Urb {
  UMockdevIoctlData* data = nullptr;
  UMockdevIoctlData* buffer = nullptr;
  bool done = false;

  usbdevfs_urb& urb() const { return *reinterpret_cast<usbdevfs_urb*>(data->data); }
  void finish(int status, std::size_t actual) {
    urb().status = status;
    urb().actual_length = static_cast<int>(actual);
    done = true;
  }
};
}  // namespace

struct MockUsb::Impl {
  UMockdevTestbed* testbed = umockdev_testbed_new();
  UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
  bool plugged = false, attached = false;

  UrgentMutex mutex;  // Between the test's thread and umockdev's.
  MockPortState state;
  MockPortCounts counts;
  std::shared_ptr<SharedFalcon> falcon;
  bool gone = false;
  GMainContext* context = nullptr;  // Of umockdev's thread, once it has called.

  // [umockdev's thread]
  std::list<Urb> urbs;
  UMockdevIoctlClient* held = nullptr;
  bool said_again = false;  // The last reap found nothing.
  int timer = timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK);
  GSource* timer_source = nullptr;

  gboolean handle(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client);
  void control(Urb& urb);
  void bulk(UMockdevIoctlClient* client);
  void reap(UMockdevIoctlClient* client);
  bool reapNow(UMockdevIoctlClient* client);
  void discard(UMockdevIoctlClient* client);
  void driver(UMockdevIoctlClient* client);
  void serve();
  void hold(UMockdevIoctlClient* client);
  void release();
  void leave();
  void forget(std::list<Urb>::iterator urb);

  static gboolean onIoctl(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, void* self) {
    return static_cast<Impl*>(self)->handle(client);
  }
  static gboolean onTimer(gint descriptor, GIOCondition /*condition*/, void* self) {
    std::uint64_t times = 0;
    if (read(descriptor, &times, sizeof times) > 0) static_cast<Impl*>(self)->release();
    return G_SOURCE_CONTINUE;
  }
};

void MockUsb::Impl::forget(std::list<Urb>::iterator urb) {
  if (urb->buffer != nullptr) umockdev_ioctl_data_unref(urb->buffer);
  umockdev_ioctl_data_unref(urb->data);
  urbs.erase(urb);
}

gboolean MockUsb::Impl::handle(UMockdevIoctlClient* client) {
  const std::lock_guard lock(mutex);
  if (context == nullptr) beUrgentAsADevice();
  context = g_main_context_get_thread_default();
  const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
  switch (request) {
    case static_cast<unsigned>(USBDEVFS_SUBMITURB):
      submit(client);
      return TRUE;
    case static_cast<unsigned>(USBDEVFS_REAPURB):
    case static_cast<unsigned>(USBDEVFS_REAPURBNDELAY):
      reap(client);
      return TRUE;
    case static_cast<unsigned>(USBDEVFS_DISCARDURB):
      discard(client);
      return TRUE;
    case static_cast<unsigned>(USBDEVFS_BULK):
      bulk(client);
      return TRUE;
    case static_cast<unsigned>(USBDEVFS_GET_CAPABILITIES): {
      // The first request after opening: what an earlier client left is void.
      while (!urbs.empty()) forget(urbs.begin());
      said_again = false;
      UMockdevIoctlData* data = memoryOf(client, sizeof(std::uint32_t));
      if (data == nullptr) return complete(client, -1, EFAULT), TRUE;
      const std::uint32_t capabilities =
          USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      std::memcpy(data->data, &capabilities, sizeof capabilities);
      complete(client, 0, 0);
      umockdev_ioctl_data_unref(data);
      return TRUE;
    }
    case static_cast<unsigned>(USBDEVFS_CLAIMINTERFACE):
      if (gone) {
        complete(client, -1, ENODEV);
      } else if (state.claimed_by_other || state.kernel_driver) {
        complete(client, -1, EBUSY);
      } else {
        complete(client, 0, 0);
      }
      return TRUE;
    case static_cast<unsigned>(USBDEVFS_RELEASEINTERFACE):
    case static_cast<unsigned>(USBDEVFS_CLEAR_HALT):
    case static_cast<unsigned>(USBDEVFS_RESET):
    case static_cast<unsigned>(USBDEVFS_SETCONFIGURATION):
    case static_cast<unsigned>(USBDEVFS_SETINTERFACE):
      complete(client, 0, 0);
      return TRUE;
    default:
      driver(client);
      return TRUE;
  }
}

void MockUsb::Impl::driver(UMockdevIoctlClient* client) {
  const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
  if (request == static_cast<unsigned>(USBDEVFS_GETDRIVER)) {
    if (!state.kernel_driver) {
      complete(client, -1, ENODATA);
      return;
    }
    UMockdevIoctlData* data = memoryOf(client, sizeof(usbdevfs_getdriver));
    if (data == nullptr) return complete(client, -1, EFAULT);
    std::strcpy(reinterpret_cast<usbdevfs_getdriver*>(data->data)->driver, "ftdi_sio");
    complete(client, 0, 0);
    umockdev_ioctl_data_unref(data);
  } else if (request == static_cast<unsigned>(USBDEVFS_DISCONNECT_CLAIM)) {
    if (state.claimed_by_other) {
      complete(client, -1, EBUSY);
      return;
    }
    state.kernel_driver = false;
    ++counts.detached;
    complete(client, 0, 0);
  } else if (request == static_cast<unsigned>(USBDEVFS_IOCTL)) {
    state.kernel_driver = true;  // Only USBDEVFS_CONNECT comes this way.
    ++counts.attached;
    complete(client, 0, 0);
  } else {
    complete(client, -1, ENOTTY);
  }
}

void MockUsb::Impl::submit(UMockdevIoctlClient* client) {
  if (gone) {
    complete(client, -1, ENODEV);
    return;
  }
  ++counts.submits;
  Urb urb;
  urb.data = memoryOf(client, sizeof(usbdevfs_urb));
  if (urb.data == nullptr) return complete(client, -1, EFAULT);
  const int length = urb.urb().buffer_length;
  if (length > 0) {
    urb.buffer = umockdev_ioctl_data_resolve(urb.data, offsetof(usbdevfs_urb, buffer),
                                             static_cast<gsize>(length), nullptr);
    if (urb.buffer == nullptr) {
      umockdev_ioctl_data_unref(urb.data);
      return complete(client, -1, EFAULT);
    }
  }
  if (urb.urb().type == USBDEVFS_URB_TYPE_CONTROL) control(urb);
  urbs.push_back(urb);
  complete(client, 0, 0);
  serve();
  if (held != nullptr &&
      std::any_of(urbs.begin(), urbs.end(), [](const Urb& u) { return u.done; })) {
    hold(nullptr);
  }
}

void MockUsb::Impl::control(Urb& urb) {
  std::array<std::uint8_t, kSetupBytes> setup{};
  if (urb.buffer == nullptr || urb.urb().buffer_length < static_cast<int>(kSetupBytes)) {
    urb.finish(-EINVAL, 0);
    return;
  }
  std::memcpy(setup.data(), urb.buffer->data, setup.size());
  const std::span<std::uint8_t> answer(
      urb.buffer->data + kSetupBytes,
      static_cast<std::size_t>(urb.urb().buffer_length) - kSetupBytes);
  const auto bytes =
      falcon->with([&](FalconEmulator& f) { return f.control(setup, answer, monotonicNs()); });
  // The length does not count the eight bytes of the request.
  urb.finish(bytes ? 0 : -EPIPE, bytes.value_or(0));
}

void MockUsb::Impl::bulk(UMockdevIoctlClient* client) {
  UMockdevIoctlData* data = memoryOf(client, sizeof(usbdevfs_bulktransfer));
  if (data == nullptr) return complete(client, -1, EFAULT);
  const auto& transfer = *reinterpret_cast<usbdevfs_bulktransfer*>(data->data);
  UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(
      data, offsetof(usbdevfs_bulktransfer, data), transfer.len, nullptr);
  if (buffer == nullptr) {
    umockdev_ioctl_data_unref(data);
    return complete(client, -1, EFAULT);
  }
  const bool taken = !gone && transfer.ep == 0x02 && falcon->with([&](FalconEmulator& f) {
    return f.bulkOut({buffer->data, transfer.len}, monotonicNs());
  });
  complete(client, taken ? static_cast<glong>(transfer.len) : -1,
           taken  ? 0
           : gone ? ENODEV
                  : ETIMEDOUT);
  umockdev_ioctl_data_unref(buffer);
  umockdev_ioctl_data_unref(data);
}

void MockUsb::Impl::serve() {
  const std::int64_t now = monotonicNs();
  for (Urb& urb : urbs) {
    if (urb.done) continue;
    if (gone) {
      urb.finish(-ENODEV, 0);
      continue;
    }
    if (urb.urb().type != USBDEVFS_URB_TYPE_BULK) continue;
    const auto length = static_cast<std::size_t>(urb.urb().buffer_length);
    falcon->with([&](FalconEmulator& f) {
      if (urb.urb().endpoint == 0x02) {
        if (f.bulkOut({urb.buffer->data, length}, now)) urb.finish(0, length);
        return;
      }
      if (f.failsToRead()) {
        urb.finish(-EPROTO, 0);
        return;
      }
      const auto packet = f.bulkIn(now);
      if (!packet) return;
      const std::size_t bytes = std::min(packet->size(), length);
      std::memcpy(urb.buffer->data, packet->data(), bytes);
      urb.finish(packet->size() > length ? -EOVERFLOW : 0, bytes);
    });
  }
}

bool MockUsb::Impl::reapNow(UMockdevIoctlClient* client) {
  serve();
  const auto done = std::find_if(urbs.begin(), urbs.end(), [](const Urb& urb) { return urb.done; });
  if (done == urbs.end()) return false;
  UMockdevIoctlData* slot = memoryOf(client, sizeof(void*));
  if (slot == nullptr) {
    complete(client, -1, EFAULT);
    return true;
  }
  umockdev_ioctl_data_set_ptr(slot, 0, done->data);  // Writes transfer and buffer back as well.
  complete(client, 0, 0);
  umockdev_ioctl_data_unref(slot);
  forget(done);
  said_again = false;
  return true;
}

void MockUsb::Impl::reap(UMockdevIoctlClient* client) {
  ++counts.reaps;
  if (reapNow(client)) return;
  if (gone) {
    complete(client, -1, ENODEV);
    return;
  }
  // libusb reaps until there is nothing more, so the first "nothing" must come at once. Its poll()
  // finds a mocked node always ready, so it would spin from then on: the second one is held.
  if (!said_again) {
    said_again = true;
    complete(client, -1, EAGAIN);
    return;
  }
  hold(client);
}

void MockUsb::Impl::hold(UMockdevIoctlClient* client) {
  if (client != nullptr) held = static_cast<UMockdevIoctlClient*>(g_object_ref(client));
  if (timer_source == nullptr) {
    timer_source = g_unix_fd_source_new(timer, G_IO_IN);
    g_source_set_callback(timer_source, G_SOURCE_FUNC(&Impl::onTimer), this, nullptr);
    // GLib's own timeouts are rounded to milliseconds.
    g_source_attach(timer_source, context);
  }
  const std::int64_t now = monotonicNs();
  std::int64_t until = now + kHoldNs;
  if (client == nullptr) {
    until = now + 1;
  } else if (!gone) {
    until = std::min(until, falcon->with([&](FalconEmulator& f) { return f.nextIn(now); }));
  }
  until = std::max(until, now + 1);
  const itimerspec when{
      .it_interval = {},
      .it_value = {.tv_sec = until / 1'000'000'000, .tv_nsec = until % 1'000'000'000}};
  timerfd_settime(timer, TFD_TIMER_ABSTIME, &when, nullptr);
}

void MockUsb::Impl::release() {
  const std::lock_guard lock(mutex);
  if (held == nullptr) return;
  UMockdevIoctlClient* client = std::exchange(held, nullptr);
  if (!reapNow(client)) complete(client, -1, gone ? ENODEV : EAGAIN);
  g_object_unref(client);
}

/// [test's thread] Nothing of this port runs on umockdev's thread any more. A source that outlived
/// its timer would be called for whatever file has the descriptor next, and take bytes from it that
/// somebody waits for.
void MockUsb::Impl::leave() {
  GMainContext* const where = [this] {
    const std::lock_guard lock(mutex);
    return context;
  }();
  if (where == nullptr) return;  // Nobody has asked for anything.
  std::promise<void> left;
  auto leave_there = [this, &left] {
    release();
    if (timer_source != nullptr) {
      g_source_destroy(timer_source);
      g_source_unref(std::exchange(timer_source, nullptr));
    }
    g_signal_handlers_disconnect_by_data(handler, this);
    left.set_value();
  };
  using Call = decltype(leave_there);
  g_main_context_invoke_full(
      where, G_PRIORITY_DEFAULT,
      [](void* call) -> gboolean {
        (*static_cast<Call*>(call))();
        return G_SOURCE_REMOVE;
      },
      &leave_there, nullptr);
  left.get_future().wait();
}

void MockUsb::Impl::discard(UMockdevIoctlClient* client) {
  UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
  gulong address = 0;
  std::memcpy(&address, arg->data, sizeof address);
  const auto found = std::find_if(urbs.begin(), urbs.end(), [address](const Urb& urb) {
    return !urb.done && urb.data->client_addr == address;
  });
  if (found == urbs.end()) {
    complete(client, -1, EINVAL);
    return;
  }
  found->finish(-ENOENT, 0);
  complete(client, 0, 0);
}

MockUsb::MockUsb() : impl_(std::make_unique<Impl>()) {
  g_signal_connect(impl_->handler, "handle-ioctl", G_CALLBACK(&Impl::onIoctl), impl_.get());
  umockdev_testbed_add_from_string(
      impl_->testbed,
      "P: /devices/pci0000:00/0000:00:14.0/usb1\n"
      "N: bus/usb/001/001\n"
      "E: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
      "A: busnum=1\nA: devnum=1\nA: speed=480\n"
      "H: descriptors=12010002090001406b1d020000060302010109021900010100"
      "e0000904000001090000000705810304000c\n",
      nullptr);
}

MockUsb::~MockUsb() {
  unplug();
  impl_->leave();
  if (impl_->attached) umockdev_testbed_detach_ioctl(impl_->testbed, kNode, nullptr);
  g_object_unref(impl_->testbed);
  g_object_unref(impl_->handler);
  close(impl_->timer);
}

void MockUsb::plugIn(std::shared_ptr<SharedFalcon> falcon) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->falcon = std::move(falcon);
    impl_->falcon->with([](FalconEmulator& f) { f.plugIn(); });
    impl_->gone = false;
  }
  // Before the node is there: whoever hears of it opens it at once. Once for all: a client that has
  // the node open when it is pulled still asks, and is told that the device is gone.
  if (!std::exchange(impl_->attached, true)) {
    umockdev_testbed_attach_ioctl(impl_->testbed, kNode, impl_->handler, nullptr);
  }
  umockdev_testbed_add_from_string(impl_->testbed, description(1, kSerial).c_str(), nullptr);
  umockdev_testbed_uevent(impl_->testbed, ("/sys" + deviceAt(1)).c_str(), "add");
  impl_->plugged = true;
}

void MockUsb::plugInAnother(const std::string& serial) {
  umockdev_testbed_add_from_string(impl_->testbed, description(2, serial).c_str(), nullptr);
  umockdev_testbed_uevent(impl_->testbed, ("/sys" + deviceAt(2)).c_str(), "add");
}

void MockUsb::forbid() {
  const std::filesystem::path root = umockdev_testbed_get_root_dir(impl_->testbed);
  std::filesystem::permissions(root.string() + kNode, std::filesystem::perms::none);
  // Other accounts see the rest of the testbed as they see the real /sys, and hear its events. The
  // preloaded library calls for the node's requests even where opening it failed.
  for (const std::string& part : {std::string(), std::string("/ioctl") + kNode}) {
    std::filesystem::permissions(root.string() + part, std::filesystem::perms::all);
  }
}

void MockUsb::unplug() {
  if (!impl_->plugged) return;
  impl_->plugged = false;
  // The node goes first: whoever learns of it by a failing transfer looks for it at once, and would
  // find half a device.
  umockdev_testbed_uevent(impl_->testbed, ("/sys" + deviceAt(1)).c_str(), "remove");
  umockdev_testbed_remove_device(impl_->testbed, ("/sys" + deviceAt(1)).c_str());
  const std::lock_guard lock(impl_->mutex);
  impl_->gone = true;
  impl_->falcon->with([](FalconEmulator& f) { f.unplug(); });
}

bool MockUsb::works() {
  return umockdev_in_mock_environment() != 0;
}

void MockUsb::set(const MockPortState& state) {
  const std::lock_guard lock(impl_->mutex);
  impl_->state = state;
}

MockPortCounts MockUsb::counts() {
  const std::lock_guard lock(impl_->mutex);
  return impl_->counts;
}

}  // namespace relievo::emulator
