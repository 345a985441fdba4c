// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QPainter;
class QRect;
class QRectF;

namespace relievo {

struct RgbaImage;

/// Proxy and HIP as ReliefScene draws them where no colour is left, for legends: a ball, and a
/// white ring with a cross in it. The painter's state is as before.
/// @param place  square, in the painter's unit
void drawProxySign(QPainter& painter, const QRectF& place);
void drawHipSign(QPainter& painter, const QRectF& place);

/// A legend of both in the upper right corner of a part of a picture, on a plate; as large as
/// fits a picture of that height. Needs a FigureSession.
/// @param box  pixels, within the picture
void paintHandLegend(RgbaImage& picture, const QRect& box);

}  // namespace relievo
