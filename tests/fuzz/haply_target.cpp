// SPDX-License-Identifier: BSD-3-Clause
// Messages of Haply's Inverse Service under libFuzzer: any bytes are a state that makes sense, or
// none; what is then said to the device is well-formed.
#include <cmath>
#include <string_view>

#include "core/message/message.h"
#include "haptics/device/haply/events.h"
#include "haptics/device/haply/messages.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  haply::JsonReader json(text);
  const bool whole = json.skip() && json.atEnd();
  if (const auto version = haply::readVersion(text)) {
    fuzz::require(whole, "a version stands in a whole text");
    fuzz::require(version->major >= 0 && version->minor >= 0, "versions count from zero");
  }
  if (const auto event = haply::readEvent(text)) {
    fuzz::require(whole, "an event stands in a whole text");
    fuzz::require(!englishText(haply::describe(*event)).empty(), "each is a sentence");
  }
  haply::ServiceState state;
  if (!haply::readState(text, state)) return 0;
  fuzz::require(whole, "what is believed is whole");
  fuzz::require((state.buttons & ~0b1101U) == 0, "there are three buttons");
  haply::MessageWriter writer;
  for (const haply::ServiceDevice& device : state.told()) {
    fuzz::require(state.find(device.id.view()) == &device, "each name is there once");
    fuzz::require(!device.place || isFinite(*device.place), "a place is finite");
    fuzz::require(!device.force || isFinite(*device.force), "a force is finite");
    for (const std::string_view said :
         {writer.order(device, haply::ForceKey::vector, {1, 2, 3}, true)}) {
      haply::JsonReader again(said);
      fuzz::require(again.skip() && again.atEnd(), "what is ordered is well-formed");
    }
  }
  return 0;
}
