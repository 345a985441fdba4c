// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/axis.h"

namespace relievo::batch {

// Pieces of an SVG text; lengths in SVG units, the same digits in every locale.
std::string escaped(const std::string& text);  ///< For XML: a file may be called "a & b".
/// @param anchor  "start", "middle" or "end"; `more` are further attributes
std::string textAt(double x, double y, const std::string& anchor, const std::string& text,
                   const std::string& more = {});
std::string lineAt(double x1, double y1, double x2, double y2, const std::string& colour);

}  // namespace relievo::batch
