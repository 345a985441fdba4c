// SPDX-License-Identifier: BSD-3-Clause
#include "ui/translations/message_languages.h"

#include <array>

namespace relievo {
namespace {

#include "translated_sentences.inc"

constexpr std::array<MessageLanguage, 3> kLanguages{
    {{},
     {.tag = "de", .sentences = kSentencesDe, .point = ',', .thousands = '.'},
     {.tag = "hi", .sentences = kSentencesHi, .thousands = ',', .zero_is_one = true}}};

}  // namespace

std::span<const MessageLanguage> messageLanguages() {
  return kLanguages;
}

const MessageLanguage& messageLanguage(std::string_view tag) {
  for (const MessageLanguage& language : kLanguages) {
    if (tag.substr(0, tag.find_first_of("_-")) == language.tag) return language;
  }
  return kLanguages.front();
}

}  // namespace relievo
