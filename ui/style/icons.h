// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QIcon>

namespace relievo {

/// One family of stroked icons on a 24 px grid, in the palette's text colour.
enum class Icon {
  open,
  view,
  fit,
  finer,
  coarser,
  whole,
  forces,
  camera,
  record,
  stereo,
  look,
  touch
};
QIcon icon(Icon which);

}  // namespace relievo
