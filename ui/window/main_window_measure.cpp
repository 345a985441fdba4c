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

void MainWindow::makeMeasureCommands() {
  struct Entry {
    MeasureKind kind;
    const char* name;
    QString text, tip;
  };
  const std::array<Entry, 7> entries{
      {{MeasureKind::point, "measure_point", tr("&Point"), tr("Height of one place")},
       {MeasureKind::distance, "measure_distance", tr("&Distance"), tr("Between two places")},
       {MeasureKind::depth, "measure_depth", tr("Depth di&fference"),
        tr("How much higher the second place lies")},
       {MeasureKind::angle, "measure_angle", tr("&Angle"), tr("At the second of three places")},
       {MeasureKind::profile, "measure_profile", tr("P&rofile"), tr("Heights along a line")},
       {MeasureKind::area, "measure_area", tr("Area and &volume"),
        tr("Of a piece of surface above its lowest corner, or another plane")},
       {MeasureKind::section, "measure_section", tr("Se&ction"),
        tr("Where a plane through one, two or three places cuts the surface")}}};
  for (const Entry& e : entries) {
    make({e.name, e.text, {}, e.tip, [this, kind = e.kind] { beginMeasuring(kind); }, {}});
  }
  make({"measure_touch",
        tr("By &touch"),
        {QKeySequence("Ctrl+Alt+M")},
        tr("Taps of the hand that feels the surface give depth differences, strokes profiles"),
        [this] {
          measure_panel_->beginByTouch();
          detail_->setFocus();
        },
        {}});
  make({"measure_save_list",
        tr("&Save\u2026"),
        {},
        tr("The list as CSV, or the selected profile or section as CSV or SVG"),
        [this] { saveMeasurements(); },
        {}});
}

void MainWindow::makeReliefCommands() {
  struct Entry {
    ReliefKind kind;
    QString text, tip;
  };
  const std::array<Entry, kReliefKindNames.size()> entries{
      {{ReliefKind::lit, tr("Shaded re&lief"), tr("Matt stone under lamps")},
       {ReliefKind::height, tr("&Height in colour"), tr("Lit, with a colour for each height")},
       {ReliefKind::hillshade, tr("H&illshade"), tr("Brightness under one light")},
       {ReliefKind::multi_hillshade, tr("Hillshade, &four lights"),
        tr("No direction stays in the dark")},
       {ReliefKind::slope, tr("&Slope"), tr("Steepness in degrees")},
       {ReliefKind::local_relief, tr("Local &relief"), tr("Worn detail without the broad shape")},
       {ReliefKind::sky_view, tr("Sky &view"), tr("How much of the sky each place sees")},
       {ReliefKind::openness, tr("&Openness"), tr("Hollows dark, ridges bright")},
       {ReliefKind::multi_scale, tr("&Deviation, several scales"),
        tr("What stands out from its neighbourhood, at the scale where it does so most")},
       {ReliefKind::curvature, tr("&Curvature, several scales"),
        tr("Ridges and incisions of several widths, however the ground is tilted")},
       {ReliefKind::occlusion, tr("Stone with &ambient occlusion"),
        tr("Lit, and darker in hollows and grooves")},
       {ReliefKind::natural, tr("&Natural colours"), tr("The colours that the scan has")},
       {ReliefKind::intensity, tr("In&tensity"),
        tr("How strongly the scanner's light came back")}}};
  auto* kinds = new QActionGroup(this);
  for (const Entry& e : entries) {
    const std::string name = "relief_" + std::string(relievo::name(e.kind));
    QAction* action = make({name.c_str(),
                            e.text,
                            {},
                            e.tip,
                            [this, kind = e.kind] {
                              chooseLook(tr("Relief image"), [kind](ReliefLook& look) {
                                look.kind = kind;
                                look.range.reset();  // They were values of another kind.
                              });
                            },
                            {},
                            true});
    action->setChecked(e.kind == ReliefKind::lit);
    kinds->addAction(action);
  }
  make({"show_unmeasured",
        tr("Mar&k unmeasured cells"),
        {},
        tr("Cells that were interpolated in colour, with a legend; holes are always hatched"),
        [this] {
          chooseLook(tr("Unmeasured cells"), [this](ReliefLook& look) {
            look.unmeasured = command("show_unmeasured")->isChecked();
          });
        },
        {},
        true});
  const std::array<QString, kColourMapNames.size()> maps{tr("&Grey"), tr("&Viridis"),
                                                         tr("&Cividis"), tr("&Batlow")};
  auto* colours = new QActionGroup(this);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const auto map = static_cast<ColourMap>(i);
    const std::string name = "colours_" + std::string(relievo::name(map));
    QAction* action =
        make({name.c_str(),
              maps[i],
              {},
              tr("Colours that grow lighter in even steps"),
              [this, map] {
                chooseLook(tr("Relief image"), [map](ReliefLook& look) { look.colours = map; });
              },
              {},
              true});
    action->setChecked(map == ReliefLook{}.colours);
    colours->addAction(action);
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
