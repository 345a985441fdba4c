// SPDX-License-Identifier: BSD-3-Clause
// What the list of measurements writes into files.
#include <QFile>
#include <QFileInfo>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/io/formats/text_file.h"
#include "core/measure/measure_text.h"
#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "core/provenance/sha256.h"
#include "ui/figure/profile_plot.h"
#include "ui/panels/measure_panel.h"
#include "ui/work/file_names.h"

namespace relievo {

std::shared_ptr<const MeasureReadings::Entry> MeasurePanel::readEntry(const Measurement& m) const {
  auto entry = readings_->of(m);
  if (entry) return entry;
  throw failure<MessageId::measurement_not_read>(m.name);
}

/// What a file was measured on: in words, and as the line that brings the map back.
/// @throw ArgumentError  it would take the scan's place
std::string MeasurePanel::stateFor(const QString& file) const {
  Provenance made = document_.provenanceIn(file);
  made.view.reset();  // Of the map, whatever is shown of it.
  return toJson(made, -1);
}

QString MeasurePanel::sourceText(const QString& file) const {
  requireNotAnInput(QFile::encodeName(file).toStdString(),
                    {{.file = QFile::encodeName(document_.file()).toStdString()}});
  return QStringLiteral("relievo %1, input %2, sha256 %3\n%4")
      .arg(QStringLiteral(RELIEVO_VERSION_STRING), wholeName(document_.file()),
           document_.fileSha256(), QString::fromStdString(stateLine(stateFor(file))));
}

QString MeasurePanel::csv(const QString& file) const {
  std::vector<Measured> list;
  for (const Measurement& m : measurements()) {
    const auto entry = readEntry(m);
    list.push_back(
        {.measurement = m, .reading = entry->reading, .problem = entry->problem.toStdString()});
  }
  return QString::fromStdString(measurementsCsv(list, sourceText(file).toStdString()));
}

void MeasurePanel::writeSelected(const QString& file) const {
  writeRow(selected().value_or(-1), file);
}

void MeasurePanel::writeDrawing(const std::string& svg, const QString& file) const {
  sourceText(file);  // Refuses the scan as target.
  writeTextFile(QFile::encodeName(file).toStdString(), withState(svg, stateFor(file)));
}

void MeasurePanel::writeRow(int row, const QString& file) const {
  using enum MeasureKind;
  const Measurement* m = row >= 0 ? &measurements()[static_cast<std::size_t>(row)] : nullptr;
  if (m == nullptr || (m->kind != profile && m->kind != section)) {
    throw failure<MessageId::no_profile_selected>();
  }
  const auto entry = readEntry(*m);
  if (!entry->reading) throw ArgumentError(entry->problem.toStdString());
  const bool svg = file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
  std::string text;
  const std::string source = sourceText(file).toStdString();  // Refuses the scan as target.
  const std::string state = stateFor(file);
  if (m->kind == section) {
    const std::string title = wholeName(document_.file()).toStdString() + ": " + m->name;
    text = svg ? withState(sectionSvg(entry->reading->curves, planeOf(*m), title), state)
               : sectionCsv(entry->reading->curves, source);
  } else {
    text = svg ? withState(profileSvg(entry->rows), state) : profileCsv(entry->rows, source);
  }
  writeTextFile(QFile::encodeName(file).toStdString(), text);
}

}  // namespace relievo
