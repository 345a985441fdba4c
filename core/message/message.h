// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace relievo {

/// Which sentence of the catalogue; the names are in core/message/catalogue.h.
enum class MessageId : std::uint16_t;

struct Message;

/// How many of something: a whole number.
struct CountArgument {
  template <std::integral Whole>
  CountArgument(Whole whole) : value(static_cast<std::int64_t>(whole)) {}
  /// A number that people compare: English sets its thousands apart ("1 204").
  template <std::integral Whole>
  static CountArgument grouped(Whole whole) {
    CountArgument count(whole);
    count.is_grouped = true;
    return count;
  }
  std::int64_t value;
  bool is_grouped = false;
};

enum class MessageUnit : std::uint8_t { none, millimetre, second, gigabyte, percent, gram, newton };

/// " mm", " GB"; nothing for `none`. The same in every language.
std::string_view unitText(MessageUnit unit);

/// A measured number, with as many digits as are worth reading.
struct NumberArgument {
  enum class Form : std::uint8_t {
    fixed,        ///< `digits` behind the point.
    significant,  ///< `digits` in all, as few as are needed.
    trimmed       ///< As `fixed`, without zeros at the end.
  };
  double value = 0;
  int digits = 0;
  Form form = Form::fixed;
  MessageUnit unit = MessageUnit::none;
};

/// A file or folder, its bytes as the file system has them.
struct PathArgument {
  PathArgument(const std::filesystem::path& path) : bytes(path.native()) {}
  std::string bytes;
};

/// What somebody called something, a file's content, a word of the command line: never translated.
struct NameArgument {
  NameArgument(std::string_view name) : text(name) {}
  NameArgument(std::string name) : text(std::move(name)) {}
  NameArgument(const char* name) : text(name) {}
  std::string text;
};

/// What the system or a library says, in its own words; and sentences that are not yet in the
/// catalogue.
struct TextArgument {
  TextArgument(std::string_view words) : text(words) {}
  TextArgument(std::string words) : text(std::move(words)) {}
  TextArgument(const char* words) : text(words) {}
  std::string text;
};

/// Messages of the catalogue within another: a cause, or a list of words ("left, right").
struct WordsArgument {
  enum class Form : std::uint8_t {
    list,      ///< A comma between two.
    clause,    ///< In brackets or after a colon: without its full stop.
    sentences  ///< One after the other.
  };
  WordsArgument(Message one);
  WordsArgument(std::vector<Message> list);
  static WordsArgument clause(Message sentence);
  static WordsArgument sentences(std::vector<Message> sentences);
  std::vector<Message> list;
  Form form = Form::list;
};

using MessageArgument = std::variant<CountArgument, NumberArgument, PathArgument, NameArgument,
                                     TextArgument, WordsArgument>;

/// A sentence of the catalogue and what stands at its places. Made by `said` (catalogue.h), which
/// takes exactly the arguments that the sentence has. A value: it crosses threads and, as bytes,
/// processes.
struct Message {
  MessageId id{};
  std::vector<MessageArgument> arguments;
};

/// The sentence for terminals, reports and logs. [any thread]
std::string englishText(const Message& message);
/// The same for one argument, and for sentences one after the other.
std::string englishText(const MessageArgument& argument);
std::string englishText(const std::vector<Message>& sentences);
/// Each of them on its own.
std::vector<std::string> englishTexts(const std::vector<Message>& sentences);
/// For ears: the shorter sentence where the catalogue has one.
std::string englishSpoken(const Message& message);
/// "E101", or nothing. It is that of a message within, if this one has none.
std::string codeOf(const Message& message);

/// Which of 1 to 9 a character is; 0: none. `Character` is char or QChar.
template <class Character>
int placeNumber(Character character) {
  for (int number = 1; number <= 9; ++number) {
    if (character == static_cast<char>('0' + number)) return number;
  }
  return 0;
}

/// Forms of number: of "{2|one point|%2 points}" the first part where `is_one(2)`, else the second.
/// Called before the places are filled, so that no name is taken for one.
template <class Text, class IsOne>
Text withForms(const Text& sentence, const IsOne& is_one) {
  Text text;
  const auto size = sentence.size();
  for (decltype(sentence.size()) i = 0; i < size; ++i) {
    const int number = sentence[i] == '{' && i + 2 < size ? placeNumber(sentence[i + 1]) : 0;
    if (number == 0 || sentence[i + 2] != '|') {
      text += sentence[i];
      continue;
    }
    const bool takes_first = is_one(number);
    bool in_first = true;
    for (i += 3; i < size && sentence[i] != '}'; ++i) {
      if (in_first && sentence[i] == '|') {
        in_first = false;
      } else if (in_first == takes_first) {
        text += sentence[i];
      }
    }
  }
  return text;
}

/// Whether the argument at a place is a count of 1; in some languages 0 has the form of 1.
bool isOne(const Message& message, int place, bool zero_is_one = false);

/// The places %1 to %9 of a sentence, taken by `part(number)`; one pass, so that a part may itself
/// contain "%1". `Text` is std::string or QString.
template <class Text, class Part>
Text filledSentence(const Text& sentence, const Part& part) {
  Text text;
  const auto size = sentence.size();
  for (decltype(sentence.size()) i = 0; i < size; ++i) {
    const int number = sentence[i] == '%' && i + 1 < size ? placeNumber(sentence[i + 1]) : 0;
    if (number == 0) {
      text += sentence[i];
      continue;
    }
    text += part(number);
    ++i;
  }
  return text;
}

/// For the way between two processes of one build. [any thread]
std::string messageBytes(const Message& message);
/// @return nothing if the bytes are not exactly a message that `said` could have made
std::optional<Message> messageFromBytes(std::string_view bytes);

}  // namespace relievo
