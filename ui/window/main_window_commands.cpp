// SPDX-License-Identifier: BSD-3-Clause
// The window's commands: every one is an action with a name, found by keys, menus and plugins.
#include <array>
#include <QAction>
#include <QDesktopServices>
#include <QDoubleSpinBox>

#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/command_search.h"
#include "ui/window/main_window.h"
#include "ui/window/manual.h"

namespace relievo {
namespace {

constexpr double kMoveStep = 0.25;  // Of the window's side.
constexpr double kTurnStepDeg = 15;

}  // namespace

void MainWindow::makeCommands() {
  commands_.on(Command::open, this, [this] { chooseFile(); });
  commands_.on(Command::save_project, this, [this] { saveProject(); });
  commands_.on(Command::save_project_as, this, [this] { saveProjectAs(); });
  commands_.on(Command::figure, this, [this] { chooseFigure(); });
  commands_.on(Command::image, this, [this] { chooseImage(); });
  commands_.on(Command::close, this, [this] { closeDocument(); });
  commands_.on(Command::quit, this, [this] { close(); });
  commands_.on(Command::undo, this, [this] {
    const QString step = document_.history().undoText();
    document_.history().undo();
    announce(tr("Undone: %1").arg(step));  // What was said of the step holds no more.
  });
  commands_.on(Command::redo, this, [this] {
    const QString step = document_.history().redoText();
    document_.history().redo();
    announce(tr("Done again: %1").arg(step));
  });
  commands_.on(Command::answer, this, [this] { strip_->takeOffer(); });
  commands_.on(Command::keys, this, [this] { showKeys(); });
  commands_.on(Command::history, this, [this] { showSteps(); });
  commands_.on(Command::preferences, this, [this] { showPreferences(); });
  commands_.on(Command::search_commands, this, [this] {
    auto* search = new CommandSearch(findChildren<QAction*>(), this);
    search->setAttribute(Qt::WA_DeleteOnClose);
    search->show();
  });
  // At the page about what the keyboard is in.
  const auto show_manual = [this](const QWidget* about) {
    const ManualOpening manual =
        openManual(manualTopic(about), manualFolders(), &QDesktopServices::openUrl);
    if (manual.opened) {
      announce(manual.sentence);
    } else {
      strip_->show(manual.sentence);
    }
  };
  commands_.on(Command::manual, this, [this, show_manual] { show_manual(this->focusWidget()); });
  new ManualKey(show_manual, this);
  // Longer than a line of the status bar.
  commands_.on(Command::introduction, this, [this] { strip_->show(introduction()); });
  commands_.on(Command::about, this, [this] { showAbout(); });
  constexpr std::size_t kThemes = 4;
  const int chosen = settings_.choice(QStringLiteral("theme"), 0).toInt();
  for (std::size_t i = 0; i < kThemes; ++i) {
    const Command command = commandAfter(Command::theme_system, i);
    commands_.on(command, this, [this, i] { setTheme(static_cast<Theme>(i)); });
    commands_[command].setChecked(static_cast<int>(i) == chosen);
  }
  makeSurfaceCommands();
  makeWindowCommands();
  makeReliefCommands();
  makeMeasureCommands();
  makePointerCommands();
  makeSuggestCommand();
  makeProfileCommands();
  makeLightCommands();
  makePlaceCommands();
  makePackageCommand();
  makeExportCommand();
  makePrepareCommands();
  makeReplayCommands();
  makeVideoCommands();
}

void MainWindow::makeSurfaceCommands() {
  commands_.on(Command::finer, this, [this] { stepDetail(true); });
  commands_.on(Command::coarser, this, [this] { stepDetail(false); });
  commands_.on(Command::whole, this, [this] {
    if (document_.whole()) announce(tr("Whole object"));
  });
  commands_.on(Command::move_left, this, [this] { moveWindow(-kMoveStep, 0, tr("Left")); });
  commands_.on(Command::move_right, this, [this] { moveWindow(kMoveStep, 0, tr("Right")); });
  commands_.on(Command::move_up, this, [this] { moveWindow(0, kMoveStep, tr("Up")); });
  commands_.on(Command::move_down, this, [this] { moveWindow(0, -kMoveStep, tr("Down")); });
  commands_.on(Command::type_window, this, [this] {
    commands_[Command::show_panels].setChecked(true);
    auto* x = region_panel_->findChild<QDoubleSpinBox*>(QStringLiteral("region_x"));
    x->setFocus();
    x->selectAll();
  });
  commands_.on(Command::depth_map, this, [this] { chooseDepthMap(); });
  commands_.on(Command::units, this, [this] { askUnit(); });
  for (const Command side : {Command::front, Command::back, Command::left, Command::right,
                             Command::top, Command::bottom, Command::automatic}) {
    const std::string view = commands_[side].objectName().toStdString();
    commands_.on(side, this, [this, view] { document_.setView({view, {}}); });
  }
  // Named after where the near side goes, as under a middle drag.
  commands_.on(Command::turn_left, this, [this] { detail_->turnBy(kTurnStepDeg, 0); });
  commands_.on(Command::turn_right, this, [this] { detail_->turnBy(-kTurnStepDeg, 0); });
  commands_.on(Command::turn_up, this, [this] { detail_->turnBy(0, -kTurnStepDeg); });
  commands_.on(Command::turn_down, this, [this] { detail_->turnBy(0, kTurnStepDeg); });
  commands_.on(Command::use_view, this, [this] { useThisView(); });
  commands_.on(Command::engine_cpu, this, [this] { document_.setEngine(QStringLiteral("cpu")); });
  commands_.on(Command::engine_depthbuffer, this,
               [this] { document_.setEngine(QStringLiteral("depthbuffer")); });
}

void MainWindow::stepDetail(bool finer) {
  const bool done = finer ? document_.finer(about()) : document_.coarser(about());
  if (done) {
    announce(tr("Detail %1 of %2").arg(document_.detail()).arg(document_.details()));
  } else {
    announce(finer ? tr("This is the finest detail") : tr("This is the whole object"));
  }
}

void MainWindow::moveWindow(double dx, double dy, const QString& moved) {
  if (!document_.move(dx, dy)) {
    announce(tr("Edge"));
    return;
  }
  const Region& region = document_.project().region;
  announce(tr("%1. Window at %2, %3 mm")
               .arg(moved)
               .arg(region.x_mm, 0, 'f', 1)
               .arg(region.y_mm, 0, 'f', 1));
}

void MainWindow::makeWindowCommands() {
  commands_.on(Command::fit, this, [this] { detail_->straighten(); });
  commands_.onToggled(Command::stereo, this, [this](bool on) { stereo_panel_->setOn(on); });
  commands_[Command::show_panels].setChecked(true);
  commands_.onToggled(Command::show_panels, this, [this](bool on) { panels_->setVisible(on); });
  commands_[Command::show_reference].setChecked(true);
  commands_.onToggled(Command::show_reference, this,
                      [this](bool on) { reference_box_->setVisible(on); });
  commands_[Command::show_plots].setVisible(false);
  commands_.onToggled(Command::show_plots, this, [this](bool) { showPlots(); });
  commands_.on(Command::full_screen, this, [this] { setFullScreenDetail(!isFullScreen()); });
  commands_.on(Command::swap_views, this, [this] {
    QWidget* to = detail_->hasFocus() ? static_cast<QWidget*>(reference_) : detail_;
    to->setFocus(Qt::ShortcutFocusReason);
  });
  commands_.on(Command::next_part, this, [this] { focusNextPart(1); });
  commands_.on(Command::previous_part, this, [this] { focusNextPart(-1); });
}

}  // namespace relievo
