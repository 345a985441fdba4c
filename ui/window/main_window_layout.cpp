// SPDX-License-Identifier: BSD-3-Clause
// How the window is laid out and coloured, and what of it is kept between runs.
#include <array>
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenuBar>
#include <QResizeEvent>
#include <QSplitter>
#include <QStatusBar>
#include <QToolBar>

#include "ui/dialogs/preferences_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/overview_inset.h"
#include "ui/frame/side_panels.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/replay_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/light_ball.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {
/// Views of fewer lines of text, their headers among them, show little: with large text and a
/// message above them the plots make room.
constexpr int kLeastViewLines = 8;
}  // namespace

void MainWindow::useThisView() {
  if (!document_.isOpen() || !detail_->isTurned()) return;
  const auto& m = document_.surface()->view_from_file.m;
  const double scale = std::hypot(m[0], m[4], m[8]);
  const Rotation camera = detail_->cameraRotation();
  Rotation turned{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        turned[3 * i + j] += camera[3 * i + k] * m[4 * k + j] / scale;
      }
    }
  }
  document_.setView({"free", turned});
}

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
  reference_box_->setVisible(!on && command("show_reference")->isChecked());
  panels_->setVisible(!on && command("show_panels")->isChecked());
  showPlots();
  inset_->setVisible(on);
  light_ball_->place();
  if (!on) restoreState(layout_before_full_screen_);
  command("full_screen")->setChecked(on);
  detail_->setFocus();
}

void MainWindow::focusNextPart(int direction) {
  // Order of the window: message, toolbar, reference, detail, panels, plot, status.
  const std::array<QWidget*, 8> parts{strip_,  tools_, reference_, detail_,
                                      panels_, plot_,  profile_,   statusBar()};
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
  const ThemeColours& c = currentColours();
  reference_->setBackground(c.viewport);
  detail_->setBackground(c.viewport);
  plot_->takeColours();
  profile_->takeColours();
  replay_->panel()->takeColours();
  for (QLabel* label : {reference_title_, reference_note_, detail_title_, detail_note_}) {
    QPalette quiet = label->palette();
    quiet.setColor(QPalette::WindowText, c.quiet_text);
    label->setPalette(quiet);
  }
}

void MainWindow::showPlots() {
  const QAction* plots = command("show_plots");
  const bool wanted =
      plots->isVisible() && plots->isChecked() && !isFullScreen() && !replay_->showing();
  // The curve was asked for; what is plotted by itself makes room for it first.
  const bool curve_wanted = command("show_profile")->isChecked() && !profile_->isEmpty() &&
                            !isFullScreen() && !replay_->showing();
  const int least = kLeastViewLines * fontMetrics().height();
  int views = rows_->height() - profile_->minimumSizeHint().height() - rows_->handleWidth();
  const bool has_curve = curve_wanted && views >= least;
  profile_->setVisible(has_curve);
  if (!has_curve) views = rows_->height();
  views -= plot_->minimumSizeHint().height() + rows_->handleWidth();
  plot_->setVisible(wanted && views >= least);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  panels_->fitTo(event->size().width());
  QMainWindow::resizeEvent(event);
}

void MainWindow::showPreferences() {
  auto* dialog = new PreferencesDialog(settings_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, &MainWindow::applyPreference);
  connect(dialog, &PreferencesDialog::restartAsked, this,
          [this] { whenNothingIsUnsaved([this] { restart(); }); });
  dialog->show();
}

// What changes by itself at the next start is left out: language, firmware, keeping work.
void MainWindow::applyPreference(const QString& key) {
  if (key == QLatin1String("theme")) {
    setTheme(static_cast<Theme>(settings_.choice(key, 0).toInt()));
  } else if (key == QLatin1String("text_percent")) {
    applyTextSize(settings_.choice(key, kLeastTextPercent).toInt());
    panels_->fitTo(width());
  } else if (key == QLatin1String("size_unit")) {
    setSizeUnit(lengthUnit(settings_.choice(key, QString()).toString().toStdString()));
    showSurface();
    showWindow();
  } else if (key == QLatin1String("recording_kind")) {
    command(recordingEnding() == QLatin1String("h5") ? "record_h5" : "record_csv")
        ->setChecked(true);
  } else if (key == QLatin1String("pointer_mode")) {
    const bool touches = settings_.choice(key, QString()).toString() == QLatin1String("touch");
    looks_after_forces_ = false;
    showPointerMode(touches ? PointerMode::touch : PointerMode::look);
  } else if (key.startsWith(QLatin1String("look_")) || key.startsWith(QLatin1String("touch_")) ||
             key == QLatin1String("wheel_forward")) {
    showBindings();
  } else if (key.startsWith(QLatin1String("stereo_"))) {
    const auto mode =
        stereoMode(settings_.choice(QStringLiteral("stereo_kind"), QStringLiteral("anaglyph"))
                       .toString()
                       .toStdString());
    StereoOptions stereo = document_.project().stereo;
    stereo_panel_->setKind(mode.value_or(StereoMode::anaglyph));
    if (stereo.mode != StereoMode::off) stereo.mode = mode.value_or(StereoMode::anaglyph);
    stereo.eye_angle_deg =
        settings_.choice(QStringLiteral("stereo_angle"), StereoOptions{}.eye_angle_deg).toDouble();
    stereo.automatic_depth = settings_.choice(QStringLiteral("stereo_automatic"), true).toBool();
    stereo.swap_eyes = settings_.choice(QStringLiteral("stereo_swap"), false).toBool();
    stereo_panel_->setComfort(settings_.choice(QStringLiteral("stereo_comfort"), true).toBool());
    document_.edit(
        tr("Stereo"),
        [&](Project& p) {
          p.stereo = stereo;
          p.chosen_eye_angle_deg.reset();
        },
        kMergeStereo);
  }
}

void MainWindow::restoreLayout() {
  restoreGeometry(settings_.layout(QStringLiteral("geometry")).toByteArray());
  restoreState(settings_.layout(QStringLiteral("state")).toByteArray());
  tools_->setVisible(document_.isOpen());  // The state may be of a window with a file.
  views_->restoreState(settings_.layout(QStringLiteral("views")).toByteArray());
  rows_->restoreState(settings_.layout(QStringLiteral("rows")).toByteArray());
  panels_->setFolds(settings_.layout(QStringLiteral("folds")).toStringList());
  for (const char* part : {"show_panels", "show_reference", "show_profile"}) {
    const QVariant shown = settings_.layout(QString::fromLatin1(part));
    if (shown.isValid()) command(part)->setChecked(shown.toBool());
  }
}

void MainWindow::saveLayout() {
  if (isFullScreen()) setFullScreenDetail(false);
  settings_.setLayout(QStringLiteral("geometry"), saveGeometry());
  settings_.setLayout(QStringLiteral("state"), saveState());
  settings_.setLayout(QStringLiteral("views"), views_->saveState());
  settings_.setLayout(QStringLiteral("rows"), rows_->saveState());
  settings_.setLayout(QStringLiteral("folds"), panels_->folds());
  for (const char* part : {"show_panels", "show_reference", "show_profile"}) {
    settings_.setLayout(QString::fromLatin1(part), command(part)->isChecked());
  }
}

}  // namespace relievo
