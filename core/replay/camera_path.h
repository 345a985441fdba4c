// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/provenance/provenance.h"
#include "core/region/region.h"

namespace relievo {

/// A view that the camera passes at a time.
struct KeyView {
  double t_s = 0;
  ViewState view;
  friend bool operator==(const KeyView&, const KeyView&) = default;
};

/// The way of a camera over an object, by key views.
struct CameraPath {
  std::string name;
  std::vector<KeyView> keys;
  friend bool operator==(const CameraPath&, const CameraPath&) = default;

  double startS() const noexcept { return keys.empty() ? 0 : keys.front().t_s; }
  double endS() const noexcept { return keys.empty() ? 0 : keys.back().t_s; }
};

/// @throw ArgumentError  fewer than two keys, times that do not increase or are not finite, a view
///                       without a size; says which key
void check(const CameraPath& path);

/// The view at a time; before the first key and after the last one, theirs. Middle, size and height
/// gain of the region and the turn of the camera follow cubic curves through the keys (Fritsch and
/// Carlson 1980): no jump in speed, nothing beyond the keys on both sides, at rest at both ends and
/// wherever a value turns back. Sizes and gains go by ratio, turns by the shorter way. How the
/// relief is painted changes at the keys. The level is the one that fits the size.
/// @throw ArgumentError  as check
ViewState viewAt(const CameraPath& path, const DetailLadder& ladder, double t_s);

}  // namespace relievo
