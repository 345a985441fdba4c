// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/cloud/scan.h"

namespace relievo::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

/// Sentences for people end, and hold no control characters.
inline void checkSentence(std::string_view text) {
  require(text.ends_with('.'), "what is said is a sentence");
  for (const char c : text) {
    require(static_cast<unsigned char>(c) >= 32, "what is said is printable");
  }
}

inline void checkMessage(std::string_view message) {
  require(message.starts_with("Cannot read "), "a refusal says what could not be read");
  checkSentence(message);
}

/// What core/cloud/scan.h promises of every scan.
inline void checkScan(const Scan& scan) {
  const ScanInfo& info = scan.info;
  require(!scan.points.empty(), "a scan has points");
  require(scan.points.size() == info.finite_points, "finite points are those stored");
  require(info.finite_points <= info.points, "no more finite points than points");
  require(info.bounds.has_value() && isFinite(info.bounds->min) && isFinite(info.bounds->max),
          "a box is finite");
  require(isFinite(scan.origin), "the origin is finite");
  require(info.dropped_faces <= info.faces, "no more faces dropped than there are");
  for (const Message& warning : info.warnings) checkSentence(englishText(warning));
  for (const auto& p : scan.points) {
    require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]), "points are finite");
  }
  for (const auto& triangle : scan.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < scan.points.size(), "corners are points");
    }
  }
}

}  // namespace relievo::fuzz
