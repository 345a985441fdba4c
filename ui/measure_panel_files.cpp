// SPDX-License-Identifier: BSD-3-Clause
// What the list of measurements writes into files.
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/error.h"
#include "core/measure/measure_text.h"
#include "ui/figure/profile_plot.h"
#include "ui/measure_panel.h"

namespace relievo {
namespace {

QString word(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString quoted(QString text) {
  return '"' + text.replace('"', QLatin1String("\"\"")) + '"';
}

QString exact(double value) {
  return QString::number(value, 'g', 10);
}

}  // namespace

std::shared_ptr<const MeasureReadings::Entry> MeasurePanel::readEntry(const Measurement& m) const {
  auto entry = readings_->of(m);
  if (entry) return entry;
  throw ArgumentError(
      tr("%1 is still being read. Nothing was saved. Save again when the list shows its value.")
          .arg(QString::fromStdString(m.name))
          .toStdString());
}

/// What the files were measured on.
QString MeasurePanel::sourceText() const {
  return QStringLiteral("relievo %1, input %2, sha256 %3")
      .arg(QStringLiteral(RELIEVO_VERSION_STRING), QFileInfo(document_.file()).fileName(),
           document_.fileSha256());
}

QString MeasurePanel::csv() const {
  QStringList rows{
      "# " + sourceText(),
      QStringLiteral("name,kind,what,value,uncertainty,unit,not_measured,places_mm,plane")};
  for (const Measurement& m : measurements_) {
    QStringList places;
    for (const PlaceMm& place : m.places) places << exact(place.x) + ' ' + exact(place.y);
    const auto entry = readEntry(m);
    if (!entry->reading) {
      rows << QStringLiteral("# %1: %2").arg(QString::fromStdString(m.name), entry->problem);
      continue;
    }
    for (const Quantity& q : entry->reading->quantities) {
      rows << QStringList{quoted(QString::fromStdString(m.name)),
                          word(name(m.kind)),
                          quoted(word(q.title)),
                          exact(q.value),
                          exact(q.uncertainty),
                          word(q.unit),
                          exact(entry->reading->not_measured),
                          quoted(places.join(QStringLiteral("; "))),
                          QString::fromStdString(planeNumbers(m))}
                  .join(',');
    }
  }
  return rows.join('\n') + '\n';
}

void MeasurePanel::writeSelected(const QString& file) const {
  using enum MeasureKind;
  const auto row = selected();
  const Measurement* m = row ? &measurements_[static_cast<std::size_t>(*row)] : nullptr;
  if (m == nullptr || (m->kind != profile && m->kind != section)) {
    throw ArgumentError(tr("Select a profile or a section in the list first.").toStdString());
  }
  const auto entry = readEntry(*m);
  if (!entry->reading) throw ArgumentError(entry->problem.toStdString());
  const bool svg = file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
  std::string text;
  if (m->kind == section) {
    const std::string title = QFileInfo(document_.file()).fileName().toStdString() + ": " + m->name;
    text = svg ? sectionSvg(entry->reading->curves, planeOf(*m), title)
               : sectionCsv(entry->reading->curves, sourceText().toStdString());
  } else {
    text = svg ? profileSvg(entry->rows)
               : profileCsv(entry->rows, document_.file().toStdString(),
                            document_.fileSha256().toStdString());
  }
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly) ||
      out.write(text.data(), static_cast<qint64>(text.size())) < 0 || !out.commit()) {
    throw WriteError(tr("%1 could not be written. Choose another place.").arg(file).toStdString());
  }
}

}  // namespace relievo
