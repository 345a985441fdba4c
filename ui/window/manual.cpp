// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/manual.h"

#include <array>
#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QUrl>
#include <QWidget>
#include <utility>

namespace relievo {
namespace {

// Those of plugins by their names, since the window does not know them.
constexpr std::array<ManualTopic, 29> kTopics{{
    {"StartPage", "open"},
    {"SurfacePanel", "depth_map"},
    {"DepthMapDialog", "depth_map"},
    {"PrepareDialog", "prepare"},
    {"RegionPanel", "levels"},
    {"ReferenceView", "levels"},
    {"PlacesPanel", "levels"},
    {"SuggestPanel", "levels"},
    {"DetailView", "touch"},
    {"HapticsPanel", "touch"},
    {"ButtonsPanel", "falcon"},
    {"DeviceSetupDialog", "falcon"},
    {"HaplySetupDialog", "devices"},
    {"LoopDetailsDialog", "touch"},
    {"ScopeDialog", "touch"},
    {"NoteDialog", "recording_and_video"},
    {"ReplayPanel", "recording_and_video"},
    {"VideoDialog", "recording_and_video"},
    {"ViewPanel", "relief_images"},
    {"StereoPanel", "stereo"},
    {"GlassesDialog", "stereo"},
    {"MeasurePanel", "measure"},
    {"ProfileStrip", "measure"},
    {"FigureDialog", "figures"},
    {"ImageDialog", "figures"},
    {"PackageDialog", "projects"},
    {"ExportDialog", "window"},
    {"PreferencesDialog", "window"},
    {"KeysSheet", "window"},
}};

constexpr int kNamespace = sizeof("relievo::") - 1;

QString said(const char* text) {
  return QCoreApplication::translate("relievo::Manual", text);
}

}  // namespace

QString manualTopic(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    const QByteArray part = QByteArray(widget->metaObject()->className()).mid(kNamespace);
    for (const ManualTopic& topic : kTopics) {
      if (part == topic.part) return QString::fromLatin1(topic.page);
    }
    // What stands around a dialog is not what it is about.
    if (widget->isWindow()) break;
  }
  return {};
}

std::span<const ManualTopic> manualTopics() {
  return kTopics;
}

QStringList manualFolders() {
  QStringList folders;
  const QByteArray chosen = qgetenv("RELIEVO_MANUAL_PATH");
  if (!chosen.isEmpty()) folders << QString::fromLocal8Bit(chosen);
  // Installed, from libexec/relievo; then in a build tree, from build/PRESET/bin.
  for (const char* folder : {"/../../share/doc/relievo/html", "/../site/html"}) {
    folders << QCoreApplication::applicationDirPath() + QLatin1String(folder);
  }
  return folders;
}

QString manualPage(const QString& topic, const QStringList& folders) {
  for (const QString& folder : folders) {
    const QFileInfo first(folder + QLatin1String("/index.html"));
    if (!first.isFile()) continue;
    const QFileInfo page(QStringLiteral("%1/docs/user/%2.html").arg(folder, topic));
    return (page.isFile() ? page : first).canonicalFilePath();
  }
  return {};
}

ManualOpening openManual(const QString& topic, const QStringList& folders,
                         const std::function<bool(const QUrl&)>& open_url) {
  const QString page = manualPage(topic, folders);
  if (page.isEmpty()) {
    return {false,
            said(QT_TRANSLATE_NOOP(
                "relievo::Manual",
                "The manual is not here. The package relievo brings it, unless the system leaves "
                "out what belongs in /usr/share/doc; in the sources \"cmake --build --preset "
                "release --target site\" makes it, and docs/user has the same as text."))};
  }
  if (!open_url(QUrl::fromLocalFile(page))) {
    return {false, said(QT_TRANSLATE_NOOP("relievo::Manual",
                                          "No browser could be started. Install one, or open this "
                                          "file elsewhere: %1"))
                       .arg(page)};
  }
  return {
      true,
      said(QT_TRANSLATE_NOOP("relievo::Manual", "The manual opens in the browser: %1")).arg(page)};
}

ManualKey::ManualKey(Show show, QObject* parent) : QObject(parent), show_(std::move(show)) {
  qApp->installEventFilter(this);
}

bool ManualKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  if ((static_cast<int>(key->modifiers()) | key->key()) != kKey) return false;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (widget == nullptr || qobject_cast<const QDialog*>(widget->window()) == nullptr) return false;
  show_(widget);
  return true;
}

}  // namespace relievo
