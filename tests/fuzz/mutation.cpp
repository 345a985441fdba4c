// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo::fuzz {
namespace {

using Span = std::pair<std::size_t, std::size_t>;  ///< First byte and length.

/// Runs of decimal digits with what may belong to a number around them.
std::vector<Span> numbersOf(const std::string& text) {
  constexpr std::string_view kOfNumbers = "+-.0123456789eE";
  std::vector<Span> numbers;
  for (std::size_t at = 0; at < text.size();) {
    at = text.find_first_of("-.0123456789", at);
    if (at == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_not_of(kOfNumbers, at), text.size());
    const bool digits = std::any_of(text.begin() + static_cast<std::ptrdiff_t>(at),
                                    text.begin() + static_cast<std::ptrdiff_t>(end),
                                    [](char c) { return c >= '0' && c <= '9'; });
    if (digits) numbers.emplace_back(at, end - at);
    at = end;
  }
  return numbers;
}

std::string otherNumber(const std::string& old, Chance& chance) {
  constexpr std::array<std::string_view, 12> kOdd{
      "nan", "1e308", "-1e308", "1e-320", "-0", "0.5", "1e30", "", "1e400", "inf", "-", "1e-9"};
  const std::uint64_t number = chance.number();
  switch (chance.below(8)) {
    case 0:
      return old.starts_with('-') ? old.substr(1) : "-" + old;
    case 1:
      return std::string(kOdd[chance.below(kOdd.size())]);
    case 2:
      return "-" + std::to_string(number);
    case 3:
      return std::to_string(number) + "." + std::to_string(chance.below(1000));
    default:
      return std::to_string(number);
  }
}

}  // namespace

std::uint64_t Chance::number() {
  if (oneIn(3)) return below(20);
  const std::uint64_t power = std::uint64_t{1} << below(64);
  switch (below(4)) {
    case 0:
      return power;
    case 1:
      return power + 1;
    case 2:
      return power + below(1U << 30U) % power;
    default:
      return power - 1;
  }
}

void mutateBytes(std::string& bytes, std::size_t room) {
  const std::size_t size = bytes.size();
  bytes.resize(size + room);
  if (bytes.empty()) return;
  const std::size_t now =
      LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size());
  bytes.resize(now);
}

bool changeNumber(std::string& text, Chance& chance) {
  const std::vector<Span> numbers = numbersOf(text);
  if (numbers.empty()) return false;
  const auto [at, length] = numbers[chance.below(numbers.size())];
  text.replace(at, length, otherNumber(text.substr(at, length), chance));
  return true;
}

bool moveElement(std::string& text, char open, const std::string& close, Chance& chance) {
  std::vector<Span> pieces;
  for (std::size_t end = text.find(close); end != std::string::npos;
       end = text.find(close, end + 1)) {
    const std::size_t start = text.rfind(open, end);
    if (start != std::string::npos) pieces.emplace_back(start, end + close.size() - start);
  }
  if (pieces.empty()) return false;
  const auto [at, length] = pieces[chance.below(pieces.size())];
  const std::string piece = text.substr(at, length);
  const std::size_t to = pieces[chance.below(pieces.size())].first;
  const std::size_t how = chance.below(3);
  if (how != 0) text.insert(to, piece);
  if (how != 1) text.erase(how == 2 && to <= at ? at + length : at, length);
  return true;
}

std::size_t handBack(const std::string& bytes, std::uint8_t* data, std::size_t size,
                     std::size_t max_size) {
  if (bytes.empty() || bytes.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

}  // namespace relievo::fuzz
