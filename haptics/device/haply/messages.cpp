// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/messages.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace relievo::haply {

namespace {
constexpr double kMmPerM = 1000;
constexpr std::uint32_t kPlus = 1U, kCentre = 1U << 2U, kMinus = 1U << 3U;

/// Each member once: of two, nobody knows which one the service means.
class Once {
 public:
  explicit Once(JsonReader& json) : json_(json) {}
  bool is(std::string_view key, std::string_view wanted, unsigned bit) {
    if (key != wanted) return false;
    if ((seen_ >> bit & 1U) != 0) json_.fail();
    seen_ |= 1U << bit;
    return true;
  }
  bool all(unsigned bits) const { return (seen_ & bits) == bits; }

 private:
  JsonReader& json_;
  unsigned seen_ = 0;
};

bool isOfAnId(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '-' || c == '.';
}

void readName(JsonReader& json, ShortText& into) {
  std::string_view text;
  if (json.string(text) && !into.take(text)) json.fail();
}

/// It is written into orders as it is.
void readId(JsonReader& json, ShortText& into) {
  readName(json, into);
  const std::string_view id = into.view();
  if (id.empty() || !std::all_of(id.begin(), id.end(), isOfAnId)) json.fail();
}

template <class Triple>
void readTriple(JsonReader& json, std::optional<Triple>& into) {
  Triple triple;
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "x", 0)) json.number(triple.x);
    if (once.is(key, "y", 1)) json.number(triple.y);
    if (once.is(key, "z", 2)) json.number(triple.z);
  });
  if (!once.all(0b111)) json.fail();
  into = triple;
}

/// Parts that are as usual may be missing.
void readPose(JsonReader& json, Pose& pose) {
  const auto part = [&](std::size_t first, std::string_view names) {
    json.object([&](std::string_view key) {
      const std::size_t at = key.size() == 1 ? names.find(key[0]) : std::string_view::npos;
      if (at != std::string_view::npos) json.number(pose.values[first + at]);
    });
  };
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "position", 0)) part(0, "xyz");
    if (once.is(key, "rotation", 1)) part(3, "wxyz");
    if (once.is(key, "scale", 2)) part(7, "xyz");
  });
}

void readConfiguration(JsonReader& json, ServiceDevice& device) {
  device.has_configuration = true;
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "type", 0)) readName(json, device.type);
    if (once.is(key, "preset", 1)) readName(json, device.preset);
    if (once.is(key, "mount", 2)) readPose(json, device.mount);
    if (!once.is(key, "basis", 3)) return;
    json.object([&](std::string_view part) {
      if (part == "permutation") readName(json, device.basis);
    });
  });
}

void readPlace(JsonReader& json, ServiceDevice& device) {
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "cursor_position", 0)) readTriple(json, device.place);
    if (once.is(key, "current_cursor_force", 1)) readTriple(json, device.force);
    if (once.is(key, "transform", 2)) readPose(json, device.transform);
  });
}

void readStatus(JsonReader& json, ServiceDevice& device) {
  device.has_status = true;
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "calibrated", 0)) json.boolean(device.calibrated);
    if (once.is(key, "ready", 1)) json.boolean(device.ready);
    if (once.is(key, "started", 2)) json.boolean(device.started);
    if (once.is(key, "power_supply", 3)) json.boolean(device.power_supply);
  });
}

void readDevice(JsonReader& json, std::string_view list, ServiceState& state) {
  if (state.device_count == ServiceState::kMostDevices) {
    json.skip();
    return;
  }
  ServiceDevice& device = state.devices[state.device_count];
  device = {};
  device.list = ShortText(list);
  Once once(json);
  json.object([&](std::string_view key) {
    if (once.is(key, "device_id", 0)) readId(json, device.id);
    if (once.is(key, "config", 1)) readConfiguration(json, device);
    if (once.is(key, "state", 2)) readPlace(json, device);
    if (once.is(key, "status", 3)) readStatus(json, device);
  });
  if (!once.all(1)) json.fail();
  if (device.type.empty()) device.type = device.list;
  ++state.device_count;
}

/// Of the wireless grip a, b, c; the wired one has one button.
void readGrip(JsonReader& json, ServiceState& state) {
  const auto press = [&](std::uint32_t bit) {
    bool down = false;
    json.boolean(down);
    if (down) state.buttons |= bit;
  };
  json.object([&](std::string_view key) {
    if (key != "state") return;
    json.object([&](std::string_view part) {
      if (part == "button") press(kCentre);
      if (part != "buttons") return;
      json.object([&](std::string_view name) {
        if (name == "a") press(kPlus);
        if (name == "b") press(kCentre);
        if (name == "c") press(kMinus);
      });
    });
  });
}

bool isAListOfDevices(std::string_view key) {
  return key == "inverse3" || key == "inverse3x" || key == "minverse";
}
bool isAListOfGrips(std::string_view key) {
  return key == "wireless_verse_grip" || key == "verse_grip";
}
}  // namespace

