// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

#include "core/measure/measure.h"

class QFont;
class QPainter;

namespace relievo {

/// What of a profile is shown: its heights, a cursor, and the piece from a mark to the cursor.
struct ProfileShown {
  std::vector<ProfileRow> rows;
  std::optional<std::size_t> cursor, mark;  ///< Of `rows`.
};

/// Colours that a profile is drawn in: those of the window, or of paper.
struct ProfileColours {
  QColor background, grid, text, curve, cursor, piece;
};

/// Length and depth, which is from the lowest to the highest place, of what is shown: of the
/// cursor's piece, or of all.
QString profileText(const ProfileShown& shown);

/// Draws curve, axes, cursor and piece: on the screen and into files alike.
/// @pre shown.rows is not empty
void drawProfile(QPainter& painter, const QRectF& box, const QFont& font, const ProfileShown& shown,
                 const ProfileColours& colours);

/// The row under a point of such a drawing. @pre as drawProfile
std::size_t profileRowAt(const QRectF& box, const QFont& font, const ProfileShown& shown,
                         const QPointF& point);

/// The drawing on white, as a file of vectors, `pixels` large.
std::string profileDrawing(const ProfileShown& shown, const QFont& font, const QSizeF& pixels);

}  // namespace relievo
