// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>

namespace relievo {

/// Other words for a command, as other programs and people call it: those of the window's language,
/// and the English ones in any. Empty: there are none. @param command  object name
QString otherWords(const QString& command);
/// Object names of all commands that have some.
QStringList commandsWithOtherWords();

}  // namespace relievo
