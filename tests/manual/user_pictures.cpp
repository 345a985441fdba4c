// SPDX-License-Identifier: BSD-3-Clause
// Makes the pictures of the window for docs/user: user_pictures OUT [LANGUAGE]. Target
// `user-pictures` runs it with the others.
#include <QVTKOpenGLNativeWidget.h>
#include <clocale>
#include <functional>
#include <iostream>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "core/project/project.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/language/language.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/views/cloud_view.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/views/scan_view.h"
#include "ui/views/surface_view.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/offscreen.h"
#include "ui/window/main_window.h"

namespace {

using namespace relievo;

constexpr int kMostMs = 60000;
const QString kPanel = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/panel.ply");

void need(bool true_now, const char* what) {
  if (true_now) return;
  std::cerr << "user_pictures: " << what << " did not come.\n";
  std::exit(1);
}

void waitFor(const std::function<bool()>& condition, const char* what) {
  need(QTest::qWaitFor(condition, kMostMs), what);
}

/// One window with its plugins, and its pictures.
class Photographer {
 public:
  explicit Photographer(QString folder)
      : folder_(std::move(folder)), host_(window_), plugins_(host_, window_.settings()) {
    plugins_.load();
    window_.resize(1440, 900);
    window_.show();
    need(QTest::qWaitForWindowExposed(&window_), "the window");
    QApplication::setActiveWindow(&window_);
  }
  ~Photographer() { plugins_.detachAll(); }

  MainWindow& window() { return window_; }
  Document& document() { return window_.document(); }
  DetailView& detail() { return window_.detailView(); }

  void openPanel() {
    OpenRequest request;
    request.file = kPanel;
    request.unit = LengthUnit::mm;
    window_.open(request);
    waitFor([this] { return document().isOpen() && !document().loader().busy(); }, "the panel");
    settle();
  }
  void settle() {
    for (int i = 0; i < 5; ++i) {
      QApplication::processEvents();
      QTest::qWait(60);
    }
  }
  void take(const QString& name) { take(window_, name); }
  void take(QWidget& of, const QString& name) {
    settle();
    need(of.grab().save(folder_ + '/' + name + QLatin1String(".png")), "a picture's file");
  }
  /// A dialog that a command opens, then closed again.
  void takeDialog(const char* command, const QString& name,
                  const std::function<void(QDialog&)>& prepare = {}) {
    need(window_.runCommand(QString::fromLatin1(command)), command);
    QDialog* dialog = nullptr;
    for (auto* d : window_.findChildren<QDialog*>()) {
      if (d->isVisible()) dialog = d;
    }
    need(dialog != nullptr, command);
    settle();
    if (prepare) prepare(*dialog);
    take(*dialog, name);
    dialog->close();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  QPointF over(double x_mm, double y_mm) {
    const Region& r = document().project().region;
    const double mm = r.side_mm / std::min(detail().width() - 4, detail().height() - 4);
    return {0.5 * detail().width() + (x_mm - r.centreX()) / mm,
            0.5 * detail().height() - (y_mm - r.centreY()) / mm};
  }
  static void mouse(QWidget& to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                    Qt::MouseButtons held) {
    QMouseEvent event(type, at, to.mapToGlobal(at.toPoint()), button, held, Qt::NoModifier);
    QApplication::sendEvent(&to, &event);
  }

 private:
  QString folder_;
  MainWindow window_{captureDepths};
  WindowHost host_;
  PluginLoader plugins_;
};

void takeStart(Photographer& p) {
  auto* samples = p.window().findChild<QListWidget*>(QStringLiteral("start_samples"));
  need(samples->count() > 0, "samples");
  waitFor(
      [samples] {
        for (int i = 0; i < samples->count(); ++i) {
          const QImage icon = samples->item(i)->icon().pixmap(80, 60).toImage();
          if (icon.isNull() || qAlpha(icon.pixel(icon.width() / 2, icon.height() / 2)) == 0) {
            return false;
          }
        }
        return true;
      },
      "the samples' pictures");
  p.take(QStringLiteral("start"));
}

void takeRegion(Photographer& p) {
  p.document().region().setRect({60, 60, 120, 120});
  p.settle();
  ReferenceView& view = p.window().referenceView();
  const QPointF from = view.pointOf(120, 120);
  Photographer::mouse(view, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) {
    Photographer::mouse(view, QEvent::MouseMove, from + QPointF(8 * i, -4 * i), Qt::NoButton,
                        Qt::LeftButton);
  }
  p.take(QStringLiteral("region"));
  Photographer::mouse(view, QEvent::MouseButtonRelease, from + QPointF(32, -16), Qt::LeftButton,
                      Qt::NoButton);
}

void takeTouch(Photographer& p) {
  DetailView& view = p.detail();
  view.setFocus();
  const Region& r = p.document().project().region;
  const QPointF middle = p.over(r.centreX(), r.centreY());
  Photographer::mouse(view, QEvent::MouseMove, middle, Qt::NoButton, Qt::NoButton);
  QTest::keyClick(&view, Qt::Key_F5);
  waitFor([&] { return view.sceneState().probe && view.sceneState().probe->forces_on; }, "forces");
  view.turnBy(-25, -35);
  p.settle();
  Photographer::mouse(view, QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton);
  waitFor([&] { return view.sceneState().probe && view.sceneState().probe->touching; }, "contact");
  QTest::qWait(1500);
  p.take(QStringLiteral("touch"));
  Photographer::mouse(view, QEvent::MouseButtonRelease, middle, Qt::LeftButton, Qt::NoButton);
  QTest::keyClick(&view, Qt::Key_Escape);
  view.straighten();
}

/// The scan behind the relief, turned so that its sides are seen.
void takeScan(Photographer& p) {
  p.document().region().setRect({60, 60, 120, 120});
  need(p.window().runCommand(QStringLiteral("show_scan")), "the scan in 3-D");
  auto* scan = p.window().findChild<ScanView*>();
  waitFor([scan] { return scan->cloud()->cloud() != nullptr; }, "the scan's points");
  for (const int key : {Qt::Key_Left, Qt::Key_Left, Qt::Key_Up, Qt::Key_Up}) {
    QTest::keyClick(scan->cloud(), static_cast<Qt::Key>(key));
  }
  QTest::qWait(1500);  // Until it rests, and all of its points are drawn.
  p.take(QStringLiteral("scan_in_3d"));
  p.window().runCommand(QStringLiteral("show_scan"));
  p.document().region().whole();
}

void takeAll(Photographer& p) {
  takeStart(p);
  p.openPanel();
  p.take(QStringLiteral("window"));
  takeScan(p);
  takeRegion(p);
  takeTouch(p);
  p.document().region().whole();
  p.window().runCommand(QStringLiteral("stereo"));
  p.take(QStringLiteral("anaglyph"));
  auto* stereo = p.window().findChild<StereoPanel*>();
  p.take(*stereo, QStringLiteral("panel_stereo"));
  GlassesDialog glasses(false, &p.window());
  glasses.show();
  p.take(glasses, QStringLiteral("glasses"));
  glasses.close();
  p.window().runCommand(QStringLiteral("stereo"));
  p.document().edit({}, [](Project& project) {
    project.measurements = {{"depth", MeasureKind::depth, {{60, 60}, {120, 120}}, 0}};
  });
  p.take(QStringLiteral("measure"));
  auto* places = p.window().findChild<PlacesPanel*>();
  p.document().edit({}, [](Project& project) {
    project.places = {{"head", {.x_mm = 110, .y_mm = 80, .side_mm = 60, .level = Level{0}}},
                      {"rim", {.x_mm = 0, .y_mm = 0, .side_mm = 80, .level = Level{0}}}};
  });
  p.take(*places, QStringLiteral("panel_places"));
  p.takeDialog("depth_map", QStringLiteral("dialog_depth_map"),
               [](QDialog&) { QTest::qWait(4000); });
  p.takeDialog("prepare", QStringLiteral("dialog_prepare"), [](QDialog& dialog) {
    auto& prepare = static_cast<PrepareDialog&>(dialog);
    const auto made = [&] { return !prepare.isStale() && !prepare.isBusy(); };
    waitFor(made, "the scan");
    QMenu* menu = dialog.findChild<QPushButton*>(QStringLiteral("prepare_add_step"))->menu();
    Q_EMIT menu->aboutToShow();
    for (const char* step : {"add_lonely_all", "add_crop_box"}) {
      menu->findChild<QAction*>(QLatin1String(step))->trigger();
      Q_EMIT menu->aboutToShow();
    }
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("crop_x_max"))->setValue(180);
    waitFor(made, "the steps");
    // Where this computer has the panel is nobody's business.
    dialog.findChild<QLineEdit*>(QStringLiteral("prepare_file"))->setText("panel-prepared.ply");
  });
  p.takeDialog("figure", QStringLiteral("dialog_figure"), [](QDialog& dialog) {
    auto* caption = dialog.findChild<QPlainTextEdit*>(QStringLiteral("figure_caption"));
    waitFor([caption] { return !caption->toPlainText().isEmpty(); }, "the caption");
  });
  p.takeDialog("image", QStringLiteral("dialog_image"));
  p.takeDialog("preferences", QStringLiteral("dialog_preferences"));
  p.takeDialog("keys", QStringLiteral("dialog_keys"));
  p.takeDialog("search_commands", QStringLiteral("dialog_search"), [](QDialog& dialog) {
    QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("command_words")), "bookmark");
  });
}

