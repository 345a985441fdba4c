// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/figure/figure_sheet.h"

namespace relievo {

/// Scale bar, height bar, up mark, window's outline, measurements and letter of one panel.
/// @param panel  by its place in the sheet; 0 has the letter a
void drawMarks(FigureInk& ink, const Surface& surface, const Project& project,
               const DrawnSheet& sheet, int panel);

}  // namespace relievo
