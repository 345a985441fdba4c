// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/look_arguments.h"
#include "core/project/project.h"

namespace relievo::batch {

/// The options of a figure as they stand on the command line.
struct FigureArguments {
  std::string layout;  ///< Empty, like all of these: as in the request they change.
  std::string scale;   ///< "N" or "1:N".
  std::optional<double> width_mm, dpi, text_pt, eye_angle_deg, zero_plane_mm;
  LookArguments look;
  std::string stereo;
  std::vector<std::string> without;  ///< Marks to leave out.
  bool transparent = false, swap_eyes = false, any_parallax = false, both_eyes = false;
  std::string recording;
  std::vector<std::string> measure;  ///< "NAME:KIND:X,Y;X,Y[@PLANE]"
};
void addFigureOptions(CLI::App& verb, FigureArguments& arguments);

/// A request with what the arguments say in place of what it said.
/// @throw ArgumentError  a value that is not of its option's form
FigureRequest figureRequest(const FigureArguments& arguments, FigureRequest request = {});
std::vector<Measurement> measurements(const FigureArguments& arguments);

}  // namespace relievo::batch
