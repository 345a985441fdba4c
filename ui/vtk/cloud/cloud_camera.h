// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/depth/view.h"

namespace relievo {

/// From where points are seen: in parallel, so that an outline on the screen is one in space.
struct CloudCamera {
  Rotation view{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< Rows: right, up, toward the viewer; file axes.
  FilePoint middle;                          ///< Shown in the middle of the picture.
  double height = 1;                         ///< File units that the picture is high.
  friend bool operator==(const CloudCamera&, const CloudCamera&) = default;
};

/// A place on a picture: pixels from its left and upper edge.
struct PicturePlace {
  double x = 0, y = 0;
};

/// Size of a picture, pixels.
struct PictureSize {
  int width = 1, height = 1;
};

/// x to the right, y up, z toward the viewer, file units: as CropOutline::view has them.
std::array<double, 3> seenAt(const CloudCamera& camera, const FilePoint& p) noexcept;
PicturePlace placeOf(const CloudCamera& camera, const PictureSize& size,
                     const FilePoint& p) noexcept;
/// x and y of a place on the picture, as seenAt; whatever the depth.
std::array<double, 2> seenUnder(const CloudCamera& camera, const PictureSize& size,
                                const PicturePlace& place) noexcept;

/// The camera turned about the picture's own axes, its middle stays. Degrees, right-handed:
/// `right` moves the near side to the right, `up` upward; `tilt` is counter-clockwise.
CloudCamera turnedBy(const CloudCamera& camera, double right_deg, double up_deg,
                     double tilt_deg = 0) noexcept;

/// All of a box in a picture of this shape, seen along the camera's directions.
CloudCamera fitted(const CloudCamera& camera, const FileBounds& box, const PictureSize& size);

/// Number of the point that is nearest the viewer among those within `radius_px` of a place;
/// nothing: none is that near. @param origin  is added to every point
std::optional<std::size_t> pointUnder(const CloudCamera& camera, const PictureSize& size,
                                      const PicturePlace& place, double radius_px,
                                      const FilePoint& origin,
                                      std::span<const std::array<float, 3>> points);

}  // namespace relievo
