// SPDX-License-Identifier: BSD-3-Clause
#include "app/plugin_loader.h"

#include <algorithm>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonObject>
#include <QLibrary>

#include "core/base/error.h"

namespace relievo {
namespace {

QString stateKey(const QString& name) {
  return QLatin1String("plugins/") + name;
}

}  // namespace

QStringList PluginLoader::folders() {
  QStringList folders;
  const QString chosen = QString::fromLocal8Bit(qgetenv("RELIEVO_PLUGIN_PATH"));
  folders << chosen.split(':', Qt::SkipEmptyParts);
  const QString program = QCoreApplication::applicationDirPath();
  folders << program + QLatin1String("/../plugins")
          << program + QLatin1String("/" RELIEVO_LIBDIR "/relievo/plugins");
  return folders;
}

PluginLoader::PluginLoader(Host& host, Settings& settings) : host_(host), settings_(settings) {}

PluginLoader::~PluginLoader() {
  detachAll();
}

void PluginLoader::load() {
  for (const QString& folder : folders()) {
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files, QDir::Name)) {
      if (QLibrary::isLibrary(file.fileName())) loadOne(file.absoluteFilePath());
    }
  }
}

void PluginLoader::loadOne(const QString& file) {
  const QString name = QFileInfo(file).completeBaseName();
  if (has(name)) return;
  auto loader = std::make_unique<QPluginLoader>(file);
  loader->setLoadHints(QLibrary::PreventUnloadHint);
  // Read without running a line of the module's code.
  const QString iid = loader->metaData().value(QLatin1String("IID")).toString();
  if (iid != QLatin1String(RELIEVO_PLUGIN_IID)) {
    problems_ << QCoreApplication::translate("PluginLoader", "%1 is no plugin for this version.")
                     .arg(QFileInfo(file).fileName());
    return;
  }
  auto* plugin = qobject_cast<Plugin*>(loader->instance());
  if (plugin == nullptr) {
    problems_ << QCoreApplication::translate("PluginLoader", "%1 cannot be loaded: %2.")
                     .arg(QFileInfo(file).fileName(), loader->errorString());
    return;
  }
  try {
    plugin->attach(host_);
  } catch (const Error& error) {
    problems_ << QCoreApplication::translate("PluginLoader", "%1 cannot start: %2")
                     .arg(name, QString::fromUtf8(error.what()));
    return;
  }
  const QByteArray state = settings_.choice(stateKey(name), QByteArray()).toByteArray();
  if (!state.isEmpty()) plugin->restoreState(QByteArray::fromBase64(state));
  loaded_.push_back({name, std::move(loader), plugin});
  if (host_.shownWindow()) Q_EMIT host_.windowShown(host_.shownWindow());
}

void PluginLoader::detachAll() {
  for (const Loaded& l : loaded_) {
    const QByteArray state = l.plugin->saveState();
    if (!state.isEmpty()) settings_.setChoice(stateKey(l.name), state.toBase64());
    l.plugin->detach();
  }
  loaded_.clear();
}

bool PluginLoader::has(const QString& name) const {
  return std::any_of(loaded_.begin(), loaded_.end(),
                     [&](const Loaded& l) { return l.name.contains(name); });
}

}  // namespace relievo
