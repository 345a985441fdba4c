// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/plugin_devices.h"

#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "haptics/device/foreign/ask_host.h"
#include "haptics/device/foreign/plugin_files.h"
#include "haptics/device/haply/device_search.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/device_catalog.h"

namespace relievo {

namespace {
constexpr int kLookMs = 50;

bool isReady(const auto& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// Asks in a session that only listens, beside the one that may drive the device. [worker]
std::vector<PluginDevice> seenByHaply(const Task& task) {
  std::vector<PluginDevice> devices;
  if (!haply::isServiceThere()) return devices;
  const std::unique_ptr<haply::Service> service = haply::inverseService(haply::serviceAddress());
  const haply::Inventory inventory = haply::lookAround(*service, task.stop);
  for (const haply::ServiceDevice& seen : inventory.seen.told()) {
    devices.push_back({QString::fromStdString(haply::idOf(seen.id.view())),
                       QString::fromStdString(haply::nameOf(seen.type.view(), seen.id.view()))});
  }
  return devices;
}

/// One that cannot be asked has none; `relievo devices` says why. [worker]
std::vector<PluginDevice> asked(const Task& task) {
  std::vector<PluginDevice> devices = seenByHaply(task);
  for (const foreign::PluginFile& file : foreign::pluginFiles()) {
    if (!file.trusted) continue;
    try {
      for (const foreign::SeenDevice& seen :
           foreign::scanPlugin(foreign::trustedImage(file), task).devices) {
        const std::string id = std::string(foreign::kPluginKind) + ":" + file.name + "/" + seen.id;
        devices.push_back({QString::fromStdString(id), QString::fromStdString(seen.name)});
      }
    } catch (const Error&) {
      if (task.stop.stop_requested()) return {};
    }
  }
  return devices;
}
}  // namespace

PluginDevices::PluginDevices() {
  connect(&timer_, &QTimer::timeout, this, &PluginDevices::take);
}

PluginDevices::~PluginDevices() {
  stop_.request_stop();
  if (asking_.valid()) asking_.wait();
}

void PluginDevices::look() {
  if (asking_.valid()) return;
  asking_ = std::async(std::launch::async, [task = Task{stop_.get_token(), {}}] {
    try {
      return asked(task);
    } catch (const Error&) {
      return std::vector<PluginDevice>();
    }
  });
  timer_.start(kLookMs);
}

void PluginDevices::take() {
  if (!asking_.valid() || !isReady(asking_)) return;
  timer_.stop();
  Q_EMIT found(asking_.get());
}

DeviceOpening::DeviceOpening(const std::string& id)
    : device_(makeDevice(id)),
      foreign_(dynamic_cast<foreign::ForeignDevice*>(device_.get())),
      name_(QString::fromStdString(device_->info().name)),
      opening_(std::async(std::launch::async, [device = device_.get()] { device->open(); })) {}

DeviceOpening::~DeviceOpening() {
  if (foreign_ != nullptr && opening_.valid()) foreign_->giveUp();
  if (opening_.valid()) opening_.wait();
}

bool DeviceOpening::isDone() const {
  return isReady(opening_);
}

std::unique_ptr<Device> DeviceOpening::take() {
  opening_.get();
  return std::move(device_);
}

bool isPluginDevice(const std::string& id) {
  return id.starts_with(std::string(foreign::kPluginKind) + ":");
}

}  // namespace relievo
