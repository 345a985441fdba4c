// SPDX-License-Identifier: BSD-3-Clause
// How the window is laid out and coloured, and what of it is kept between runs.
#include <array>
#include <QAction>
#include <QApplication>
#include <QMenuBar>
#include <QResizeEvent>
#include <QStatusBar>
#include <QToolBar>

#include "core/relief/stereo.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/views/scan_view.h"
#include "ui/window/main_window.h"
#include "ui/window/work_area.h"

namespace relievo {
namespace {
/// Shown or not as when the window was closed.
constexpr std::array kKeptParts{Command::show_panels, Command::show_reference,
                                Command::show_profile};
}  // namespace

void MainWindow::setFullScreenDetail(bool on) {
  if (on == isFullScreen()) return;
  if (on) {
    layout_before_full_screen_ = saveState();
    showFullScreen();
  } else {
    showNormal();
  }
  menuBar()->setVisible(!on);
  tools_->setVisible(!on && document_.isOpen());
  area_->showReference(!on && commands_[Command::show_reference].isChecked());
  area_->panels().all->setVisible(!on && commands_[Command::show_panels].isChecked());
  showPlots();
  showAroundDetail();
  if (!on) restoreState(layout_before_full_screen_);
  commands_[Command::full_screen].setChecked(on);
  area_->detail().setFocus();
}

// A screen for two eyes takes the left and the right half of all it shows: then there is nothing
// beside the picture.
void MainWindow::showAroundDetail() {
  if (!controllers_) return;
  const bool halves = showsHalves(printed(document_.project().stereo.mode));
  statusBar()->setVisible(!isFullScreen() || !halves);
  area_->showInset(isFullScreen() && !halves);
  controllers_->look.placeLight();
}

void MainWindow::showScan(bool on) {
  if (on) commands_[Command::show_reference].setChecked(true);
  const bool had_focus =
      area_->besideDetail().isAncestorOf(focusWidget()) || focusWidget() == &area_->besideDetail();
  area_->showScan(on);
  if (had_focus || on) area_->besideDetail().setFocus();
  enableCommands();
  messages_->announce(on ? tr("The scan in 3-D: arrows turn it, Enter makes the relief from there")
                         : tr("Overview"));
}

void MainWindow::focusNextPart(int direction) {
  // Order of the window: message, toolbar, reference, detail, panels, plot, status.
  const std::array<QWidget*, 8> parts{strip_,
                                      tools_,
                                      &area_->besideDetail(),
                                      &area_->detail(),
                                      area_->panels().all,
                                      &area_->plot(),
                                      &area_->profile(),
                                      statusBar()};
  const QWidget* focused = QApplication::focusWidget();
  int now = direction > 0 ? -1 : 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (focused != nullptr && (parts[i] == focused || parts[i]->isAncestorOf(focused))) {
      now = static_cast<int>(i);
    }
  }
  const int count = static_cast<int>(parts.size());
  for (int step = 1; step <= count; ++step) {
    QWidget* part = parts[static_cast<std::size_t>((now + direction * step + 2 * count) % count)];
    if (!part->isVisible()) continue;
    const auto inside = part->findChildren<QWidget*>();
    QWidget* target = (part->focusPolicy() & Qt::TabFocus) != 0 ? part : nullptr;
    if (part == strip_) target = strip_->firstControl();
    for (QWidget* child : inside) {
      if (target != nullptr) break;
      const bool takes =
          child->isVisible() && child->isEnabled() && (child->focusPolicy() & Qt::TabFocus) != 0;
      if (takes) target = child;
    }
    if (target == nullptr) continue;
    target->setFocus(direction > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return;
  }
}

void MainWindow::setTheme(Theme theme) {
  applyTheme(*qApp, theme);
  settings_.setChoice(QStringLiteral("theme"), static_cast<int>(theme));
  area_->takeColours();
}

void MainWindow::showPlots() {
  const QAction& plots = commands_[Command::show_plots];
  const bool has_room = !isFullScreen() && !area_->replay().showing();
  area_->showPlots(commands_[Command::show_profile].isChecked() && has_room,
                   plots.isVisible() && plots.isChecked() && has_room);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  area_->panels().all->fitTo(event->size().width());
  QMainWindow::resizeEvent(event);
}

void MainWindow::showPreferences() {
  auto* dialog = new PreferencesDialog(settings_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, &MainWindow::applyPreference);
  connect(dialog, &PreferencesDialog::said, this,
          [this](const QString& text) { messages_->announce(text); });
  connect(dialog, &PreferencesDialog::restartAsked, this,
          [this] { controllers_->saving.restartWhenNothingIsUnsaved(); });
  dialog->show();
}

// What changes by itself at the next start is left out: language, firmware, keeping work.
void MainWindow::applyPreference(const QString& key) {
  Controllers& c = *controllers_;
  if (key == QLatin1String("theme")) {
    setTheme(static_cast<Theme>(settings_.choice(key, 0).toInt()));
  } else if (key == QLatin1String("text_percent")) {
    applyTextSize(settings_.choice(key, kLeastTextPercent).toInt());
    area_->panels().all->fitTo(width());
  } else if (key == QLatin1String("size_unit")) {
    setSizeUnit(lengthUnit(settings_.choice(key, QString()).toString().toStdString()));
    showSurface();
    showWindow();
  } else if (key == QLatin1String("recording_kind")) {
    c.replays.showKind();
  } else if (key == QLatin1String("pointer_mode")) {
    c.pointer.showKeptMode();
  } else if (key.startsWith(QLatin1String("look_")) || key.startsWith(QLatin1String("touch_")) ||
             key == QLatin1String("wheel_forward")) {
    c.pointer.showBindings();
  } else if (key.startsWith(QLatin1String("stereo_"))) {
    c.look.takeStereoPreferences();
  }
}

void MainWindow::restoreLayout() {
  restoreGeometry(settings_.layout(QStringLiteral("geometry")).toByteArray());
  restoreState(settings_.layout(QStringLiteral("state")).toByteArray());
  tools_->setVisible(document_.isOpen());  // The state may be of a window with a file.
  area_->restoreFrom(settings_);
  for (const Command part : kKeptParts) {
    const QVariant shown = settings_.layout(commands_[part].objectName());
    if (shown.isValid()) commands_[part].setChecked(shown.toBool());
  }
}

void MainWindow::saveLayout() {
  if (isFullScreen()) setFullScreenDetail(false);
  settings_.setLayout(QStringLiteral("geometry"), saveGeometry());
  settings_.setLayout(QStringLiteral("state"), saveState());
  area_->saveTo(settings_);
  for (const Command part : kKeptParts) {
    settings_.setLayout(commands_[part].objectName(), commands_[part].isChecked());
  }
}

}  // namespace relievo
