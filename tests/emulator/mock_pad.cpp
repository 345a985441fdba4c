// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/mock_pad.h"

#include <sys/ioctl.h>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>

#include "haptics/rt/realtime_thread.h"

namespace relievo::emulator {

namespace {
constexpr int kBits = 8 * sizeof(long);

/// As the kernel writes the bits of its "capabilities".
std::string words(const std::vector<int>& bits) {
  std::vector<unsigned long> all(1);
  for (const int bit : bits) {
    const auto place = static_cast<std::size_t>(bit / kBits);
    if (all.size() <= place) all.resize(place + 1);
    all[place] |= 1UL << (bit % kBits);
  }
  std::string text;
  for (auto word = all.rbegin(); word != all.rend(); ++word) {
    std::array<char, 32> hex{};
    std::snprintf(hex.data(), hex.size(), "%lx", *word);
    text += (text.empty() ? "" : " ") + std::string(hex.data());
  }
  return text;
}

struct Pad {
  std::string node, file;            // "/dev/input/event3"; where the testbed keeps it.
  std::vector<std::string> devices;  // Innermost first.
  int pipe = -1;
  bool gone = false, has_effect = false;
  std::vector<int> down;
  std::vector<RumbleCall> calls;
};
}  // namespace

struct MockPad::Impl {
  UMockdevTestbed* testbed = umockdev_testbed_new();
  UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
  mutable std::mutex lock;  // umockdev answers in a thread of its own.
  std::map<int, Pad> pads;
  int next = 0;

  Pad& padOf(UMockdevIoctlClient* client) {
    const std::string node = umockdev_ioctl_client_get_devnode(client);
    for (auto& [number, pad] : pads) {
      if (pad.node == node) return pad;
    }
    throw std::runtime_error("no pad has that node");
  }

  static gboolean onIoctl(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, void* self) {
    auto& impl = *static_cast<Impl*>(self);
    const std::lock_guard held(impl.lock);
    Pad& pad = impl.padOf(client);
    const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
    if (pad.gone) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return TRUE;
    }
    UMockdevIoctlData* const given = umockdev_ioctl_client_get_arg(client);
    if (request == static_cast<unsigned>(EVIOCSFF)) {
      UMockdevIoctlData* data = umockdev_ioctl_data_resolve(given, 0, sizeof(ff_effect), nullptr);
      ff_effect effect{};
      std::memcpy(&effect, data->data, sizeof effect);
      RumbleCall call{RumbleCall::What::upload, monotonicNs()};
      call.is_new = effect.id == -1;
      call.length_ms = effect.replay.length;
      call.strong = effect.u.rumble.strong_magnitude;
      call.weak = effect.u.rumble.weak_magnitude;
      pad.calls.push_back(call);
      effect.id = 0;
      std::memcpy(data->data, &effect, sizeof effect);
      umockdev_ioctl_client_complete(client, 0, 0);
      umockdev_ioctl_data_unref(data);
      return TRUE;
    }
    constexpr std::size_t kKeyBytes = KEY_CNT / 8;
    if (request == static_cast<unsigned>(EVIOCGKEY(kKeyBytes))) {
      UMockdevIoctlData* data = umockdev_ioctl_data_resolve(given, 0, kKeyBytes, nullptr);
      std::memset(data->data, 0, kKeyBytes);
      for (const int key : pad.down) {
        data->data[key / 8] = static_cast<unsigned char>(data->data[key / 8] | 1U << (key % 8));
      }
      umockdev_ioctl_client_complete(client, kKeyBytes, 0);
      umockdev_ioctl_data_unref(data);
      return TRUE;
    }
    umockdev_ioctl_client_complete(client, -1, EINVAL);
    return TRUE;
  }

  static gboolean onWrite(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, void* self) {
    auto& impl = *static_cast<Impl*>(self);
    const std::lock_guard held(impl.lock);
    Pad& pad = impl.padOf(client);
    UMockdevIoctlData* const given = umockdev_ioctl_client_get_arg(client);
    input_event event{};
    if (pad.gone || static_cast<std::size_t>(given->data_len) < sizeof event) {
      umockdev_ioctl_client_complete(client, -1, pad.gone ? ENODEV : EINVAL);
      return TRUE;
    }
    std::memcpy(&event, given->data, sizeof event);
    if (event.type == EV_FF) {
      pad.calls.push_back(
          {event.value != 0 ? RumbleCall::What::play : RumbleCall::What::stop, monotonicNs()});
    }
    umockdev_ioctl_client_complete(client, sizeof event, 0);
    return TRUE;
  }

  static gboolean onRead(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, void* self) {
    auto& impl = *static_cast<Impl*>(self);
    const std::lock_guard held(impl.lock);
    if (!impl.padOf(client).gone) return FALSE;  // The pipe has the events.
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return TRUE;
  }

