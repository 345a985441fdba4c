// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDate>
#include <QDateTime>
#include <QString>

#include "core/region/window.h"
#include "core/session/firmness.h"
#include "haptics/loop/haptic_core.h"

namespace relievo {

/// Where a recording goes that nobody named: in `folder`, SCAN_DATE_001.ENDING with the first
/// number that no recording of that name has. Makes the folder. @throw WriteError
/// @param scan  name of what is touched; empty: "touch"
QString proposedRecording(const QString& folder, const QString& scan, const QString& ending,
                          const QDate& today);

/// Where flight records go: the user's state folder. Not made here.
QString flightFolder();

/// Comment lines of a recording (conventions.md 5.5).
/// @param firmness  null: the origins say where it is firm
QString recordingHeaderLines(const QString& from_host, const QString& device,
                             const HapticOptions& options, SurfaceKind surface,
                             const FirmnessMap* firmness, const QDateTime& now);

/// Where a window lay, for a recording's last lines.
QString windowLine(const RegionWindow& window);

/// "2 min 14 s", from samples at 1 kHz.
QString durationText(quint64 samples);

}  // namespace relievo
