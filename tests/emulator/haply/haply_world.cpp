// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/haply/haply_world.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace relievo::emulator {

namespace {
using Json = nlohmann::ordered_json;
using Triple = HaplyWorld::Triple;

constexpr std::array<std::string_view, 35> kNames{"none",
                                                  "silent",
                                                  "late_3_ms",
                                                  "late_10_ms",
                                                  "late_30_ms",
                                                  "two_answers",
                                                  "byte_pieces",
                                                  "fragments",
                                                  "ping",
                                                  "huge_frame",
                                                  "closes",
                                                  "truncated",
                                                  "null_place",
                                                  "number_too_large",
                                                  "wrong_type",
                                                  "deep",
                                                  "duplicate",
                                                  "member_order",
                                                  "members_missing",
                                                  "device_absent",
                                                  "other_id",
                                                  "second_device",
                                                  "uncalibrated",
                                                  "no_power",
                                                  "not_started",
                                                  "jump",
                                                  "foreign_basis",
                                                  "foreign_basis_always",
                                                  "foreign_force",
                                                  "disobedient",
                                                  "tells_late",
                                                  "tells_smooth",
                                                  "events_close",
                                                  "events_garbage",
                                                  "events_refused"};
static_assert(kNames.size() == static_cast<std::size_t>(HaplyFault::events_refused) + 1);

constexpr std::int64_t kIdleNs = 20'000'000;  // So long an order lasts; nobody has published it.
constexpr std::int64_t kTellNs = 40'000'000;  // Of those that tell the force late or smoothed.
constexpr double kGripKg = 0.15, kHandNPerMm = 0.25, kHandNsPerMm = 0.012;
/// Of the base's frame: where the middle of the workspace is, m.
constexpr Triple kMiddleM{0, -0.15, 0.16};

Json tripleJson(const Triple& triple) {
  return {{"x", triple[0]}, {"y", triple[1]}, {"z", triple[2]}};
}

bool takesVector(const std::string& version) {
  return version.compare(0, 2, "3.") != 0 || std::stoi(version.substr(2)) >= 5;
}

/// The first occurrence; a test that plants nothing would show nothing.
void replace(std::string& text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
}

Json reversed(const Json& json) {
  if (!json.is_object()) return json;
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [key, value] : json.items()) members.emplace_back(key, reversed(value));
  Json turned = Json::object();
  for (auto at = members.rbegin(); at != members.rend(); ++at) turned[at->first] = at->second;
  return turned;
}
}  // namespace

std::string_view nameOf(HaplyFault fault) {
  return kNames[static_cast<std::size_t>(fault)];
}

std::vector<HaplyFault> allHaplyFaults() {
  std::vector<HaplyFault> all;
  for (std::size_t i = 1; i < kNames.size(); ++i) all.push_back(static_cast<HaplyFault>(i));
  return all;
}

std::string HaplyWorld::versionText() const {
  return Json{{"build_time", "2024-08-07T16:01:53Z"},
              {"git_describe", version},
              {"project_name", "haply-inverse-service"},
              {"project_version", version}}
      .dump();
}

/// x right, y away, z up; a permutation of them as the session has it.
Triple HaplyWorld::serviceAxes(const Triple& ours) const {
  const Triple usual{ours[0], -ours[2], ours[1]};
  if (basis_ == "XZY") return {usual[0], usual[2], usual[1]};
  return usual;
}

Triple HaplyWorld::ourAxes(const Triple& services) const {
  Triple usual = services;
  if (basis_ == "XZY") std::swap(usual[1], usual[2]);
  return {usual[0], usual[2], -usual[1]};
}

std::string HaplyWorld::inventory(std::int64_t now_ns) {
  basis_ = "XYZ";
  preset_ = "defaults";
  advance(now_ns);
  return state(true, now_ns);
}

std::string HaplyWorld::answer(std::string_view message, std::int64_t now_ns) {
  ++messages;
  bool everything = false;
  take(message, now_ns, everything);
  advance(now_ns);
  const bool once = hasFault(HaplyFault::foreign_basis) && !std::exchange(foreign_done_, true);
  if (once || hasFault(HaplyFault::foreign_basis_always)) basis_ = "XZY";
  if (fault != HaplyFault::foreign_basis) foreign_done_ = false;
  return state(everything, now_ns);
}

