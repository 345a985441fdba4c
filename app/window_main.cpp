// SPDX-License-Identifier: BSD-3-Clause
#include <QVTKOpenGLNativeWidget.h>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <QFile>
#include <QHash>
#include <QIcon>
#include <QSurfaceFormat>
#include <vector>

#include "app/cli/dependencies.h"
#include "app/cli/options/device_settings.h"
#include "app/cli/options/falcon_setting.h"
#include "app/cli/sound_track.h"
#include "app/cli/state.h"
#include "app/desktop/desktop_recent.h"
#include "app/end_signals.h"
#include "app/exhibit/exhibit_window.h"
#include "app/host.h"
#include "app/options.h"
#include "app/plugin_loader.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/io/worker/reader_guard.h"
#include "ui/frame/accessible_widgets.h"
#include "ui/language/language.h"
#include "ui/message/message_text.h"
#include "ui/views/surface_view.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/display_connection.h"
#include "ui/window/guarded_application.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

// relievo-window: the window. `relievo` goes on as it where no verb is given.
namespace {

constexpr int kUsage = 1;
constexpr int kCannotRead = 2;
constexpr int kNoGraphics = 7;
constexpr int kEndedBySignal = 128;  ///< As shells count it.

void prepareQt() {
  relievo::keepBytesOfNames();
  // VTK draws through GLX.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QCoreApplication::setApplicationName(QStringLiteral("relievo"));
  QCoreApplication::setApplicationVersion(QStringLiteral(RELIEVO_VERSION_STRING));
}

/// A file that a driver keeps, which the command line follows, too.
void shareFile(relievo::MainWindow& window, const char* key,
               const std::function<std::filesystem::path()>& read,
               const std::function<void(const std::filesystem::path&)>& write) {
  window.settings().keepElsewhere(
      QString::fromLatin1(key),
      {[read] { return QFile::decodeName(read().c_str()); },
       [&window, write](const QVariant& file) {
         try {
           write(QFile::encodeName(file.toString()).toStdString());
         } catch (const relievo::Error& error) {
           window.messages().announce(relievo::messageText(relievo::messageOf(error)));
         }
       }});
}

std::vector<relievo::DevicePluginRow> devicePluginRows() {
  std::vector<relievo::DevicePluginRow> rows;
  for (const relievo::batch::DevicePlugin& plugin : relievo::batch::devicePlugins()) {
    relievo::DevicePluginRow row;
    row.name = QString::fromStdString(plugin.name);
    row.file = QFile::decodeName(plugin.file.c_str());
    row.allowed = plugin.allowed;
    // Else something besides the user's word keeps it from running.
    const bool waits_for_user =
        !plugin.why_not || plugin.why_not->id == relievo::MessageId::device_plugin_not_trusted;
    row.can_change = plugin.can_be_allowed && waits_for_user;
    if (!waits_for_user) row.note = relievo::messageText(*plugin.why_not);
    rows.push_back(row);
  }
  return rows;
}

QString allowDevicePlugin(const QString& file, bool allowed) {
  try {
    relievo::batch::allowDevicePlugin(QFile::encodeName(file).toStdString(), allowed);
  } catch (const relievo::Error& error) {
    return relievo::messageText(relievo::messageOf(error));
  }
  return {};
}

/// What is chosen of devices is chosen for `relievo devices`, too.
void shareDevices(relievo::MainWindow& window) {
  using namespace relievo;
  shareFile(window, "falcon_firmware", batch::falconFirmware, batch::setFalconFirmware);
  shareFile(
      window, "force_dimension_library",
      [] { return batch::makersLibrary(batch::kForceDimension); },
      [](const std::filesystem::path& file) {
        batch::setMakersLibrary(batch::kForceDimension, file);
      });
  window.settings().keepDeviceTrust(
      {devicePluginRows, allowDevicePlugin, QFile::decodeName(batch::ownDevicePlugins().c_str())});
}

/// What the command line names.
void openFiles(relievo::MainWindow& window, const relievo::WindowOptions& options) {
  QStringList files;
  for (const std::string& file : options.files) files << QFile::decodeName(file.c_str());
  if (options.saysHow() && files.size() == 1) {
    relievo::OpenRequest request;
    request.file = files.front();
    request.unit = options.unit;
    request.view = options.view;
    request.detail = options.detail;
    request.region = options.region;
    window.open(request);
  } else if (!files.isEmpty()) {
    window.openPaths(files);
  }
}

int runWindow(int argc, char** argv, const relievo::WindowOptions& options,
              const std::optional<relievo::Exhibit>& exhibit) {
  using namespace relievo;
  prepareQt();
  GuardedApplication app(argc, argv);
  QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/relievo.svg")));
  QGuiApplication::setDesktopFileName(QStringLiteral("relievo"));  // Wayland takes the icon by it.
  // QApplication takes the user's locale; the readers need the dot as decimal sign.
  std::setlocale(LC_NUMERIC, "C");
  installAccessibleViews();
  installAccessibleWidgets();

  // Visitors change nothing that the next one finds.
  const auto mode =
      options.safe_mode || exhibit ? Settings::Mode::safe : Settings::Mode::remembered;
  {
    const Settings settings(mode);
    const QString chosen = settings.choice(QStringLiteral("language"), QString()).toString();
    applyLanguage(app, exhibit ? QString::fromStdString(exhibit->languages.front())
                       : options.language.empty() ? chosen
                                                  : QString::fromStdString(options.language));
  }
  MainWindow window(captureDepths, mode);
  shareDevices(window);
  window.settings().shareRecentFiles(
      {[list = DesktopRecent()](const QString& file) { list.add(file); },
       [list = DesktopRecent()] { list.clear(); }});
  window.controllers().packages.setDependencies(batch::dependenciesOf);
  window.controllers().videos.setSound(batch::soundTrackOf);
  WindowHost host(window);
  PluginLoader plugins(host, window.settings());
  QObject::connect(&window, &MainWindow::closing, [&plugins] { plugins.detachAll(); });
  app.tellTo([&window](const QString& sentence) { window.showMessage(sentence); });
  std::unique_ptr<ExhibitWindow> shown;
  const EndSignals end_signals;  // Before a plugin opens a device.
  QObject::connect(&end_signals, &EndSignals::came, [&window, &shown](int signal) {
    shown ? shown->endAtOnce() : window.endAtOnce();
    QApplication::exit(kEndedBySignal + signal);
  });
  window.show();
  plugins.load();
  const QStringList problems = plugins.problems();
  for (const QString& problem : problems) std::cerr << problem.toStdString() << '\n';
  if (!problems.isEmpty()) window.showMessage(problems.join(' '));
  if (!plugins.has(QStringLiteral("haptics_plugin"))) {
    window.controllers().touch.showMissing(problems.isEmpty()
                                               ? MainWindow::tr("the haptics plugin was not found.")
                                               : problems.join(' '));
  }
  if (exhibit) {
    shown = std::make_unique<ExhibitWindow>(window, host, plugins, *exhibit);
  } else {
    openFiles(window, options);
  }
  const int status = QApplication::exec();
  shown.reset();
  app.tellTo({});  // The window goes first.
  for (const QString& problem : plugins.problems().mid(problems.size())) {
    std::cerr << problem.toStdString() << '\n';  // Of its end.
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  relievo::forbidReaders();
  // A file that may not grow is met like a full disk: what is written is completed.
  std::signal(SIGXFSZ, SIG_IGN);
  // The fonts of a PDF stand in the order of a hash: the same figure has the same bytes.
  qSetGlobalQHashSeed(0);
  relievo::WindowOptions options;
  std::optional<relievo::Exhibit> exhibit;
  try {
    options = relievo::parseWindowOptions({argv + 1, argv + argc});
    if (!options.exhibit.empty()) {
      exhibit = relievo::readExhibit(options.exhibit, relievo::exhibitLanguages());
    }
  } catch (const relievo::FileError& error) {
    std::cerr << "relievo: " << error.what() << '\n';
    return kCannotRead;
  } catch (const relievo::ArgumentError& error) {
    std::cerr << "relievo: " << error.what() << '\n';
    return kUsage;
  }
  // Held until the window is there: a server without other clients would reset when this one
  // leaves, and refuse Qt meanwhile.
  const relievo::DisplayConnection display;
  if (!display.isOpen()) {
    std::cerr
        << "relievo: There is no display to open a window on. Set DISPLAY, or use a verb such "
           "as 'relievo render FILE -o FIG.png', which needs none.\n";
    return kNoGraphics;
  }
  return runWindow(argc, argv, options, exhibit);
}
