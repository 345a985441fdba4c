// SPDX-License-Identifier: BSD-3-Clause
// Commands of measuring and of relief images.
#include <algorithm>
#include <array>
#include <QAction>
#include <QActionGroup>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QScreen>

#include "core/base/error.h"
#include "core/io/formats/text_file.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
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

void MainWindow::makeMeasureCommands() {
  for (const auto& [command, kind] : kMeasuring) {
    commands_.on(command, this, [this, kind = kind] { beginMeasuring(kind); });
  }
  commands_.on(Command::measure_touch, this, [this] {
    measure_panel_->beginByTouch();
    detail_->setFocus();
  });
  commands_.on(Command::measure_save_list, this, [this] { saveMeasurements(); });
}

void MainWindow::makeReliefCommands() {
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    const auto kind = static_cast<ReliefKind>(i);
    const Command command = commandAfter(Command::relief_lit, i);
    commands_.on(command, this, [this, kind] {
      chooseLook(tr("Relief image"), [kind](ReliefLook& look) {
        look.kind = kind;
        look.range.reset();  // They were values of another kind.
      });
    });
    commands_[command].setChecked(kind == ReliefKind::lit);
  }
  commands_.on(Command::show_unmeasured, this, [this] {
    chooseLook(tr("Unmeasured cells"), [this](ReliefLook& look) {
      look.unmeasured = commands_[Command::show_unmeasured].isChecked();
    });
  });
  for (std::size_t i = 0; i < kColourMapNames.size(); ++i) {
    const auto map = static_cast<ColourMap>(i);
    const Command command = commandAfter(Command::colours_grey, i);
    commands_.on(command, this, [this, map] {
      chooseLook(tr("Relief image"), [map](ReliefLook& look) { look.colours = map; });
    });
    commands_[command].setChecked(map == ReliefLook{}.colours);
  }
}

void MainWindow::beginMeasuring(MeasureKind kind) {
  measure_panel_->begin(kind);
  detail_->setFocus();
}

void MainWindow::showMeasurements() {
  detail_->setPicking(measure_panel_->measuring() && !measure_panel_->byTouch());
  const auto lines = measure_panel_->lines();
  const auto curves = measure_panel_->curves();
  detail_->setLines(lines, curves);
  reference_->setLines(lines, curves);
  const auto labels = measure_panel_->labels();
  detail_->setLabels(labels);
  reference_->setLabels(labels);
  showProfile();
}

void MainWindow::saveMeasurements() {
  const QFileInfo input(document_.file());
  auto* dialog = new QFileDialog(this, tr("Save measurements"), input.absolutePath());
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
        measure_panel_->writeSelected(file);
      } else {
        writeTextFile(QFile::encodeName(file).toStdString(),
                      measure_panel_->csv(file).toStdString());
      }
      announce(tr("%1 is saved").arg(shownName(file)));
    } catch (const Error& error) {
      strip_->show(spokenError(error));
    }
  });
  dialog->open();
}

// As it is seen at the views' sizes on this screen.
void MainWindow::showParallax() {
  const auto window = document_.window();
  if (!window) return;
  constexpr double kMmPerInch = 25.4;
  const double screen_mm = kMmPerInch / std::max(screen()->physicalDotsPerInch(), 1.0);
  whole_shown_.screen_per_mm = screen_mm / reference_->mmPerPixel();
  stereo_panel_->setShown({window->min_mm, window->max_mm, screen_mm / detail_->mmPerPixel()});
  reference_->setStereo(stereo_panel_->optionsFor(whole_shown_));
}

}  // namespace relievo