void HaplyWorld::take(std::string_view message, std::int64_t now_ns, bool& everything) {
  const Json json = Json::parse(message, nullptr, false);
  if (!json.is_object()) {
    ++refused;
    return;
  }
  everything = json.contains("session") && json["session"].contains("force_render_full_state");
  if (!json.contains(type == "minverse" ? "minverse" : "inverse3")) return;
  for (const Json& device : json[type == "minverse" ? "minverse" : "inverse3"]) {
    if (device.value("device_id", "") != id) continue;
    if (device.contains("configure")) {
      ++configurations;
      const Json& how = device["configure"];
      if (how.contains("basis")) basis_ = how["basis"].value("permutation", basis_);
      if (how.contains("preset")) preset_ = how["preset"].value("preset", preset_);
    }
    const Json commands = device.value("commands", Json::object());
    if (!commands.contains("set_cursor_force")) continue;
    // The other member is ignored without a word.
    const Json force = commands["set_cursor_force"].value(
        takesVector(version) ? "vector" : "values", Json::object());
    const bool obeys = force.contains("z") && !hasFault(HaplyFault::disobedient);
    ordered_ns_ = now_ns;
    if (obeys) show(ourAxes({force["x"], force["y"], force["z"]}), now_ns, "ordered");
  }
}

void HaplyWorld::show(const Triple& force, std::int64_t now_ns, const char* why) {
  if (force == force_) return;
  force_ = force;
  largest_n = std::max(largest_n, std::hypot(force[0], force[1], force[2]));
  log.push_back({now_ns, force, why});
}

void HaplyWorld::endSession(std::int64_t now_ns) {
  show({}, now_ns, "closed");
}

void HaplyWorld::hold(const Triple& place) {
  held_ = true;
  grip_ = wanted_ = place;
  velocity_ = {};
}

void HaplyWorld::pullToward(const Triple& place) {
  held_ = false;
  wanted_ = place;
}

void HaplyWorld::tellEvent(const std::string& name, const std::string& safety_type) {
  Json data{{"device_id", id}};
  if (!safety_type.empty()) data["safety_type"] = safety_type;
  events.push_back(Json{{"name", name},
                        {"category", "device"},
                        {"level", "warning"},
                        {"data", data},
                        {"message", "as the service words it"}}
                       .dump());
}

void HaplyWorld::watchDevice() {
  const bool absent = hasFault(HaplyFault::device_absent);
  if (std::exchange(was_absent_, absent) != absent) {
    tellEvent(absent ? "device-disconnected" : "device-connected");
  }
  const bool braked = hasFault(HaplyFault::no_power);
  if (std::exchange(was_braked_, braked) != braked) {
    tellEvent("device-safety-triggered", braked ? "ebrake_triggered" : "ebrake_released");
  }
}

void HaplyWorld::advance(std::int64_t now_ns) {
  watchDevice();
  if (now_ns - ordered_ns_ > kIdleNs) show({}, now_ns, "idle");
  const double seconds = 1e-9 * static_cast<double>(now_ns - std::exchange(advanced_ns_, now_ns));
  const double kept = std::exp(-1e9 * seconds / static_cast<double>(kTellNs));
  for (std::size_t i = 0; i < 3; ++i) smooth_[i] = force_[i] + kept * (smooth_[i] - force_[i]);
  if (held_) return;
  constexpr double kStep = 2.5e-4, kLongest = 0.1;
  for (double left = std::min(seconds, kLongest); left > 0; left -= kStep) {
    const double dt = std::min(left, kStep);
    for (std::size_t i = 0; i < 3; ++i) {
      const double hand = kHandNPerMm * (wanted_[i] - grip_[i]) - kHandNsPerMm * velocity_[i];
      velocity_[i] += (hand + force_[i]) / kGripKg * 1000 * dt;  // N/kg are m/s^2.
      grip_[i] += velocity_[i] * dt;
    }
  }
}

