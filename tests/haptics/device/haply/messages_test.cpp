// SPDX-License-Identifier: BSD-3-Clause
// What Haply's Inverse Service says and is told, version by version, and what is not believed.
#include "haptics/device/haply/messages.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>

namespace relievo::haply {
namespace {

/// The first message of 3.5, as its documentation shows it.
const std::string kInventory35 = R"({"session_id":7,"inverse3":[{"device_id":"049D",
  "config":{"type":"inverse3","port":"COM12","device_info":{"major_version":7,"id":"049D"},
    "gravity_compensation":{"enabled":true,"scaling_factor":1.0},"handedness":"right",
    "preset":"defaults","basis":{"permutation":"XYZ"},
    "mount":{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},
             "scale":{"x":1,"y":1,"z":1}},
    "filters":{"force_gate":{"gain":0.3},"damping":{"scalar":0.0}}},
  "state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.15},
    "cursor_velocity":{"x":0,"y":0,"z":0},"current_cursor_force":{"x":0,"y":0.25,"z":0},
    "control_mode":"idle","transform":{"position":{"x":0,"y":0,"z":0}}},
  "status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
 "wireless_verse_grip":[{"device_id":"61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},
    "buttons":{"a":true,"b":false,"c":true}}}],
 "verse_grip":[]})";

/// Of 3.1: fewer members, and the wired grip.
const std::string kInventory31 = R"({"inverse3":[{"device_id":"04BA","config":{"type":"inverse3",
   "device_info":{"minor_version":1,"major_version":7,"id":"04BA","model":4},"port":"COM13",
   "gravity_compensation":{"enabled":true,"scaling_factor":1},"handedness":"right"},
  "state":{"angular_position":{"a0":-69.31704,"a1":137.62952,"a2":19.832787},
   "body_orientation":{"x":-0.01940918,"y":0.7026367,"z":0.00048828125,"w":0.7113037},
   "cursor_position":{"x":0.07842738,"y":-0.14836666,"z":0.14297646},"mode":"idle"},
  "status":{"calibrated":false,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
 "verse_grip":[{"device_id":"61548","config":{"port":"COM3","type":"verse_grip"},
  "state":{"button":true,"hall":0,"orientation":{"x":-0.5,"y":0.86,"z":-0.04,"w":-0.02}},
  "status":{"error":0,"ready":true}}]})";

/// Nothing: it is not believed.
std::optional<ServiceState> stateOf(const std::string& text) {
  ServiceState state;
  if (!readState(text, state)) return std::nullopt;
  return state;
}
std::string answerWith(const std::string& place) {
  return R"({"inverse3":[{"device_id":"A1","state":{"cursor_position":)" + place + "}}]}";
}

TEST(HaplyMessages, TheInventoryOf35IsUnderstood) {
  const auto state = stateOf(kInventory35);
  ASSERT_TRUE(state);
  ASSERT_EQ(state->told().size(), 1U);
  const ServiceDevice& device = state->told()[0];
  EXPECT_EQ(device.list.view(), "inverse3");
  EXPECT_EQ(device.id.view(), "049D");
  EXPECT_EQ(device.type.view(), "inverse3");
  ASSERT_TRUE(device.place && device.force);
  EXPECT_EQ(*device.place, (ServiceM{0.01, -0.12, 0.15}));
  EXPECT_EQ(*device.force, (ServiceN{0, 0.25, 0}));
  EXPECT_TRUE(device.has_configuration);
  EXPECT_EQ(device.basis.view(), "XYZ");
  EXPECT_EQ(device.preset.view(), "defaults");
  EXPECT_TRUE(device.mount.isLike({}));
  EXPECT_TRUE(device.transform.isLike({}));
  EXPECT_TRUE(device.has_status && device.calibrated && device.ready && device.started &&
              device.power_supply);
  EXPECT_EQ(state->buttons, 0b1001U) << "a is plus, c is minus";
}

TEST(HaplyMessages, TheInventoryOf31IsUnderstood) {
  const auto state = stateOf(kInventory31);
  ASSERT_TRUE(state);
  ASSERT_NE(state->find("04BA"), nullptr);
  const ServiceDevice& device = *state->find("04BA");
  EXPECT_FALSE(device.calibrated);
  EXPECT_FALSE(device.force) << "it tells none";
  EXPECT_TRUE(device.basis.empty());
  EXPECT_EQ(state->buttons, 0b0100U) << "the wired grip's button is Centre";
}

