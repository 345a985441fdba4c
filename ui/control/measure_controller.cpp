// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/measure_controller.h"

#include <algorithm>
#include <array>
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "core/base/error.h"
#include "core/io/formats/text_file.h"
#include "ui/language/error_text.h"
#include "ui/plots/profile_strip.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr std::array<std::pair<Command, MeasureKind>, 7> kMeasuring{
    {{Command::measure_point, MeasureKind::point},
     {Command::measure_distance, MeasureKind::distance},
     {Command::measure_depth, MeasureKind::depth},
     {Command::measure_angle, MeasureKind::angle},
     {Command::measure_profile, MeasureKind::profile},
     {Command::measure_area, MeasureKind::area},
     {Command::measure_section, MeasureKind::section}}};

}  // namespace

MeasureController::MeasureController(const ControllerParts& parts, MeasurePanel& panel,
                                     ProfileStrip& profile, DetailView& detail,
                                     ReferenceView& reference)
    : Controller(parts), panel_(panel), profile_(profile), detail_(detail), reference_(reference) {
  makeCommands();
  connect(&panel_, &MeasurePanel::changed, this, &MeasureController::show);
  connect(&panel_, &MeasurePanel::said, &messages_, &WindowMessages::announce);
  connect(&panel_, &MeasurePanel::saveAsked, this, &MeasureController::save);
  connect(&detail_, &DetailView::picked, &panel_, &MeasurePanel::addPlace);
  connect(&detail_, &DetailView::pickingEnded, &panel_, &MeasurePanel::finish);
  connect(&profile_, &ProfileStrip::cursorMoved, this, &MeasureController::showProfileCursor);
  connect(&profile_, &ProfileStrip::saveAsked, this, &MeasureController::saveProfile);
  connect(&profile_, &ProfileStrip::closeAsked, this,
          [this] { commands_[Command::show_profile].setChecked(false); });
  connect(&document_, &Document::windowChanged, this, &MeasureController::showProfileMark);
  showProfile();
}

void MeasureController::makeCommands() {
  for (const auto& [command, kind] : kMeasuring) {
    commands_.on(command, this, [this, kind = kind] { begin(kind); });
  }
  commands_.on(Command::measure_touch, this, [this] {
    panel_.beginByTouch();
    detail_.setFocus();
  });
  commands_.on(Command::measure_save_list, this, [this] { save(); });
  commands_.on(Command::profile_save, this, [this] { saveProfile(); });
}

void MeasureController::begin(MeasureKind kind) {
  panel_.begin(kind);
  detail_.setFocus();
}

void MeasureController::show() {
  detail_.setPicking(panel_.measuring() && !panel_.byTouch());
  const auto lines = panel_.lines();
  const auto curves = panel_.curves();
  detail_.setLines(lines, curves);
  reference_.setLines(lines, curves);
  const auto labels = panel_.labels();
  detail_.setLabels(labels);
  reference_.setLabels(labels);
  showProfile();
}

void MeasureController::save() {
  auto* dialog = new QFileDialog(&window_, tr("Save measurements"), folderFor(document_.file()));
  dialog->setObjectName(QStringLiteral("measure_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString list = tr("List of measurements (*.csv)");
  dialog->setNameFilters({list, tr("Selected profile or section (*.csv *.svg)")});
  const QString ending = QStringLiteral("-measurements.csv");
  dialog->selectFile(stemOf(document_.file(), ending) + ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, list](const QString& file) {
    try {
      if (dialog->selectedNameFilter() != list) {
        panel_.writeSelected(file);
      } else {
        writeTextFile(QFile::encodeName(file).toStdString(), panel_.csv(file).toStdString());
      }
      announce(tr("%1 is saved").arg(shownName(file)));
    } catch (const Error& error) {
      messages_.show(spokenError(error));
    }
  });
  dialog->open();
}

void MeasureController::showProfile() {
  const auto row = panel_.shownProfile();
  const QString name =
      row ? QString::fromStdString(panel_.measurements()[static_cast<std::size_t>(*row)].name)
          : QString();
  profile_.show(name, row ? panel_.profileRows(*row) : std::vector<ProfileRow>());
  commands_[Command::profile_save].setEnabled(!profile_.isEmpty());
  Q_EMIT profileChanged();
}

void MeasureController::showProfileMark() {
  std::optional<ViewMm> mark = profile_.cursorAt();
  if (mark) mark->z *= document_.project().gain;
  detail_.setMark(mark);
  reference_.setMark(mark);
}

void MeasureController::showProfileCursor() {
  showProfileMark();
  if (const auto at = profile_.cursorAt()) detail_.carryHandTo(at->x, at->y);
}

void MeasureController::saveProfile() {
  if (profile_.isEmpty()) return;
  auto* dialog = new QFileDialog(&window_, tr("Save profile"), folderFor(document_.file()));
  dialog->setObjectName(QStringLiteral("profile_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("As it is shown (*.svg)"), tr("Its numbers (*.csv)")});
  const QString ending = QStringLiteral("-profile.svg");
  dialog->selectFile(stemOf(document_.file(), ending) + ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    const auto row = panel_.shownProfile();
    if (!row || profile_.isEmpty()) return;
    messages_.tellWritten(file, [this, row = *row, file] {
      if (file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        panel_.writeRow(row, file);
      } else {
        panel_.writeDrawing(profile_.drawing(), file);
      }
    });
  });
  dialog->open();
}

}  // namespace relievo
