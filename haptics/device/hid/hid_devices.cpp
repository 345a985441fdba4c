// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/hid/hid_devices.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <list>
#include <optional>
#include <set>

#include "core/base/failure.h"
#include "core/base/late_library.h"
#include "haptics/device/hid/hidapi_functions.h"

namespace relievo::hid {

namespace {
HidapiFunctions loadedHidapi() {
  LateLibrary library("libhidapi-hidraw.so.0");
  HidapiFunctions functions;
#define RELIEVO_FIND(name) library.find("hid_" #name, functions.name);
  RELIEVO_HIDAPI_FUNCTIONS(RELIEVO_FIND)
#undef RELIEVO_FIND
  functions.problem = library.problem();
  return functions;
}
}  // namespace

const HidapiFunctions& hidapi() {
  static const HidapiFunctions kFunctions = loadedHidapi();
  return kFunctions;
}

namespace {
constexpr std::uint16_t kGenericDesktop = 1, kJoystick = 4, kGamepad = 5, kMultiAxis = 8;
constexpr std::size_t kReportBytes = 64;
constexpr int kMostReportsPerPoll = 256;

std::string utf8(const wchar_t* text) {
  std::string narrow;
  for (; text != nullptr && *text != L'\0'; ++text) {
    narrow += *text > 0 && *text < 128 ? static_cast<char>(*text) : '?';
  }
  return narrow;
}

/// hidapi 0.13 does not hand it out; sysfs does.
std::vector<std::uint8_t> reportDescriptor(const std::string& node) {
  const std::string name = std::filesystem::path(node).filename();
  std::ifstream stream("/sys/class/hidraw/" + name + "/device/report_descriptor", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct OpenDevice {
  std::string path, name;
  hid_device* handle = nullptr;
  bool space_mouse = false;
  std::vector<ButtonField> fields;
  std::size_t button_count = 0;
  std::uint32_t buttons = 0;  // The Falcon's, as told last.
  CapReports cap;

  std::uint32_t asFalcon(std::uint32_t raw) const {
    if (space_mouse) return (raw & 1U) << 3U | (raw >> 1U & 1U);
    if (button_count == 1) return (raw & 1U) << 2U;
    return raw & 0b1111U;
  }
};

/// hidapi does not tell why it could not open a node.
bool isRefused(const char* node) {
  const int descriptor = ::open(node, O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return errno == EACCES || errno == EPERM;
  ::close(descriptor);
  return false;
}

struct RefusedDevice {
  std::string path, name;
  int looks = 0;
  bool seen = true;  // By the rescan that is going on.
};

void tellEdges(std::uint32_t before, std::uint32_t after, std::vector<ButtonEdge>& edges) {
  for (std::uint8_t i = 0; i < 4; ++i) {
    const bool was = (before >> i & 1U) != 0, is = (after >> i & 1U) != 0;
    if (was != is) edges.push_back({i, is});
  }
}
}  // namespace

namespace {
/// What is plugged in; new ones are opened.
struct Sight {
  std::set<std::string> there;
  std::list<OpenDevice> opened, refused;
};

void open(const hid_device_info& info, Sight& sight) {
  OpenDevice device;
  device.path = info.path;
  device.name = utf8(info.product_string);
  if (device.name.empty()) device.name = "HID device";
  device.space_mouse = isSpaceMouse(info.vendor_id, info.product_id);
  if (!device.space_mouse) {
    device.fields = buttonFields(reportDescriptor(device.path));
    for (const ButtonField& field : device.fields) device.button_count += field.count;
    if (device.button_count == 0) return;  // Nothing to press.
  }
  device.handle = hidapi().open_path(info.path);
  if (device.handle == nullptr) {
    if (isRefused(info.path)) sight.refused.push_back(std::move(device));
    return;
  }
  hidapi().set_nonblocking(device.handle, 1);
  sight.opened.push_back(std::move(device));
}

/// [worker] @param known  paths of those that are open already
Sight lookAround(const std::set<std::string>& known) {
  Sight sight;
  hid_device_info* list = hidapi().enumerate(0, 0);
  for (const hid_device_info* info = list; info != nullptr; info = info->next) {
    const bool wanted =
        info->usage_page == kGenericDesktop &&
        (info->usage == kJoystick || info->usage == kGamepad || info->usage == kMultiAxis);
    if (!wanted || info->path == nullptr) continue;
    const bool is_new = sight.there.insert(info->path).second && !known.contains(info->path);
    if (is_new) open(*info, sight);
  }
  hidapi().free_enumeration(list);
  return sight;
}
}  // namespace

struct HidDevices::Impl {
  std::list<OpenDevice> devices;
  std::list<RefusedDevice> refused;
  std::future<Sight> looking;

  void close(OpenDevice& device, HidEvents& news) {
    tellEdges(device.buttons, 0, news.edges);
    news.left.push_back(device.name);
    hidapi().close(device.handle);
  }
  void take(Sight sight, HidEvents& news);
  void refuse(const OpenDevice& device, HidEvents& news);
  static bool read(OpenDevice& device, HidEvents& news, double now_s);
};

HidDevices::HidDevices() : impl_(std::make_unique<Impl>()) {
  const std::string& problem = hidapi().problem;
  if (!problem.empty()) throw failure<MessageId::hid_library_missing>(problem);
  if (hidapi().init() != 0) throw failure<MessageId::hid_unusable>();
}

HidDevices::~HidDevices() {
  HidEvents ignored;
  if (impl_->looking.valid()) impl_->take(impl_->looking.get(), ignored);
  for (const OpenDevice& device : impl_->devices) hidapi().close(device.handle);
}

void HidDevices::Impl::refuse(const OpenDevice& device, HidEvents& news) {
  auto known = std::find_if(refused.begin(), refused.end(),
                            [&device](const RefusedDevice& r) { return r.path == device.path; });
  if (known == refused.end()) known = refused.insert(known, {device.path, device.name});
  known->seen = true;
  constexpr int kSureLooks = 2;
  if (++known->looks == kSureLooks) news.forbidden.push_back(known->name);
}

void HidDevices::Impl::take(Sight sight, HidEvents& news) {
  for (RefusedDevice& device : refused) device.seen = false;
  for (const OpenDevice& device : sight.refused) refuse(device, news);
  std::erase_if(refused, [](const RefusedDevice& device) { return !device.seen; });
  for (auto device = devices.begin(); device != devices.end();) {
    if (sight.there.contains(device->path)) {
      ++device;
      continue;
    }
    close(*device, news);
    device = devices.erase(device);
  }
  for (const OpenDevice& device : sight.opened) news.arrived.push_back(device.name);
  devices.splice(devices.end(), sight.opened);
}

void HidDevices::look() {
  if (impl_->looking.valid()) return;
  std::set<std::string> known;
  for (const OpenDevice& device : impl_->devices) known.insert(device.path);
  impl_->looking =
      std::async(std::launch::async, [known = std::move(known)] { return lookAround(known); });
}

void HidDevices::rescan(HidEvents& news) {
  look();
  impl_->take(impl_->looking.get(), news);
}

bool HidDevices::Impl::read(OpenDevice& device, HidEvents& news, double now_s) {
  std::array<std::uint8_t, kReportBytes> bytes{};
  for (int i = 0; i < kMostReportsPerPoll; ++i) {
    const int size = hidapi().read(device.handle, bytes.data(), bytes.size());
    if (size < 0) return false;
    if (size == 0) return true;
    const std::span<const std::uint8_t> report(bytes.data(), static_cast<std::size_t>(size));
    std::optional<std::uint32_t> raw;
    if (device.space_mouse) {
      device.cap.take(report, now_s);
      raw = capButtons(report);
    } else {
      raw = buttonsOf(report, device.fields);
    }
    if (!raw) continue;
    const std::uint32_t buttons = device.asFalcon(*raw);
    tellEdges(device.buttons, buttons, news.edges);
    device.buttons = buttons;
  }
  return true;
}

void HidDevices::poll(HidEvents& news, double now_s) {
  if (impl_->looking.valid() &&
      impl_->looking.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    impl_->take(impl_->looking.get(), news);
  }
  for (auto device = impl_->devices.begin(); device != impl_->devices.end();) {
    if (Impl::read(*device, news, now_s)) {
      const CapMotion motion = device->cap.motion(now_s);
      if (motion != CapMotion{}) news.motion = motion;  // A second one may be at rest.
      ++device;
      continue;
    }
    impl_->close(*device, news);
    device = impl_->devices.erase(device);
  }
}

std::vector<std::string> HidDevices::names() const {
  std::vector<std::string> names;
  for (const OpenDevice& device : impl_->devices) names.push_back(device.name);
  return names;
}

std::vector<std::string> HidDevices::forbidden() const {
  std::vector<std::string> names;
  for (const RefusedDevice& device : impl_->refused) names.push_back(device.name);
  return names;
}

std::string hidapiVersion() {
  return hidapi().problem.empty() ? hidapi().version_str() : "not installed";
}

}  // namespace relievo::hid