  void send(int number, int type, int code, int value) {
    input_event event{};
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    const Pad& pad = pads.at(number);
    if (write(pad.pipe, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) {
      throw std::runtime_error("an event was not taken");
    }
  }
};

MockPad::MockPad() : impl_(std::make_unique<Impl>()) {
  g_signal_connect(impl_->handler, "handle-ioctl", G_CALLBACK(&Impl::onIoctl), impl_.get());
  g_signal_connect(impl_->handler, "handle-write", G_CALLBACK(&Impl::onWrite), impl_.get());
  g_signal_connect(impl_->handler, "handle-read", G_CALLBACK(&Impl::onRead), impl_.get());
}

MockPad::~MockPad() {
  for (int pad = 0; pad < impl_->next; ++pad) {
    if (impl_->pads.at(pad).pipe >= 0) unplug(pad);
  }
  g_object_unref(impl_->testbed);
  g_object_unref(impl_->handler);
}

int MockPad::plugIn(const Kind& kind) {
  const int number = impl_->next++;
  const std::string n = std::to_string(number);
  const std::string bus = "/devices/pci0000:00/usb1/1-" + n;
  const std::string has = kind.has_hidraw ? bus + "/0003:1234:0001.000" + n : bus;
  const std::string input = has + "/input/input" + n, event = input + "/event" + n;
  std::vector<std::string> devices{event, input, bus};
  std::string text = "P: " + bus + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n\n";
  if (kind.has_hidraw) {
    const std::string raw = has + "/hidraw/hidraw" + n;
    text += "P: " + has + "\nE: SUBSYSTEM=hid\n\nP: " + raw + "\nE: SUBSYSTEM=hidraw\n\n";
    devices.insert(devices.end() - 1, {raw, has});
  }
  text += "P: " + input + "\nE: SUBSYSTEM=input\nA: name=" + kind.name +
          "\\n\nA: capabilities/key=" + words(kind.keys) + "\\n\nA: capabilities/ff=" +
          words(kind.rumbles ? std::vector<int>{FF_RUMBLE, FF_GAIN} : std::vector<int>()) +
          "\\n\n\nP: " + event + "\nN: input/event" + n +
          "\nE: SUBSYSTEM=input\nE: DEVNAME=/dev/input/event" + n + "\n";
  Pad pad;
  pad.node = "/dev/input/event" + n;
  pad.devices = devices;
  umockdev_testbed_attach_ioctl(impl_->testbed, pad.node.c_str(), impl_->handler, nullptr);
  if (umockdev_testbed_add_from_string(impl_->testbed, text.c_str(), nullptr) == 0) {
    throw std::runtime_error("umockdev refused the pad");
  }
  gchar* root = umockdev_testbed_get_root_dir(impl_->testbed);
  pad.file = std::string(root) + pad.node;
  g_free(root);
  std::filesystem::remove(pad.file);
  if (mkfifo(pad.file.c_str(), 0600) != 0) throw std::runtime_error("no fifo");
  pad.pipe = open(pad.file.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (pad.pipe < 0) throw std::runtime_error("no pipe");
  const std::lock_guard held(impl_->lock);
  impl_->pads[number] = pad;
  return number;
}

void MockPad::pullCable(int pad) {
  const std::lock_guard held(impl_->lock);
  impl_->pads.at(pad).gone = true;
}

void MockPad::unplug(int pad) {
  pullCable(pad);
  Pad& gone = impl_->pads.at(pad);
  for (const std::string& device : gone.devices) {
    umockdev_testbed_remove_device(impl_->testbed, ("/sys" + device).c_str());
  }
  std::error_code ignored;
  std::filesystem::remove(gone.file, ignored);
  close(gone.pipe);
  gone.pipe = -1;
}

void MockPad::forbid(int pad, bool forbidden) {
  const mode_t mode = forbidden ? 0 : 0600;
  if (chmod(impl_->pads.at(pad).file.c_str(), mode) != 0) throw std::runtime_error("no chmod");
}

void MockPad::press(int pad, int key, bool down) {
  impl_->send(pad, EV_KEY, key, down ? 1 : 0);
  impl_->send(pad, EV_SYN, SYN_REPORT, 0);
}

void MockPad::dropEvents(int pad, const std::vector<int>& down) {
  {
    const std::lock_guard held(impl_->lock);
    impl_->pads.at(pad).down = down;
  }
  impl_->send(pad, EV_SYN, SYN_DROPPED, 0);
  impl_->send(pad, EV_SYN, SYN_REPORT, 0);
}

std::vector<RumbleCall> MockPad::rumble(int pad) const {
  const std::lock_guard held(impl_->lock);
  return impl_->pads.at(pad).calls;
}

}  // namespace relievo::emulator
