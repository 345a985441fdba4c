// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <vector>

class QCoreApplication;

namespace relievo {

struct Language {
  QString code;  ///< "de"
  QString name;  ///< In itself: "Deutsch".
};
/// English and every language that the program was built with.
std::vector<Language> languageList();

/// Makes the window speak a language from now on, in place of the one before. Widgets keep the
/// words that they were made with; what is said afterwards is in the new one. Texts that a
/// translation lacks stay English. @param code  empty: the system's
void applyLanguage(QCoreApplication& app, const QString& code);

}  // namespace relievo
