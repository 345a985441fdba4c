// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "core/message/message.h"

namespace relievo {

/// A message of the catalogue in the program's language: its sentence from Qt Linguist's files,
/// numbers as the locale writes them, names and the system's own words as they are. A sentence
/// without translation is shown in English. [any thread]
QString messageText(const Message& message);
/// Sentences one after the other.
QString messageText(const std::vector<Message>& sentences);
/// The same for ears: the shorter sentence where the catalogue has one.
QString spokenMessage(const Message& message);

}  // namespace relievo
