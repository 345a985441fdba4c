// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/depth/view.h"
#include "core/region/region.h"

namespace relievo {

/// What the command line says about the window (verbs are app/cli's).
struct WindowOptions {
  std::vector<std::string> files;  ///< Empty: the start page; several: scans of one object.
  std::optional<LengthUnit> unit;
  std::optional<ViewChoice> view;
  std::optional<int> detail;
  std::optional<RectMm> region;
  std::string language;     ///< "de"; empty: as set, else the system's.
  std::string exhibit;      ///< File of an exhibit, which takes the whole window; empty: none.
  bool only_files = false;  ///< "--" was given.
  bool safe_mode = false;
  bool help = false;
  bool version = false;
  bool libraries = false;  ///< "--version" with those that draw.

  /// How the file is to be opened; a project or picture says so itself.
  bool saysHow() const { return unit || view || detail || region; }
};

/// @param arguments  without the program's name
/// @throw ArgumentError  unknown option, missing or malformed value, or what is said of one
///                       file beside several
WindowOptions parseWindowOptions(const std::vector<std::string>& arguments);

/// One line of --help, of the manual page and of the completions of shells.
struct WindowOptionRow {
  std::vector<std::string> names;
  std::string value;  ///< "en|de|hi": one of these; "N": a number; empty: it takes none.
  std::string help;
};
const std::vector<WindowOptionRow>& windowOptionRows();

/// The text of --help.
std::string windowHelp();

}  // namespace relievo
