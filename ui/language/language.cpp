// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// Outside of the namespace, as Qt asks: the translations are in this static library.
static void initTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace relievo {
namespace {

constexpr const char* kTranslator = "relievo_language";

/// A folder in place of the built-in one, for translators and tests.
QString folder() {
  const QString chosen = qEnvironmentVariable("RELIEVO_TRANSLATIONS");
  return chosen.isEmpty() ? QStringLiteral(":/translations") : chosen;
}

void install(QCoreApplication& app, const QLocale& locale, const QString& name,
             const QString& from) {
  auto* translator = new QTranslator(&app);
  translator->setObjectName(QString::fromLatin1(kTranslator));
  if (translator->load(locale, name, QStringLiteral("_"), from)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

std::vector<Language> languageList() {
  initTranslations();
  std::vector<Language> languages{{QStringLiteral("en"), QStringLiteral("English")}};
  for (const QString& file : QDir(folder()).entryList({QStringLiteral("relievo_*.qm")})) {
    const QString code = file.section('_', 1).section('.', 0, 0);
    if (code == QLatin1String("en")) continue;  // The plurals of the sources' own language.
    languages.push_back({code, QLocale(code).nativeLanguageName()});
  }
  return languages;
}

void applyLanguage(QCoreApplication& app, const QString& code) {
  initTranslations();
  for (QTranslator* before : app.findChildren<QTranslator*>(QString::fromLatin1(kTranslator))) {
    delete before;  // It takes itself out.
  }
  const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
  if (!code.isEmpty()) QLocale::setDefault(locale);
  if (locale.language() == QLocale::English || locale.language() == QLocale::C) {
    install(app, QLocale(QLocale::English), QStringLiteral("relievo"), folder());
    return;
  }
  // Qt's own dialogs, where the system has them in this language.
  install(app, locale, QStringLiteral("qtbase"),
          QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install(app, locale, QStringLiteral("relievo"), folder());
}

}  // namespace relievo
