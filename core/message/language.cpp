// SPDX-License-Identifier: BSD-3-Clause
#include "core/message/language.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

std::string textOf(const MessageLanguage& language, const CountArgument& count) {
  if (!count.is_grouped) return std::to_string(count.value);
  // Of bytes and points, which are never below 0: a damaged header may promise 2^64 - 1.
  std::string digits = std::to_string(static_cast<std::uint64_t>(count.value));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, language.thousands);
  return digits;
}

std::string textOf(const MessageLanguage& language, const NumberArgument& number) {
  std::array<char, 512> text{};  // The largest double has 309 digits before its point.
  const std::chars_format form = number.form == NumberArgument::Form::significant
                                     ? std::chars_format::general
                                     : std::chars_format::fixed;
  // Whatever the locale of the process is: a language has a point of its own.
  char* const end =
      std::to_chars(text.data(), text.data() + text.size(), number.value, form, number.digits).ptr;
  std::string digits(text.data(), end);
  if (number.form == NumberArgument::Form::trimmed && digits.find('.') != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
  }
  std::replace(digits.begin(), digits.end(), '.', language.point);
  return digits + std::string(unitText(number.unit));
}

std::string textOf(const MessageLanguage& /*language*/, const PathArgument& path) {
  return path.bytes;
}

std::string textOf(const MessageLanguage& /*language*/, const NameArgument& name) {
  return name.text;
}

std::string textOf(const MessageLanguage& /*language*/, const TextArgument& text) {
  return text.text;
}

std::string textOf(const MessageLanguage& language, const WordsArgument& words) {
  const bool sentences = words.form == WordsArgument::Form::sentences;
  std::string text;
  for (const Message& word : words.list) {
    if (!text.empty()) text += sentences ? " " : ", ";
    text += textIn(language, word);
  }
  if (words.form != WordsArgument::Form::clause) return text;
  // A full stop in Latin and in Devanagari.
  for (const std::string_view stop : {".", "\u0964"}) {
    if (text.ends_with(stop)) text.erase(text.size() - stop.size());
  }
  return text;
}

std::string filled(const MessageLanguage& language, std::string_view sentence,
                   const Message& message) {
  const auto found = std::lower_bound(
      language.sentences.begin(), language.sentences.end(), sentence,
      [](const TranslatedSentence& s, std::string_view e) { return s.english < e; });
  const bool is_translated = found != language.sentences.end() && found->english == sentence;
  const std::string words(is_translated ? found->translated : sentence);
  // What is not translated counts as English does.
  const bool zero_is_one = is_translated && language.zero_is_one;
  const std::string chosen =
      withForms(words, [&](int place) { return isOne(message, place, zero_is_one); });
  return filledSentence(chosen, [&](int place) {
    return textIn(language, message.arguments.at(static_cast<std::size_t>(place) - 1));
  });
}

}  // namespace

std::string textIn(const MessageLanguage& language, const MessageArgument& argument) {
  return std::visit([&](const auto& part) { return textOf(language, part); }, argument);
}

std::string textIn(const MessageLanguage& language, const Message& message) {
  return filled(language, rowOf(message.id).screen, message);
}

std::string spokenIn(const MessageLanguage& language, const Message& message) {
  const MessageRow& row = rowOf(message.id);
  return filled(language, row.spoken[0] == '\0' ? row.screen : row.spoken, message);
}

std::string spokenIn(const MessageLanguage& language, const std::vector<Message>& sentences) {
  std::string text;
  for (const Message& sentence : sentences) {
    text += (text.empty() ? "" : " ") + spokenIn(language, sentence);
  }
  return text;
}

}  // namespace relievo
