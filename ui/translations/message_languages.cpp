// SPDX-License-Identifier: BSD-3-Clause
#include "ui/translations/message_languages.h"

#include <array>

#include "ui/translations/translated_sentences.h"

namespace relievo {

std::span<const MessageLanguage> messageLanguages() {
  static const std::array<MessageLanguage, 3> languages{
      {{},
       {.tag = "de", .sentences = sentencesDe(), .point = ',', .thousands = '.'},
       {.tag = "hi", .sentences = sentencesHi(), .thousands = ',', .zero_is_one = true}}};
  return languages;
}

const MessageLanguage& messageLanguage(std::string_view tag) {
  for (const MessageLanguage& language : messageLanguages()) {
    if (tag.substr(0, tag.find_first_of("_-")) == language.tag) return language;
  }
  return messageLanguages().front();
}

}  // namespace relievo
