// SPDX-License-Identifier: BSD-3-Clause
// RealtimeKit as the loop's thread meets it: a bus of the test's own with a service that answers.
#include "haptics/rt/rtkit.h"

#include <dbus/dbus.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <thread>

#include "tests/realtime/message_bus.h"

namespace relievo {
namespace {

/// Answers MakeThreadRealtime once: grants, or refuses with a sentence.
class Service {
 public:
  Service(const std::string& address, bool grant) : grant_(grant) {
    connection_ = dbus_connection_open_private(address.c_str(), nullptr);
    EXPECT_NE(connection_, nullptr);
    EXPECT_TRUE(dbus_bus_register(connection_, nullptr));
    EXPECT_EQ(dbus_bus_request_name(connection_, "org.freedesktop.RealtimeKit1", 0, nullptr),
              DBUS_REQUEST_NAME_REPLY_PRIMARY_OWNER);
    thread_ = std::thread([this] { serve(); });
  }
  ~Service() {
    stopping_ = true;
    thread_.join();
    dbus_connection_close(connection_);
    dbus_connection_unref(connection_);
  }
  // [after the answer]
  dbus_uint64_t asked_thread = 0;
  dbus_uint32_t asked_priority = 0;

 private:
  void serve() {
    while (!stopping_) {
      dbus_connection_read_write(connection_, 20);
      DBusMessage* message = dbus_connection_pop_message(connection_);
      if (message == nullptr) continue;
      if (dbus_message_is_method_call(message, "org.freedesktop.RealtimeKit1",
                                      "MakeThreadRealtime") != FALSE) {
        dbus_message_get_args(message, nullptr, DBUS_TYPE_UINT64, &asked_thread, DBUS_TYPE_UINT32,
                              &asked_priority, DBUS_TYPE_INVALID);
        DBusMessage* answer =
            grant_ ? dbus_message_new_method_return(message)
                   : dbus_message_new_error(message, DBUS_ERROR_ACCESS_DENIED, "not for you");
        dbus_connection_send(connection_, answer, nullptr);
        dbus_connection_flush(connection_);
        dbus_message_unref(answer);
      }
      dbus_message_unref(message);
    }
  }

  bool grant_;
  DBusConnection* connection_ = nullptr;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// One bus for all: the library reads its address once per process.
class RealtimeKit : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dbus_threads_init_default();
    bus_ = std::make_unique<test::MessageBus>();
  }
  static void TearDownTestSuite() { bus_.reset(); }
  void SetUp() override { ASSERT_FALSE(bus_->address().empty()) << "no dbus-daemon"; }

  static std::unique_ptr<test::MessageBus> bus_;
};
std::unique_ptr<test::MessageBus> RealtimeKit::bus_;

TEST_F(RealtimeKit, IsAskedForTheCallingThreadAtAPriorityThatItHandsOut) {
  Service service(bus_->address(), true);
  EXPECT_EQ(askRealtimeKit(80), "");
  EXPECT_EQ(service.asked_thread, static_cast<dbus_uint64_t>(::syscall(SYS_gettid)));
  EXPECT_EQ(service.asked_priority, 20U);
}

TEST_F(RealtimeKit, ItsRefusalIsPassedOnInItsWords) {
  Service service(bus_->address(), false);
  EXPECT_EQ(askRealtimeKit(80), "not for you");
}

TEST_F(RealtimeKit, ABusWithoutTheServiceIsARefusal) {
  EXPECT_NE(askRealtimeKit(80).find("RealtimeKit1"), std::string::npos) << askRealtimeKit(80);
}

}  // namespace
}  // namespace relievo
