// SPDX-License-Identifier: BSD-3-Clause
// What stands in for a part that a build leaves out, Haply's service without Boost and gamepads
// without the system's header: it compiles, says so, and does nothing.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "haptics/device/haply/event_channel.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/device/pad/pad_devices.h"

namespace relievo {
namespace {

TEST(LeftOut, HaplysServiceSaysThatItWasNotBuilt) {
  EXPECT_FALSE(haply::hasInverseService());
  const auto service = haply::inverseService({});
  try {
    service->connect({});
    FAIL() << "there is nothing to connect by";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("without Boost"), std::string::npos) << error.what();
  }
  EXPECT_EQ(haply::eventPort({}, {}), nullptr);
}

TEST(LeftOut, GamepadsAreNone) {
  EXPECT_FALSE(pad::hasPadDevices());
  pad::PadDevices pads;
  pad::PadNews news;
  pads.look();
  pads.rescan(news);
  pads.poll(news);
  EXPECT_TRUE(news.edges.empty());
  EXPECT_TRUE(pads.seen().empty());
}

}  // namespace
}  // namespace relievo
