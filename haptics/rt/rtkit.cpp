// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/rtkit.h"

#include <dbus/dbus.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace relievo {

namespace {
constexpr int kMostPriority = 20;        // RealtimeKit's own default limit.
constexpr rlim_t kMostWorkUs = 200'000;  // Likewise; it refuses processes without such a limit.
constexpr rlim_t kEndingWorkUs = 150'000;
constexpr int kAnswerTimeoutMs = 1'000;

/// A private connection: closing it touches nobody else's.
struct CloseConnection {
  void operator()(DBusConnection* connection) const {
    dbus_connection_close(connection);
    dbus_connection_unref(connection);
  }
};
struct FreeMessage {
  void operator()(DBusMessage* message) const { dbus_message_unref(message); }
};

class BusError {
 public:
  BusError() { dbus_error_init(&error_); }
  ~BusError() { dbus_error_free(&error_); }
  BusError(const BusError&) = delete;
  BusError& operator=(const BusError&) = delete;
  DBusError* get() { return &error_; }
  std::string text() const { return error_.message != nullptr ? error_.message : "no answer"; }

 private:
  DBusError error_{};
};
}  // namespace

bool limitRealtimeWork() {
  const rlimit work{kEndingWorkUs, kMostWorkUs};
  return ::setrlimit(RLIMIT_RTTIME, &work) == 0;
}

std::string askRealtimeKit(int priority) {
  BusError error;
  const std::unique_ptr<DBusConnection, CloseConnection> bus(
      dbus_bus_get_private(DBUS_BUS_SYSTEM, error.get()));
  if (!bus) return error.text();
  dbus_connection_set_exit_on_disconnect(bus.get(), FALSE);
  if (!limitRealtimeWork()) return "its limit of work could not be set";

  constexpr const char* kName = "org.freedesktop.RealtimeKit1";
  const std::unique_ptr<DBusMessage, FreeMessage> call(dbus_message_new_method_call(
      kName, "/org/freedesktop/RealtimeKit1", kName, "MakeThreadRealtime"));
  const auto thread = static_cast<dbus_uint64_t>(::syscall(SYS_gettid));
  const auto level = static_cast<dbus_uint32_t>(std::clamp(priority, 1, kMostPriority));
  if (!call || dbus_message_append_args(call.get(), DBUS_TYPE_UINT64, &thread, DBUS_TYPE_UINT32,
                                        &level, DBUS_TYPE_INVALID) == FALSE) {
    return "memory ran out";
  }
  const std::unique_ptr<DBusMessage, FreeMessage> answer(dbus_connection_send_with_reply_and_block(
      bus.get(), call.get(), kAnswerTimeoutMs, error.get()));
  return answer ? std::string() : error.text();
}

}  // namespace relievo