DeviceMm deviceFromService(ServiceM place) noexcept {
  return {kMmPerM * place.x, kMmPerM * place.z, -kMmPerM * place.y};
}

ServiceN serviceFromDevice(DeviceN force) noexcept {
  return {force.x, -force.z, force.y};
}

std::optional<ServiceVersion> readVersion(std::string_view text) noexcept {
  ServiceVersion version;
  JsonReader json(text);
  const auto member = [&](std::string_view key) {
    if (key == "project_version") readName(json, version.text);
  };
  json.object([&](std::string_view key) {
    if (key == "data") {  // Newer ones may wrap what they answer.
      json.object(member);
    } else {
      member(key);
    }
  });
  if (!json.atEnd()) return std::nullopt;
  const std::string_view words = version.text.view();
  const char* const end = words.data() + words.size();
  const auto major = std::from_chars(words.data(), end, version.major);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
  const bool whole = minor.ec == std::errc() && (minor.ptr == end || *minor.ptr == '.');
  if (!whole || version.major < 0 || version.minor < 0) return std::nullopt;
  return version;
}

bool isSpokenBy(const ServiceVersion& version) noexcept {
  return version.major == 3 && version.minor >= 1;
}

ForceKey forceKeyOf(const ServiceVersion& version) noexcept {
  return version.minor >= 5 ? ForceKey::vector : ForceKey::values;
}

bool Pose::isLike(const Pose& other) const noexcept {
  constexpr double kSame = 1e-6;  // The service's own numbers have seven digits.
  return std::equal(values.begin(), values.end(), other.values.begin(),
                    [](double a, double b) { return std::abs(a - b) <= kSame; });
}

const ServiceDevice* ServiceState::find(std::string_view id) const noexcept {
  for (const ServiceDevice& device : told()) {
    if (device.id.view() == id) return &device;
  }
  return nullptr;
}

bool readState(std::string_view text, ServiceState& into) noexcept {
  into.device_count = 0;
  into.buttons = 0;
  JsonReader json(text);
  json.object([&](std::string_view key) {
    if (isAListOfDevices(key)) {
      json.array([&] { readDevice(json, key, into); });
    } else if (isAListOfGrips(key)) {
      json.array([&] { readGrip(json, into); });
    }
  });
  if (!json.atEnd()) return false;
  for (const ServiceDevice& device : into.told()) {
    if (into.find(device.id.view()) != &device) return false;  // Two of one name.
  }
  return true;
}

void MessageWriter::put(std::string_view text) noexcept {
  const std::size_t room = text_.size() - size_;
  size_ += text.copy(text_.data() + size_, room);
}

void MessageWriter::put(double value) noexcept {
  constexpr int kDigits = 4;        // A tenth of a millinewton.
  constexpr double kLargest = 100;  // Nothing is larger; it keeps the text short.
  const double sane = std::isfinite(value) ? std::clamp(value, -kLargest, kLargest) : 0;
  char* const end = text_.data() + text_.size();
  const auto put =
      std::to_chars(text_.data() + size_, end, sane, std::chars_format::fixed, kDigits);
  if (put.ec == std::errc()) size_ = static_cast<std::size_t>(put.ptr - text_.data());
}

void MessageWriter::begin(std::string_view session, const ServiceDevice& device) noexcept {
  size_ = 0;
  put("{");
  put(session);
  put("\"");
  put(device.list.view());
  put(R"(":[{"device_id":")");
  put(device.id.view());
  put("\"");
}

std::string_view MessageWriter::end(std::string_view tail) noexcept {
  put(tail);
  return {text_.data(), size_};
}

namespace {
constexpr std::string_view kEverything = R"("session":{"force_render_full_state":{}},)";
}  // namespace

std::string_view MessageWriter::configuration(const ServiceDevice& device) noexcept {
  begin(R"("session":{"configure":{"profile":{"name":"relievo:touch"}}},)", device);
  put(R"(,"configure":{"preset":{"preset":")");
  put(kPreset);
  put(R"("},"basis":{"permutation":")");
  put(kBasis);
  return end(R"("}},"commands":{"probe_position":{}}}]})");
}

std::string_view MessageWriter::question(const ServiceDevice& device, bool everything) noexcept {
  begin(everything ? kEverything : "", device);
  return end(R"(,"commands":{"probe_position":{}}}]})");
}

std::string_view MessageWriter::order(const ServiceDevice& device, ForceKey key, ServiceN force,
                                      bool everything) noexcept {
  begin(everything ? kEverything : "", device);
  put(R"(,"commands":{"set_cursor_force":{")");
  put(key == ForceKey::vector ? "vector" : "values");
  put(R"(":{"x":)");
  put(force.x);
  put(R"(,"y":)");
  put(force.y);
  put(R"(,"z":)");
  put(force.z);
  return end("}}}}]}");
}

}  // namespace relievo::haply
