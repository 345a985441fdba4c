// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/provenance/provenance.h"
#include "core/region/region.h"

namespace relievo {

/// A place on the object that somebody gave a name to.
struct NamedRegion {
  std::string name;
  Region region;
  double gain = 1;
  /// Also how it is looked at: light, relief image, stereo, turn; nothing: the place alone.
  std::optional<ViewState> view = std::nullopt;
  /// A marker: the middle of the region, gone to at whatever resolution is shown.
  bool is_point = false;
  friend bool operator==(const NamedRegion&, const NamedRegion&) = default;
};

}  // namespace relievo
