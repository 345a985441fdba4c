// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dbus/dbus.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "tests/realtime/message_bus.h"

namespace relievo::test {

/// A service of the system's, as a test plays it: owns its name on a bus of the test's own and
/// answers in a thread of its own.
class BusService {
 public:
  using Handler = std::function<void(BusService&, DBusMessage*)>;

  /// @param handle  [service's thread] each message that comes
  /// @param idle    [service's thread] about a hundred times a second; may be empty
  BusService(const std::string& address, const char* name, Handler handle,
             std::function<void(BusService&)> idle = {})
      : handle_(std::move(handle)), idle_(std::move(idle)) {
    connection_ = dbus_connection_open_private(address.c_str(), nullptr);
    EXPECT_NE(connection_, nullptr);
    EXPECT_TRUE(dbus_bus_register(connection_, nullptr));
    EXPECT_EQ(dbus_bus_request_name(connection_, name, 0, nullptr),
              DBUS_REQUEST_NAME_REPLY_PRIMARY_OWNER);
    thread_ = std::thread([this] { serve(); });
  }
  ~BusService() {
    stopping_ = true;
    thread_.join();
    dbus_connection_close(connection_);
    dbus_connection_unref(connection_);
  }
  BusService(const BusService&) = delete;
  BusService& operator=(const BusService&) = delete;

  /// [service's thread] Takes the message.
  void send(DBusMessage* message) {
    dbus_connection_send(connection_, message, nullptr);
    dbus_connection_flush(connection_);
    dbus_message_unref(message);
  }
  void refuse(DBusMessage* call) {
    send(dbus_message_new_error(call, DBUS_ERROR_ACCESS_DENIED, "not for you"));
  }

 private:
  void serve() {
    while (!stopping_) {
      dbus_connection_read_write(connection_, 10);
      while (DBusMessage* message = dbus_connection_pop_message(connection_)) {
        handle_(*this, message);
        dbus_message_unref(message);
      }
      if (idle_) idle_(*this);
    }
  }

  Handler handle_;
  std::function<void(BusService&)> idle_;
  DBusConnection* connection_ = nullptr;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// One bus for all its tests: libdbus reads the address once per process.
class BusTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dbus_threads_init_default();
    bus_ = std::make_unique<MessageBus>();
  }
  static void TearDownTestSuite() { bus_.reset(); }
  void SetUp() override { ASSERT_FALSE(bus_->address().empty()) << "no dbus-daemon"; }

  static inline std::unique_ptr<MessageBus> bus_;
};

}  // namespace relievo::test
