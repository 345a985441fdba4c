// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPen>
#include <QStringList>
#include <QVector>

#include "core/recording/force_curves.h"

namespace relievo {

struct ThemeColours;

/// Names of a strip's curves in the window's language, in their order. [GUI thread]
QStringList curveNames(ForceStrip strip);

/// Their pens: width and dashes tell the curves apart without colour, too.
QVector<QPen> curvePens(ForceStrip strip, const ThemeColours& colours);

}  // namespace relievo
