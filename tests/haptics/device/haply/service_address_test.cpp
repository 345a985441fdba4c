// SPDX-License-Identifier: BSD-3-Clause
// Where Haply's service is looked for, and whether somebody listens there.
#include "haptics/device/haply/service_address.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "core/base/error.h"

namespace relievo::haply {
namespace {

TEST(HaplyAddress, IsAPortOrAnAddressWithAPort) {
  EXPECT_EQ(addressOf("10002")->ports, std::vector<std::uint16_t>{10002});
  EXPECT_EQ(addressOf("10002")->host, "127.0.0.1");
  EXPECT_EQ(addressOf("192.168.1.5:10001")->host, "192.168.1.5");
  EXPECT_EQ(addressOf("192.168.1.5:10001")->ports, std::vector<std::uint16_t>{10001});
  EXPECT_EQ(addressOf("::1:10001")->host, "::1");
  EXPECT_EQ(addressOf("[::1]:10001")->host, "::1");
  for (const char* text : {"", "0", "65536", "-1", "1x", "host", ":10001", "host:", "1 ",
                           "localhost:10001", "127.0.0.999:1", "10001:", "[]:1", "[::1]"}) {
    EXPECT_FALSE(addressOf(text)) << text;
  }
}

TEST(HaplyAddress, IsGivenByTheEnvironment) {
  unsetenv("RELIEVO_HAPLY_SERVICE");
  EXPECT_EQ(serviceAddress().ports, (std::vector<std::uint16_t>{10001, 10000}));
  setenv("RELIEVO_HAPLY_SERVICE", "20001", 1);
  EXPECT_EQ(serviceAddress().ports, std::vector<std::uint16_t>{20001});
  EXPECT_EQ(serviceAddress().patience_ns, kPatienceNs);
  setenv("RELIEVO_HAPLY_PATIENCE_S", "60", 1);
  EXPECT_EQ(serviceAddress().patience_ns, 60 * kPatienceNs);
  setenv("RELIEVO_HAPLY_PATIENCE_S", "-1", 1);
  EXPECT_EQ(serviceAddress().patience_ns, kPatienceNs);
  unsetenv("RELIEVO_HAPLY_PATIENCE_S");
  EXPECT_EQ(serviceAddress().events_port, 0) << "of a service of its own nobody knows it";
  setenv("RELIEVO_HAPLY_EVENTS", "20002", 1);
  EXPECT_EQ(serviceAddress().events_port, 20002);
  unsetenv("RELIEVO_HAPLY_SERVICE");
  EXPECT_EQ(serviceAddress().events_port, 20002);
  setenv("RELIEVO_HAPLY_EVENTS", "none", 1);
  EXPECT_EQ(serviceAddress().events_port, 0);
  unsetenv("RELIEVO_HAPLY_EVENTS");
  EXPECT_EQ(serviceAddress().events_port, 10020);
  setenv("RELIEVO_HAPLY_SERVICE", "nonsense", 1);
  EXPECT_THROW(serviceAddress(), ArgumentError);
  unsetenv("RELIEVO_HAPLY_SERVICE");
}

TEST(HaplyAddress, NobodyListensWhereNobodyCan) {
  EXPECT_FALSE(isListenedTo({.ports = {1}}));
  EXPECT_TRUE(isListenedTo({.host = "192.0.2.1"})) << "another computer is not asked";
}

}  // namespace
}  // namespace relievo::haply
