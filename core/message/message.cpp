// SPDX-License-Identifier: BSD-3-Clause
#include "core/message/message.h"

#include <array>

#include "core/message/catalogue.h"
#include "core/message/language.h"

namespace relievo {

WordsArgument::WordsArgument(Message one) : list{std::move(one)} {}

WordsArgument::WordsArgument(std::vector<Message> words) : list(std::move(words)) {}

WordsArgument WordsArgument::clause(Message sentence) {
  WordsArgument words(std::move(sentence));
  words.form = Form::clause;
  return words;
}

WordsArgument WordsArgument::sentences(std::vector<Message> sentences) {
  WordsArgument words(std::move(sentences));
  words.form = Form::sentences;
  return words;
}

bool isOne(const Message& message, int place, bool zero_is_one) {
  const auto* const count =
      std::get_if<CountArgument>(&message.arguments.at(static_cast<std::size_t>(place) - 1));
  return count != nullptr && (count->value == 1 || (zero_is_one && count->value == 0));
}

std::string_view unitText(MessageUnit unit) {
  constexpr std::array<std::string_view, 7> kUnits{"", " mm", " s", " GB", " %", " g", " N"};
  return kUnits.at(static_cast<std::size_t>(unit));
}

std::string englishText(const MessageArgument& argument) {
  return textIn(MessageLanguage{}, argument);
}

std::string englishText(const Message& message) {
  return textIn(MessageLanguage{}, message);
}

std::string englishText(const std::vector<Message>& sentences) {
  std::string text;
  for (const Message& sentence : sentences) {
    text += (text.empty() ? "" : " ") + englishText(sentence);
  }
  return text;
}

std::vector<std::string> englishTexts(const std::vector<Message>& sentences) {
  std::vector<std::string> texts;
  texts.reserve(sentences.size());
  for (const Message& sentence : sentences) texts.push_back(englishText(sentence));
  return texts;
}

std::string englishSpoken(const Message& message) {
  return spokenIn(MessageLanguage{}, message);
}

std::string codeOf(const Message& message) {
  const std::string_view own = rowOf(message.id).code;
  if (!own.empty()) return std::string(own);
  for (const MessageArgument& argument : message.arguments) {
    const auto* const words = std::get_if<WordsArgument>(&argument);
    if (words == nullptr) continue;
    for (const Message& word : words->list) {
      if (std::string code = codeOf(word); !code.empty()) return code;
    }
  }
  return {};
}

}  // namespace relievo
