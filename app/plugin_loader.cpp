// SPDX-License-Identifier: BSD-3-Clause
#include "app/plugin_loader.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonObject>
#include <QLibrary>
#include <string_view>

#include "core/base/failure.h"
#include "ui/message/message_text.h"

namespace relievo {
namespace {

constexpr std::string_view kInterface = RELIEVO_PLUGIN_IID, kVersion = RELIEVO_PLUGIN_VERSION;

QString stateKey(const QString& name) {
  return QLatin1String("plugins/") + name;
}

/// What a call of a plugin threw; nothing if it did not.
template <class Call>
std::optional<Message> thrownBy(const Call& call) {
  try {
    call();
    return std::nullopt;
  } catch (const std::exception& error) {
    return messageOf(error);
  } catch (...) {  // A plugin by others may throw anything.
    return said<MessageId::plugin_threw_unknown>();
  }
}

/// Why a file is not loaded; nothing: it says that it is a plugin for this program.
std::optional<Message> refusal(const std::filesystem::path& file, std::string_view interface) {
  if (interface == kInterface) return std::nullopt;
  constexpr std::string_view kOfAnyVersion = kInterface.substr(0, kInterface.rfind('/') + 1);
  if (!interface.starts_with(kOfAnyVersion)) {
    return said<MessageId::plugin_of_another_program>(file);
  }
  const std::string_view version = interface.substr(kOfAnyVersion.size());
  return said<MessageId::plugin_of_another_version>(file, version, kVersion);
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

PluginLoader::PluginLoader(WindowHost& host, Settings& settings)
    : host_(host), settings_(settings) {}

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
  const std::filesystem::path path = QFile::encodeName(QFileInfo(file).fileName()).toStdString();
  // Read without running a line of the module's code.
  const QString iid = loader->metaData().value(QLatin1String("IID")).toString();
  if (const auto refused = refusal(path, iid.toStdString())) {
    problems_ << messageText(*refused);
    return;
  }
  Plugin* plugin = nullptr;
  const auto thrown = thrownBy([&] { plugin = qobject_cast<Plugin*>(loader->instance()); });
  if (thrown) {
    problems_ << messageText(
        said<MessageId::plugin_not_started>(name.toStdString(), WordsArgument::clause(*thrown)));
    return;
  }
  if (plugin == nullptr) {
    problems_ << messageText(
        said<MessageId::plugin_not_loadable>(path, loader->errorString().toStdString()));
    return;
  }
  Loaded loaded{name, std::move(loader), plugin};
  if (!attach(loaded)) return leaveOut(loaded);
  host_.keepAdditions();
  loaded_.push_back(std::move(loaded));
}

bool PluginLoader::attach(const Loaded& loaded) {
  const std::string name = loaded.name.toStdString();
  host_.keepAdditions();
  if (const auto thrown = thrownBy([&] { loaded.plugin->attach(host_.parts()); })) {
    problems_ << messageText(
        said<MessageId::plugin_not_started>(name, WordsArgument::clause(*thrown)));
    return false;
  }
  const QByteArray state = settings_.choice(stateKey(loaded.name), QByteArray()).toByteArray();
  const auto refused = thrownBy([&] {
    if (!state.isEmpty()) loaded.plugin->restoreState(QByteArray::fromBase64(state));
  });
  if (refused) {
    problems_ << messageText(
        said<MessageId::plugin_settings_refused>(name, WordsArgument::clause(*refused)));
    return false;
  }
  const auto window = host_.shownWindow();
  const auto at_window = thrownBy([&] {
    if (window) Q_EMIT host_.windowShown(window);
  });
  if (!at_window) return true;
  problems_ << messageText(
      said<MessageId::plugin_not_started>(name, WordsArgument::clause(*at_window)));
  return false;
}

/// Nothing of it stays in the window, and it hears no more of it.
void PluginLoader::leaveOut(const Loaded& loaded) {
  loaded.plugin->detach();
  QObject::disconnect(&host_, nullptr, loaded.loader->instance(), nullptr);
  host_.takeAdditionsBack();
}

void PluginLoader::detachAll() {
  for (const Loaded& l : loaded_) {
    QByteArray state;
    if (const auto thrown = thrownBy([&] { state = l.plugin->saveState(); })) {
      problems_ << messageText(said<MessageId::plugin_settings_lost>(
          l.name.toStdString(), WordsArgument::clause(*thrown)));
    } else if (!state.isEmpty()) {
      settings_.setChoice(stateKey(l.name), state.toBase64());
    }
    l.plugin->detach();
  }
  loaded_.clear();
}

bool PluginLoader::restore(const QString& name, const QByteArray& state) {
  for (const Loaded& l : loaded_) {
    if (l.name != name) continue;
    const auto refused = thrownBy([&] { l.plugin->restoreState(state); });
    if (!refused) return true;
    problems_ << messageText(said<MessageId::plugin_settings_refused>(
        name.toStdString(), WordsArgument::clause(*refused)));
  }
  return false;
}

bool PluginLoader::has(const QString& name) const {
  return std::any_of(loaded_.begin(), loaded_.end(),
                     [&](const Loaded& l) { return l.name == name; });
}

}  // namespace relievo
