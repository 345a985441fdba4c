// SPDX-License-Identifier: BSD-3-Clause
// HID devices under libFuzzer: a descriptor of any bytes, then reports of any bytes.
#include <algorithm>
#include <cmath>

#include "haptics/device/hid/hid_reports.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.
  if (size == 0) return 0;
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  const std::size_t split = std::min<std::size_t>(data[0], bytes.size());
  const auto fields = hid::buttonFields(bytes.first(split));
  fuzz::require(fields.size() <= 64, "a damaged descriptor ends");
  hid::CapMotion cap;
  for (auto rest = bytes.subspan(split); !rest.empty();) {
    const auto report = rest.first(std::min<std::size_t>(16, rest.size()));
    rest = rest.subspan(report.size());
    if (hid::buttonsOf(report, fields)) fuzz::require(!fields.empty(), "buttons have a field");
    hid::capButtons(report);
    if (const auto now = hid::capMotion(report, cap)) cap = *now;
    const hid::CapMotion moved = hid::beyondRest(cap);
    for (const double push : {moved.right, moved.up, moved.toward, moved.about_right,
                              moved.about_up, moved.about_toward}) {
      fuzz::require(std::abs(push) <= 1.55, "a cap has its limits");
    }
  }
  return 0;
}