Triple HaplyWorld::toldForce(std::int64_t now_ns) const {
  if (hasFault(HaplyFault::tells_smooth)) return smooth_;
  if (!hasFault(HaplyFault::tells_late)) return force_;
  const auto shown = std::find_if(log.rbegin(), log.rend(), [now_ns](const Shown& one) {
    return one.time_ns <= now_ns - kTellNs;
  });
  return shown == log.rend() ? Triple{} : shown->force;
}

std::string HaplyWorld::state(bool everything, std::int64_t now_ns) {
  Triple place = serviceAxes(grip_);
  for (double& value : place) value /= 1000;
  if (preset_ != "arm_front_centered") {
    for (std::size_t i = 0; i < 3; ++i) place[i] += kMiddleM[i];
  }
  if (hasFault(HaplyFault::jump)) place[0] += 0.03;
  Triple told = serviceAxes(toldForce(now_ns));
  if (hasFault(HaplyFault::foreign_force)) told[2] += 2;
  Json device{{"device_id", hasFault(HaplyFault::other_id) ? id + "x" : id}};
  if (everything) {
    device["config"] = {{"type", type},
                        {"port", "/dev/ttyACM0"},
                        {"device_info", {{"major_version", 7}, {"id", id}}},
                        {"gravity_compensation", {{"enabled", true}, {"scaling_factor", 1.0}}},
                        {"handedness", "right"},
                        {"preset", preset_},
                        {"basis", {{"permutation", basis_}}},
                        {"mount", {{"position", tripleJson({0, 0, 0})}}},
                        {"filters", {{"force_gate", {{"gain", 0.3}}}}}};
  }
  device["state"] = {{"cursor_position", tripleJson(place)},
                     {"cursor_velocity", tripleJson({0, 0, 0})},
                     {"current_cursor_force", tripleJson(told)},
                     {"control_mode", "force"}};
  device["status"] = {{"calibrated", !hasFault(HaplyFault::uncalibrated)},
                      {"in_use", false},
                      {"power_supply", !hasFault(HaplyFault::no_power)},
                      {"ready", true},
                      {"started", !hasFault(HaplyFault::not_started)}};
  if (hasFault(HaplyFault::members_missing)) device["state"].erase("cursor_velocity");
  const std::string list = type == "minverse" ? "minverse" : "inverse3";
  Json json{{"session_id", 7}, {list, Json::array()}};
  if (!hasFault(HaplyFault::device_absent)) json[list].push_back(device);
  if (hasFault(HaplyFault::second_device)) {
    device["device_id"] = "04BA";
    json[list].push_back(device);
  }
  json["wireless_verse_grip"] =
      Json::array({{{"device_id", "61576"},
                    {"state",
                     {{"orientation", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}},
                      {"buttons", {{"a", button_a}, {"b", button_b}, {"c", button_c}}}}}}});
  json["verse_grip"] =
      Json::array({{{"device_id", "61548"}, {"state", {{"button", wired_button}, {"hall", 0}}}}});
  if (hasFault(HaplyFault::member_order)) json = reversed(json);
  std::string text = json.dump();
  const std::string mark = "\"cursor_position\":";
  if (hasFault(HaplyFault::truncated)) text.resize(text.size() / 2);
  if (hasFault(HaplyFault::null_place)) replace(text, mark, mark + "null,\"other_position\":");
  if (hasFault(HaplyFault::number_too_large))
    replace(text, mark + "{\"x\":", mark + "{\"x\":1e400,\"w\":");
  if (hasFault(HaplyFault::wrong_type)) replace(text, mark, mark + "\"here\",\"other_position\":");
  if (hasFault(HaplyFault::deep)) {
    replace(text, mark, "\"deep\":" + std::string(500, '[') + std::string(500, ']') + "," + mark);
  }
  if (hasFault(HaplyFault::duplicate)) {
    replace(text, mark, mark + "{\"x\":0,\"y\":0,\"z\":0}," + mark);
  }
  return text;
}

}  // namespace relievo::emulator