TEST(HaplyMessages, AMinverseMayStandInEitherList) {
  const auto typed = stateOf(R"({"inverse3":[{"device_id":"M","config":{"type":"minverse"}}]})");
  ASSERT_TRUE(typed);
  EXPECT_EQ(typed->told()[0].type.view(), "minverse");
  EXPECT_EQ(typed->told()[0].list.view(), "inverse3") << "orders name the list";
  const auto listed = stateOf(R"({"minverse":[{"device_id":"M"}]})");
  ASSERT_TRUE(listed);
  EXPECT_EQ(listed->told()[0].type.view(), "minverse");
  EXPECT_EQ(listed->told()[0].list.view(), "minverse");
}

TEST(HaplyMessages, MembersMayComeInAnyOrderAndBeMissingOrNull) {
  const auto state = stateOf(
      R"({"verse_grip":null,"new":[[{"a":[1,2.5e-3,"\u00e9\"]"]}],true,null],"inverse3":[{"status":
      {"started":true,"odd":{}},"state":{"current_cursor_force":null},"device_id":"A-1.b_"}]})");
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->told()[0].started);
  EXPECT_FALSE(state->told()[0].ready);
  EXPECT_FALSE(state->told()[0].force || state->told()[0].place);
  EXPECT_TRUE(stateOf("{}"));
  EXPECT_TRUE(stateOf(" {\"session_id\":1}\n"));
}

TEST(HaplyMessages, WhatIsDamagedOrMakesNoSenseIsNotBelieved) {
  EXPECT_TRUE(stateOf(answerWith(R"({"x":0,"y":0,"z":0})")));
  const std::string deep(40, '[');
  for (const std::string& place :
       {std::string(R"({"x":1e400,"y":0,"z":0})"), std::string(R"({"x":"1","y":0,"z":0})"),
        std::string(R"({"x":0,"y":0})"), std::string(R"({"x":0,"x":1,"y":0,"z":0})"),
        std::string("[0,0,0]"), std::string(R"({"x":nan,"y":0,"z":0})"), deep,
        std::string(R"({"x":01,"y":0,"z":0})"), std::string(R"({"x":+1,"y":0,"z":0})"),
        std::string(R"({"x":1.,"y":0,"z":0})"), std::string(R"({"x":Infinity,"y":0,"z":0})")}) {
    EXPECT_FALSE(stateOf(answerWith(place))) << place;
  }
  for (const char* text :
       {"",
        "null",
        "[]",
        "{",
        "{\"a\":1,}",
        "{} {}",
        "{\"a\" 1}",
        "{\"a\":tru}",
        "{\"a\":\"\n\"}",
        R"({"inverse3":{}})",
        R"({"inverse3":[{}]})",
        R"({"inverse3":[{"device_id":""}]})",
        R"({"inverse3":[{"device_id":"a\"b"}]})",
        R"({"inverse3":[{"device_id":"a b"}]})",
        R"({"inverse3":[{"device_id":7}]})",
        R"({"inverse3":[{"device_id":"A","state":[]}]})",
        R"({"inverse3":[{"device_id":"A"},{"device_id":"A"}]})",
        R"({"inverse3":[{"device_id":"A","status":{"ready":1}}]})",
        R"({"inverse3":[{"device_id":"A","state":{},"state":{}}]})",
        R"({"inverse3":[{"device_id":"012345678901234567890123456789012345"}]})"}) {
    EXPECT_FALSE(stateOf(text)) << text;
  }
}

TEST(HaplyMessages, EveryBeginningOfAMessageIsDamaged) {
  for (std::size_t size = 0; size < kInventory35.size(); ++size) {
    EXPECT_FALSE(stateOf(kInventory35.substr(0, size))) << size;
  }
}

