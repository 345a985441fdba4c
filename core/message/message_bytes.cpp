// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "core/message/catalogue.h"
#include "core/message/message.h"

namespace relievo {
namespace {

constexpr int kDeepest = 8;  // Messages within messages; scan_left_out has five.

template <class Value>
void put(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putText(std::string& bytes, const std::string& text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

void putMessage(std::string& bytes, const Message& message);

void putArgument(std::string& bytes, const CountArgument& count) {
  put(bytes, count.value);
  put(bytes, static_cast<std::uint8_t>(count.is_grouped));
}

void putArgument(std::string& bytes, const NumberArgument& number) {
  put(bytes, number.value);
  put(bytes, static_cast<std::uint8_t>(number.digits));
  put(bytes, static_cast<std::uint8_t>(number.form));
  put(bytes, static_cast<std::uint8_t>(number.unit));
}

void putArgument(std::string& bytes, const PathArgument& path) {
  putText(bytes, path.bytes);
}

void putArgument(std::string& bytes, const NameArgument& name) {
  putText(bytes, name.text);
}

void putArgument(std::string& bytes, const TextArgument& text) {
  putText(bytes, text.text);
}

void putArgument(std::string& bytes, const WordsArgument& words) {
  put(bytes, static_cast<std::uint8_t>(words.form));
  put(bytes, static_cast<std::uint8_t>(words.list.size()));
  for (const Message& word : words.list) putMessage(bytes, word);
}

void putMessage(std::string& bytes, const Message& message) {
  put(bytes, static_cast<std::uint16_t>(message.id));
  for (const MessageArgument& argument : message.arguments) {
    std::visit([&](const auto& part) { putArgument(bytes, part); }, argument);
  }
}

/// Takes values off; after one that is not there, `ok` is false and all further ones are zero.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}
  bool ok() const { return ok_; }
  bool empty() const { return rest_.empty(); }

  template <class Value>
  Value value() {
    Value value{};
    if (const std::string_view raw = take(sizeof value); ok_) {
      std::memcpy(&value, raw.data(), sizeof value);
    }
    return value;
  }

  /// A number that must be below `end`.
  template <class Value>
  Value below(std::size_t end) {
    const auto number = value<Value>();
    ok_ = ok_ && number < end;
    return ok_ ? number : Value{};
  }

  std::string text() { return std::string(take(value<std::uint32_t>())); }

  Message message(int depth) {
    Message made;
    const auto id = below<std::uint16_t>(messageRows().size());
    ok_ = ok_ && depth < kDeepest;
    if (!ok_) return made;
    made.id = static_cast<MessageId>(id);
    for (const std::size_t type : rowOf(made.id).arguments) {
      made.arguments.push_back(argument(type, depth));
    }
    return made;
  }

 private:
  std::string_view take(std::size_t size) {
    ok_ = ok_ && size <= rest_.size();
    if (!ok_) return {};
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  MessageArgument argument(std::size_t type, int depth) {
    if (type == typeOfArgument<CountArgument>()) {
      CountArgument count(value<std::int64_t>());
      count.is_grouped = below<std::uint8_t>(2) == 1;
      return count;
    }
    if (type == typeOfArgument<NumberArgument>()) {
      NumberArgument number{.value = value<double>()};
      number.digits = below<std::uint8_t>(20);
      number.form = static_cast<NumberArgument::Form>(below<std::uint8_t>(3));
      number.unit = static_cast<MessageUnit>(
          below<std::uint8_t>(static_cast<std::size_t>(MessageUnit::newton) + 1));
      return number;
    }
    if (type == typeOfArgument<PathArgument>()) return PathArgument(text());
    if (type == typeOfArgument<NameArgument>()) return NameArgument(text());
    if (type == typeOfArgument<TextArgument>()) return TextArgument(text());
    WordsArgument words{std::vector<Message>()};
    words.form = static_cast<WordsArgument::Form>(below<std::uint8_t>(3));
    for (int left = value<std::uint8_t>(); ok_ && left > 0; --left) {
      words.list.push_back(message(depth + 1));
    }
    return words;
  }

  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace

std::string messageBytes(const Message& message) {
  std::string bytes;
  putMessage(bytes, message);
  return bytes;
}

std::optional<Message> messageFromBytes(std::string_view bytes) {
  Bytes rest(bytes);
  Message message = rest.message(0);
  if (!rest.ok() || !rest.empty()) return std::nullopt;
  return message;
}

}  // namespace relievo
