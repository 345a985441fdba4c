// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QString>

#include "core/project/project.h"
#include "core/region/region.h"

namespace relievo {

/// What to open and how; nothing chosen means the defaults of `SurfaceOptions`.
struct OpenRequest {
  QString file;
  std::optional<LengthUnit> unit;             ///< Said by the user for this file.
  std::optional<LengthUnit> remembered_unit;  ///< Said for this folder; used if the file has none.
  std::optional<ViewChoice> view;
  std::optional<RectMm> region;  ///< First window, view mm.
  std::optional<int> detail;     ///< First detail, 1 = whole.
  bool accept_incomplete = false;
  ScanChoices scan = {};    ///< What of the file is read.
  bool keeps_view = false;  ///< Side, turn, exaggeration and place of what is open, if anything is.
  std::optional<SurfaceOptions> options;  ///< In place of `unit` and `view`.
  /// A state that comes back, in place of the choices above; its `file` is `file`.
  std::optional<Project> project = {};
  QString project_file = {};  ///< That holds this state; empty: none.
  /// Name of a step: the file takes the present one's place and can be undone; empty: a new
  /// beginning.
  QString step = {};
};

}  // namespace relievo
