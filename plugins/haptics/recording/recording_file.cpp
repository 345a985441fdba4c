// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/recording/recording_file.h"

#include <array>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/base/failure.h"
#include "haptics/loop/surface_preset.h"
#include "haptics/record/force_law.h"
#include "plugins/haptics/shown_file.h"

namespace relievo {

QString proposedRecording(const QString& folder_path, const QString& scan, const QString& ending,
                          const QDate& today) {
  const QDir folder(folder_path);
  if (folder_path.isEmpty() || !folder.mkpath(QStringLiteral("."))) {
    throw failure<MessageId::no_folder_for_recordings>(
        std::filesystem::path(shownFilePath(folder_path).toStdString()));
  }
  QString stem = scan.isEmpty() ? QStringLiteral("touch") : scan;
  constexpr int kMostBytes = 200;  // Of 255 that a name may have.
  while (stem.toUtf8().size() > kMostBytes) stem.chop(1);
  stem += today.toString(QStringLiteral("_yyyy-MM-dd_"));
  for (int number = 1;; ++number) {
    const QString name = stem + QStringLiteral("%1.").arg(number, 3, 10, QLatin1Char('0'));
    // Two recordings that differ in their endings alone would be taken for the same.
    if (!folder.exists(name + QLatin1String("csv")) && !folder.exists(name + QLatin1String("h5"))) {
      return folder.filePath(name + ending);
    }
  }
}

QString flightFolder() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME");
  const QString base = state.isEmpty() ? QDir::homePath() + QStringLiteral("/.local/state") : state;
  return base + QStringLiteral("/relievo/flight");
}

QString recordingHeaderLines(const QString& from_host, const QString& device,
                             const HapticOptions& options, SurfaceKind surface,
                             const FirmnessMap* firmness, const QDateTime& now) {
  constexpr std::array<const char*, 3> kProxyNames{"converged", "equation", "successive"};
  const QString stiffness =
      options.stiffness_by_detail
          ? QStringLiteral("by detail")
          : QString::number(options.force.stiffness_n_per_mm) + QStringLiteral(" N/mm");
  QStringList lines{
      QStringLiteral("relievo recording, schema 1"),
      QStringLiteral("version ") + QStringLiteral(RELIEVO_VERSION_STRING),
      QString::fromStdString(lawLine()),
      QStringLiteral("start ") + now.toUTC().toString(Qt::ISODateWithMs),
      QStringLiteral("device ") + device,
      QStringLiteral("units mm on the object (view), N, s; dev_* in mm of hand"),
      QStringLiteral("proxy %1, stiffness %2, strength %3, limit %4 N")
          .arg(QLatin1String(kProxyNames[static_cast<std::size_t>(options.proxy.kind)]), stiffness)
          .arg(options.force.strength)
          .arg(options.force.limit_n),
      QStringLiteral("surface %1, friction %2 at rest and %3 sliding, damping %4 N s/mm")
          .arg(QString::fromUtf8(name(surface).data(), static_cast<int>(name(surface).size())))
          .arg(options.proxy.static_friction)
          .arg(options.proxy.dynamic_friction)
          .arg(options.force.damping_n_s_per_mm)};
  if (options.force.lift_n > 0) {
    lines << QStringLiteral("grip held with %1 N upward").arg(options.force.lift_n);
  }
  if (options.grip != GripPosition::upright) {
    const std::string_view position = relievo::name(options.grip);
    lines << QStringLiteral("grip position ") +
                 QString::fromLatin1(position.data(), static_cast<int>(position.size()));
  }
  if (firmness != nullptr) {
    lines << QStringLiteral("firmness %1, sha256 %2")
                 .arg(shownFileName(QFile::decodeName(firmness->file.c_str())),
                      QString::fromStdString(firmness->sha256));
  }
  for (const QString& line : from_host.split('\n', Qt::SkipEmptyParts)) {
    // The host's lines may be comments already; the writer adds the sign.
    lines << (line.startsWith(QLatin1String("# ")) ? line.mid(2) : line);
  }
  return lines.join('\n');
}

QString windowLine(const RegionWindow& window) {
  const auto exact = [](double v) { return QString::number(v, 'g', 17); };
  const Region& r = window.region;
  return QStringLiteral("window %1: region_mm %2 %3 %4 level %5 gain %6\n")
      .arg(window.id)
      .arg(exact(r.x_mm), exact(r.y_mm), exact(r.side_mm))
      .arg(r.level.value)
      .arg(exact(window.gain));
}

QString durationText(quint64 samples) {
  const quint64 seconds = samples / 1000;
  if (seconds < 60) return QStringLiteral("%1 s").arg(seconds);
  return QStringLiteral("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

}  // namespace relievo
