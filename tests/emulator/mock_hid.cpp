// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/mock_hid.h"

// Before linux/hidraw.h, whose requests it defines.
#include <sys/ioctl.h>

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <thread>

namespace relievo::emulator {

namespace {
struct Node {
  std::string name, file;            // "/dev/hidraw0"; where the testbed keeps it.
  std::vector<std::string> devices;  // Innermost first.
  int pipe = -1;
};

template <class... Values>
std::string format(const char* text, Values... values) {
  std::array<char, 2000> line{};
  std::snprintf(line.data(), line.size(), text, values...);
  return line.data();
}
}  // namespace

struct MockHid::Impl {
  UMockdevTestbed* testbed = umockdev_testbed_new();
  UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
  std::map<int, Node> nodes;
  std::map<int, std::jthread> held;  // By slot; each writes into its node's pipe.
  int next_node = 0;  // A number is never used twice: umockdev does not forget nodes.

  /// hidapi asks for the size of the report descriptor when it opens, and for no more.
  static gboolean onIoctl(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client,
                          void* /*self*/) {
    const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
    if (request != static_cast<unsigned>(HIDIOCGRDESCSIZE)) {
      umockdev_ioctl_client_complete(client, -1, EINVAL);
      return TRUE;
    }
    UMockdevIoctlData* data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(int), nullptr);
    if (data == nullptr) return FALSE;
    constexpr int kAnySize = 32;
    std::memcpy(data->data, &kAnySize, sizeof kAnySize);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(data);
    return TRUE;
  }
};

MockHid::MockHid() : impl_(std::make_unique<Impl>()) {
  g_signal_connect(impl_->handler, "handle-ioctl", G_CALLBACK(&Impl::onIoctl), impl_.get());
}

MockHid::~MockHid() {
  while (!impl_->nodes.empty()) unplug(impl_->nodes.begin()->first);
  g_object_unref(impl_->testbed);
  g_object_unref(impl_->handler);
}

void MockHid::plugIn(int slot, std::uint16_t vendor, std::uint16_t product, const std::string& name,
                     const std::vector<std::uint8_t>& report_descriptor) {
  const int number = impl_->next_node++;
  std::string hex;
  for (const std::uint8_t byte : report_descriptor) hex += format("%02x", byte);
  const std::string usb = format("/devices/pci0000:00/usb1/1-%d", number + 1);
  const std::string interface = usb + format("/1-%d:1.0", number + 1);
  const std::string id = format("0003:%04X:%04X.%04X", vendor, product, number + 1);
  const std::string hid = interface + "/" + id;
  const std::string raw = hid + format("/hidraw/hidraw%d", number);
  const std::string text =
      "P: " + usb + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n" +
      format(
          "A: idVendor=%04x\nA: idProduct=%04x\nA: manufacturer=Maker\nA: product=%s\n"
          "A: bcdDevice=0100\nA: serial=7\n\n",
          vendor, product, name.c_str()) +
      "P: " + interface +
      "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\n\n" + "P: " + hid +
      "\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\n" +
      format("E: HID_ID=0003:%08X:%08X\nE: HID_NAME=%s\nE: HID_UNIQ=7\nE: HID_PHYS=usb/input0\n",
             vendor, product, name.c_str()) +
      "H: report_descriptor=" + hex + "\n\n" + "P: " + raw + format("\nN: hidraw%d\n", number) +
      "E: SUBSYSTEM=hidraw\n" +
      format("E: DEVNAME=/dev/hidraw%d\nE: MAJOR=240\nE: MINOR=%d\n", number, number) +
      // hidapi reads what the link leads to; without it nothing is found.
      "L: device=../../../" + id + "\n";
  const std::string name_of_node = format("/dev/hidraw%d", number);
  umockdev_testbed_attach_ioctl(impl_->testbed, name_of_node.c_str(), impl_->handler, nullptr);
  if (umockdev_testbed_add_from_string(impl_->testbed, text.c_str(), nullptr) == 0) {
    throw std::runtime_error("umockdev refused the device");
  }
  // The default node is a terminal, which runs reports together; a packet pipe does not.
  gchar* root = umockdev_testbed_get_root_dir(impl_->testbed);
  Node node{name_of_node, std::string(root) + name_of_node, {raw, hid, interface, usb}, -1};
  g_free(root);
  std::filesystem::remove(node.file);
  if (mkfifo(node.file.c_str(), 0600) != 0) throw std::runtime_error("no fifo");
  node.pipe = open(node.file.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (node.pipe < 0 || fcntl(node.pipe, F_SETFL, O_DIRECT | O_NONBLOCK) != 0) {
    throw std::runtime_error("no packet pipe");
  }
  impl_->nodes[slot] = node;
}

void MockHid::unplug(int slot) {
  impl_->held.erase(slot);
  const Node node = impl_->nodes.at(slot);
  impl_->nodes.erase(slot);
  for (const std::string& device : node.devices) {
    umockdev_testbed_remove_device(impl_->testbed, ("/sys" + device).c_str());
  }
  umockdev_testbed_detach_ioctl(impl_->testbed, node.name.c_str(), nullptr);
  std::error_code ignored;
  std::filesystem::remove(node.file, ignored);
  close(node.pipe);
}

void MockHid::forbid(int slot, bool forbidden) {
  const mode_t mode = forbidden ? 0 : 0600;
  if (chmod(impl_->nodes.at(slot).file.c_str(), mode) != 0) throw std::runtime_error("no chmod");
}

void MockHid::send(int slot, const std::vector<std::uint8_t>& report) {
  impl_->held.erase(slot);
  const Node& node = impl_->nodes.at(slot);
  if (write(node.pipe, report.data(), report.size()) != static_cast<ssize_t>(report.size())) {
    throw std::runtime_error("a report was not taken");
  }
}

void MockHid::hold(int slot, const std::vector<std::uint8_t>& report) {
  send(slot, report);
  const int pipe = impl_->nodes.at(slot).pipe;
  impl_->held[slot] = std::jthread([pipe, report](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(16));
      int waiting = 0;
      // As in the kernel, what nobody reads is dropped in the end.
      const bool is_read = ioctl(pipe, FIONREAD, &waiting) == 0 && waiting == 0;
      if (is_read && write(pipe, report.data(), report.size()) < 0) return;
    }
  });
}

}  // namespace relievo::emulator