/// What the start says after a crash.
void takeRecovery(const QString& folder, const QString& state) {
  const QString copies = state + QLatin1String("/relievo/autosave");
  QDir().mkpath(copies);
  Project work;
  work.file = kPanel.toStdString();
  work.region = {.x_mm = 0, .y_mm = 0, .side_mm = 80, .level = Level{0}};
  work.history = {"Choose window", "Resolution 2 \u2192 3"};
  writeProject((copies + QLatin1String("/autosave-000001.json")).toStdString(), work);
  QFile lock(copies + QLatin1String("/autosave-000001.lock"));
  need(lock.open(QIODevice::WriteOnly), "the lock");
  Photographer p(folder);
  p.window().resize(1100, 600);
  p.take(QStringLiteral("recovery"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "user_pictures OUT [LANGUAGE]\n";
    return 1;
  }
  const relievo::DisplayGuard display;
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  qputenv("QT_QPA_PLATFORM", "xcb");
  const QTemporaryDir places;
  for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) {
    qputenv(variable, places.filePath(QString::fromLatin1(variable)).toLocal8Bit());
  }
  qputenv("RELIEVO_DATA_PATH", RELIEVO_SOURCE_DIR "/data/samples");
  QApplication app(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  const QString folder = QString::fromLocal8Bit(argv[1]);
  const QString language = argc > 2 ? QString::fromLocal8Bit(argv[2]) : QStringLiteral("en");
  relievo::applyLanguage(app, language);
  relievo::installAccessibleViews();
  QDir().mkpath(folder);
  if (argc > 2) {
    Photographer p(folder);
    p.openPanel();
    p.take(QLatin1String("window_") + language);
    return 0;
  }
  {
    Photographer p(folder);
    takeAll(p);
  }
  takeRecovery(folder, places.filePath(QStringLiteral("XDG_STATE_HOME")));
  return 0;
}
