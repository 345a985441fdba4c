// SPDX-License-Identifier: BSD-3-Clause
// Which device is meant, and what is said where it is not there.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "haptics/device/haply/haply_device.h"
#include "tests/emulator/haply/haply_in_process.h"

namespace relievo::haply {
namespace {

using emulator::HaplyFault;
using emulator::HaplyInProcess;
using testing::HasSubstr;

/// Why the device was not opened, with its code; empty: it was.
std::string refusal(const std::function<void(HaplyInProcess&)>& arrange,
                    const std::string& chosen = {}) {
  auto service = std::make_unique<HaplyInProcess>();
  arrange(*service);
  Inventory inventory = lookAround(*service, {});
  const Choice choice = choose(inventory, *service, chosen);
  inventory.port.reset();  // Before its service.
  if (choice.device != nullptr) return {};
  HaplyDevice device(std::move(service), chosen);
  try {
    device.open();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.what(), englishText(describe(choice.status)));
    return codeOf(describe(choice.status)) + " " + error.what();
  }
  return "opened all the same";
}

TEST(HaplySearch, IdsNameADeviceOrTheOnlyOne) {
  EXPECT_EQ(chosenBy("haply"), "");
  EXPECT_EQ(chosenBy("haply:049D"), "049D");
  for (const char* id : {"", "hapl", "haply:", "haplyx", "falcon:049D"}) {
    EXPECT_FALSE(chosenBy(id)) << id;
  }
  EXPECT_EQ(idOf("049D"), "haply:049D");
  EXPECT_EQ(idOf(""), "haply");
}

TEST(HaplySearch, EveryReasonIsSaidWithWhatToDo) {
  EXPECT_EQ(refusal([](HaplyInProcess&) {}), "");
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.runs = false; }),
              AllOf(HasSubstr("E311"), HasSubstr("127.0.0.1:10001"), HasSubstr("systemctl start")));
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.foreign = true; }),
              AllOf(HasSubstr("E312"), HasSubstr("RELIEVO_HAPLY_SERVICE")));
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.world.version = "3.0.5"; }),
              AllOf(HasSubstr("E312"), HasSubstr("3.0.5"), HasSubstr("3.1")));
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.world.fault = HaplyFault::truncated; }),
              HasSubstr("E312"));
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.world.fault = HaplyFault::device_absent; }),
              AllOf(HasSubstr("E313"), HasSubstr("Plug it in")));
  EXPECT_THAT(refusal([](HaplyInProcess&) {}, "04BA"),
              AllOf(HasSubstr("E313"), HasSubstr("Haply 04BA"), HasSubstr("049D")));
  EXPECT_THAT(refusal([](HaplyInProcess& s) { s.world.fault = HaplyFault::second_device; }),
              AllOf(HasSubstr("049D"), HasSubstr("04BA"), HasSubstr("haply:ID")));
  EXPECT_EQ(refusal([](HaplyInProcess& s) { s.world.fault = HaplyFault::second_device; }, "04BA"),
            "");
}

TEST(HaplySearch, LimitsAreThoseOfTheKindAndTheLeastWhereItIsUnknown) {
  EXPECT_EQ(limitsOf("inverse3").max_force_n, 5);
  EXPECT_EQ(limitsOf("inverse3").max_stiffness_n_per_mm, 0.6);
  EXPECT_EQ(limitsOf("minverse").max_force_n, 2);
  EXPECT_EQ(limitsOf("").max_force_n, 2);
  EXPECT_EQ(limitsOf("next").workspace.half_extent, limitsOf("minverse").workspace.half_extent);
}

TEST(HaplySearch, EveryStateHasItsWords) {
  std::vector<std::string> all;
  for (int i = 0; i <= static_cast<int>(LinkState::silent); ++i) {
    LinkStatus status;
    status.state = static_cast<LinkState>(i);
    all.push_back(englishText(describe(status)));
    EXPECT_FALSE(all.back().empty());
    EXPECT_FALSE(nameOf(status.state).empty());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

}  // namespace
}  // namespace relievo::haply
