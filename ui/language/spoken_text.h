// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace relievo {

/// A text of the window for ears: signs of units as words, numbers as one says them, and without
/// the catalogue's code, which is for looking it up. [any thread]
QString forEars(const QString& text);

}  // namespace relievo
