// SPDX-License-Identifier: BSD-3-Clause
#include "core/message/message.h"

#include <array>
#include <cstdio>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

std::string textOf(const CountArgument& count) {
  if (!count.is_grouped) return std::to_string(count.value);
  // Of bytes and points, which are never below 0: a damaged header may promise 2^64 - 1.
  std::string digits = std::to_string(static_cast<std::uint64_t>(count.value));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ' ');
  return digits;
}

std::string textOf(const NumberArgument& number) {
  std::array<char, 512> text{};  // The largest double has 309 digits before its point.
  const char* form = number.form == NumberArgument::Form::significant ? "%.*g" : "%.*f";
  std::snprintf(text.data(), text.size(), form, number.digits, number.value);
  std::string digits = text.data();
  if (number.form == NumberArgument::Form::trimmed && digits.find('.') != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
  }
  return digits + std::string(unitText(number.unit));
}

std::string textOf(const PathArgument& path) {
  return path.bytes;
}

std::string textOf(const NameArgument& name) {
  return name.text;
}

std::string textOf(const TextArgument& text) {
  return text.text;
}

std::string textOf(const WordsArgument& words) {
  if (words.form == WordsArgument::Form::sentences) return englishText(words.list);
  std::string text;
  for (const Message& word : words.list) text += (text.empty() ? "" : ", ") + englishText(word);
  if (words.form == WordsArgument::Form::clause && text.ends_with('.')) text.pop_back();
  return text;
}

std::string filled(const char* sentence, const Message& message) {
  const std::string chosen =
      withForms(std::string(sentence), [&](int place) { return isOne(message, place); });
  return filledSentence(chosen, [&](int place) {
    return englishText(message.arguments.at(static_cast<std::size_t>(place) - 1));
  });
}

}  // namespace

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
  return std::visit([](const auto& part) { return textOf(part); }, argument);
}

std::string englishText(const Message& message) {
  return filled(rowOf(message.id).screen, message);
}

std::string englishText(const std::vector<Message>& sentences) {
  std::string text;
  for (const Message& sentence : sentences) {
    text += (text.empty() ? "" : " ") + englishText(sentence);
  }
  return text;
}

std::string englishSpoken(const Message& message) {
  const MessageRow& row = rowOf(message.id);
  return filled(row.spoken[0] == '\0' ? row.screen : row.spoken, message);
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
