// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace relievo {

/// Last name of a path, and all of it, for people: see core's escapedName().
QString shownFileName(const QString& path);
QString shownFilePath(const QString& path);

}  // namespace relievo
