// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/haply_device.h"

#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::haply {

namespace {
constexpr int kPriority = 75;  // Below the loop and its watchdog, as every device's thread.
}

HaplyDevice::HaplyDevice(std::unique_ptr<Service> service, std::string chosen)
    : service_(std::move(service)), chosen_(std::move(chosen)) {
  takeLimits({}, chosen_);  // Until it is open: the least that any of them has.
}

HaplyDevice::~HaplyDevice() {
  close();
}

void HaplyDevice::takeLimits(std::string_view type, std::string_view id) {
  info_ = limitsOf(type);
  info_.id = idOf(id);
  info_.name = nameOf(type, id);
}

void HaplyDevice::open() {
  if (thread_.joinable()) return;
  Inventory inventory = lookAround(*service_, looking_.get_token());
  const Choice choice = choose(inventory, *service_, chosen_);
  mailbox_.status.write(choice.status);
  if (choice.device == nullptr) {
    const Message message = describe(choice.status);
    throw DeviceError(message);
  }
  takeLimits(choice.device->type.view(), choice.device->id.view());
  std::string id(choice.device->id.view());
  try {
    thread_ = std::jthread(
        [this, i = std::move(inventory), c = std::move(id)](const std::stop_token& stop) mutable {
          // Refused like the loop's own, which says so.
          [[maybe_unused]] const RealtimeGrant grant = requestRealtime(kPriority, {});
          Link(*service_, mailbox_, std::move(c)).run(stop, std::move(i));
        });
  } catch (const std::system_error& error) {
    throw failure<MessageId::haply_thread_not_started>(error.what());
  }
}

void HaplyDevice::close() noexcept {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

DeviceReading HaplyDevice::read(std::int64_t /*now_ns*/) RELIEVO_REALTIME {
  const std::uint32_t cuts = mailbox_.cuts.load();  // Before the reading: see LoopEnd.
  mailbox_.readings.update();
  return loop_end_.take(cuts, mailbox_.readings.front());
}

void HaplyDevice::send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME {
  mailbox_.orders.write(loop_end_.order(force, now_ns));
}

const LinkStatus& HaplyDevice::status() {
  mailbox_.status.update();
  return mailbox_.status.front();
}

void HaplyDevice::retry() {
  ++command_.retries;
  mailbox_.commands.write(command_);
}

}  // namespace relievo::haply
