// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/message/message.h"

namespace relievo {

/// A sentence of the catalogue and what it is in another language, both as the table has them.
struct TranslatedSentence {
  std::string_view english, translated;
};

/// How a language says the catalogue's messages. The languages there are: ui/translations.
struct MessageLanguage {
  std::string_view tag = "en";                         ///< "de"
  std::span<const TranslatedSentence> sentences = {};  ///< By `english`, ascending; others stay so.
  char point = '.';                                    ///< Of numbers.
  char thousands = ' ';
  bool zero_is_one = false;  ///< Nothing has the form of one: "0 point".
};

/// The sentence for screens and files in that language. [any thread]
std::string textIn(const MessageLanguage& language, const Message& message);
/// For ears: the shorter sentence where the catalogue has one.
std::string spokenIn(const MessageLanguage& language, const Message& message);
/// One after the other.
std::string spokenIn(const MessageLanguage& language, const std::vector<Message>& sentences);
/// As englishText of an argument.
std::string textIn(const MessageLanguage& language, const MessageArgument& argument);

}  // namespace relievo
