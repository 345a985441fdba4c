// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/name_text.h"

#include <algorithm>
#include <cstddef>

namespace relievo {
namespace {

unsigned byteAt(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// Of the well-formed character at the beginning (Unicode 15, table 3-7); 0: there is none.
std::size_t characterBytes(std::string_view text) {
  const unsigned first = byteAt(text, 0);
  if (first < 0x80) return 1;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return 0;
  const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byteAt(text, 1) < low || byteAt(text, 1) > high) return 0;
  for (std::size_t i = 2; i < bytes; ++i) {
    if (byteAt(text, i) < 0x80 || byteAt(text, i) > 0xBF) return 0;
  }
  return bytes;
}

/// C0 and C1 control characters, delete, and Unicode's ends of lines and paragraphs.
bool isControl(std::string_view character) {
  const unsigned first = byteAt(character, 0);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  if (character.size() == 2) return first == 0xC2 && byteAt(character, 1) < 0xA0;
  return character == "\u2028" || character == "\u2029";
}

/// U+EF80 to U+EFFF, EE BE 80 to EE BF BF.
bool standsForAByte(std::string_view text) {
  return text.size() >= 3 && byteAt(text, 0) == 0xEE &&
         (byteAt(text, 1) == 0xBE || byteAt(text, 1) == 0xBF) && byteAt(text, 2) >= 0x80 &&
         byteAt(text, 2) <= 0xBF;
}

}  // namespace

std::string textOfName(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const std::size_t bytes = characterBytes(name);
    if (bytes > 0 && !standsForAByte(name)) {
      text += name.substr(0, bytes);
      name.remove_prefix(bytes);
      continue;
    }
    const unsigned byte = byteAt(name, 0);
    text += "\xEE";
    text += static_cast<char>(byte < 0xC0 ? 0xBE : 0xBF);
    text += static_cast<char>(0x80 | (byte & 0x3FU));
    name.remove_prefix(1);
  }
  return text;
}

std::string nameFromText(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const bool is_byte = standsForAByte(text);
    name +=
        is_byte
            ? static_cast<char>((byteAt(text, 1) == 0xBE ? 0x80 : 0xC0) | (byteAt(text, 2) & 0x3FU))
            : text[0];
    text.remove_prefix(is_byte ? 3 : 1);
  }
  return name;
}

std::string escapedName(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  while (!name.empty()) {
    const std::size_t bytes = characterBytes(name);
    const std::string_view character = name.substr(0, std::max<std::size_t>(bytes, 1));
    name.remove_prefix(character.size());
    if (bytes > 0 && !isControl(character)) {
      text += character;
      continue;
    }
    for (std::size_t i = 0; i < character.size(); ++i) {
      text += '%';
      text += kDigits[byteAt(character, i) >> 4U];
      text += kDigits[byteAt(character, i) & 0xFU];
    }
  }
  return text;
}

}  // namespace relievo
