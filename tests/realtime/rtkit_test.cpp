// SPDX-License-Identifier: BSD-3-Clause
// RealtimeKit as the loop's thread meets it: a bus of the test's own with a service that answers.
#include "haptics/rt/rtkit.h"

#include <dbus/dbus.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/realtime/bus_service.h"

namespace relievo {
namespace {

/// Answers MakeThreadRealtime: grants, or refuses with a sentence.
class Service {
 public:
  Service(const std::string& address, bool grant)
      : service_(address, "org.freedesktop.RealtimeKit1",
                 [this, grant](test::BusService& service, DBusMessage* message) {
                   if (dbus_message_is_method_call(message, "org.freedesktop.RealtimeKit1",
                                                   "MakeThreadRealtime") == FALSE) {
                     return;
                   }
                   dbus_message_get_args(message, nullptr, DBUS_TYPE_UINT64, &asked_thread,
                                         DBUS_TYPE_UINT32, &asked_priority, DBUS_TYPE_INVALID);
                   if (grant) {
                     service.send(dbus_message_new_method_return(message));
                   } else {
                     service.refuse(message);
                   }
                 }) {}
  // [after the answer]
  dbus_uint64_t asked_thread = 0;
  dbus_uint32_t asked_priority = 0;

 private:
  test::BusService service_;  // Last: its thread uses the others.
};

using RealtimeKit = test::BusTest;

TEST_F(RealtimeKit, IsAskedForTheCallingThreadAtAPriorityThatItHandsOut) {
  Service service(bus_->address(), true);
  EXPECT_EQ(askRealtimeKit(80), "");
  EXPECT_EQ(service.asked_thread, static_cast<dbus_uint64_t>(::syscall(SYS_gettid)));
  EXPECT_EQ(service.asked_priority, 20U);
}

TEST_F(RealtimeKit, ALoopThatHangsIsEndedByASignalThatCanBeHandled) {
  Service service(bus_->address(), true);
  EXPECT_EQ(askRealtimeKit(80), "");
  rlimit work{};
  ASSERT_EQ(::getrlimit(RLIMIT_RTTIME, &work), 0);
  EXPECT_LE(work.rlim_max, 200'000U) << "RealtimeKit refuses more";
  EXPECT_GE(work.rlim_max - work.rlim_cur, 50'000U) << "us from SIGXCPU to SIGKILL";
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