TEST(HaplyMessages, VersionsChooseTheMemberThatHoldsTheForce) {
  const auto version = [](const std::string& text) {
    return readVersion(R"({"git_describe":"x","project_version":")" + text + "\"}");
  };
  EXPECT_EQ(forceKeyOf(*version("3.5.0.0")), ForceKey::vector);
  EXPECT_EQ(forceKeyOf(*version("3.12")), ForceKey::vector);
  EXPECT_EQ(forceKeyOf(*version("3.4.8")), ForceKey::values);
  EXPECT_EQ(forceKeyOf(*version("3.1.1")), ForceKey::values);
  EXPECT_FALSE(isSpokenBy(*version("3.0.5")));
  EXPECT_FALSE(isSpokenBy(*version("4.0"))) << "nobody knows yet";
  EXPECT_FALSE(isSpokenBy(*version("2.9")));
  for (const char* text : {"", "3", "three.five", "3.", ".5", "3.x", "3.5x", "-3.5", "3.-5"}) {
    EXPECT_FALSE(version(text)) << text;
  }
  const auto wrapped = readVersion(R"({"ok":true,"data":{"project_version":"3.5.1"}})");
  ASSERT_TRUE(wrapped);
  EXPECT_EQ(wrapped->text.view(), "3.5.1");
  EXPECT_FALSE(readVersion("<html>404</html>"));
  EXPECT_FALSE(readVersion(R"({"ok":false,"error":"no such route"})"));
}

/// Six unit places and six unit forces: each axis and each sign.
TEST(HaplyMessages, AxesAreOursRightUpAndTowardThePerson) {
  EXPECT_EQ(deviceFromService({0.001, 0, 0}), (DeviceMm{1, 0, 0})) << "right";
  EXPECT_EQ(deviceFromService({0, 0.001, 0}), (DeviceMm{0, 0, -1})) << "away";
  EXPECT_EQ(deviceFromService({0, 0, 0.001}), (DeviceMm{0, 1, 0})) << "up";
  EXPECT_EQ(serviceFromDevice({1, 0, 0}), (ServiceN{1, 0, 0}));
  EXPECT_EQ(serviceFromDevice({0, 1, 0}), (ServiceN{0, 0, 1}));
  EXPECT_EQ(serviceFromDevice({0, 0, 1}), (ServiceN{0, -1, 0}));
  for (const DeviceN unit : {DeviceN{-1, 0, 0}, DeviceN{0, -1, 0}, DeviceN{0, 0, -1}}) {
    const ServiceN there = serviceFromDevice(unit);
    const DeviceMm back = deviceFromService({there.x / 1000, there.y / 1000, there.z / 1000});
    EXPECT_NEAR(back.x, unit.x, 1e-12);
    EXPECT_NEAR(back.y, unit.y, 1e-12);
    EXPECT_NEAR(back.z, unit.z, 1e-12);
  }
}

TEST(HaplyMessages, OrdersAreWrittenAsTheVersionUnderstandsThem) {
  ServiceDevice device;
  device.list = ShortText("inverse3");
  device.id = ShortText("049D");
  MessageWriter writer;
  EXPECT_EQ(writer.order(device, ForceKey::vector, {0, -0.4, 1.25}, false),
            R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":)"
            R"({"vector":{"x":0.0000,"y":-0.4000,"z":1.2500}}}}]})");
  EXPECT_EQ(writer.order(device, ForceKey::values, {}, true),
            R"({"session":{"force_render_full_state":{}},"inverse3":[{"device_id":"049D",)"
            R"("commands":{"set_cursor_force":{"values":{"x":0.0000,"y":0.0000,"z":0.0000}}}}]})");
  EXPECT_EQ(writer.question(device, false),
            R"({"inverse3":[{"device_id":"049D","commands":{"probe_position":{}}}]})");
  EXPECT_EQ(writer.configuration(device),
            R"({"session":{"configure":{"profile":{"name":"relievo:touch"}}},"inverse3":)"
            R"([{"device_id":"049D","configure":{"preset":{"preset":"arm_front_centered"},)"
            R"("basis":{"permutation":"XYZ"}},"commands":{"probe_position":{}}}]})");
}

TEST(HaplyMessages, WhateverIsWrittenIsWellFormed) {
  ServiceDevice device;
  device.list = ShortText("inverse3x");
  device.id = ShortText(std::string(ShortText::kMost, 'W'));
  MessageWriter writer;
  for (const double value : {-1e9, 1e9, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1e-300}) {
    for (const ForceKey key : {ForceKey::values, ForceKey::vector}) {
      JsonReader json(writer.order(device, key, {value, value, value}, true));
      EXPECT_TRUE(json.skip() && json.atEnd()) << value;
    }
  }
  JsonReader configuration(writer.configuration(device));
  EXPECT_TRUE(configuration.skip() && configuration.atEnd());
  JsonReader question(writer.question(device, true));
  EXPECT_TRUE(question.skip() && question.atEnd());
}

}  // namespace
}  // namespace relievo::haply
