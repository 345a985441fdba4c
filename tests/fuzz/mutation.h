// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

/// libFuzzer's own mutations, dictionary included. @return  the new size
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace relievo::fuzz {

/// What the custom mutators (LLVMFuzzerCustomMutator) of formats have in common: changes that keep
/// a file's form and reach what is behind it. Repeatable: all chance comes from libFuzzer's seed.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}

  /// 0 ... end - 1; 0 if there is nothing to choose from.
  std::size_t below(std::size_t end) { return end == 0 ? 0 : engine_() % end; }
  bool oneIn(std::size_t n) { return below(n) == 0; }

  /// Near a power of two, or small: where readers of binary numbers change their minds.
  std::uint64_t number();

 private:
  std::minstd_rand engine_;
};

/// libFuzzer's mutations of a part; it may grow by `room` bytes.
void mutateBytes(std::string& bytes, std::size_t room);

/// Another number in place of one of those that `text` holds in decimal digits.
/// @return  false if it holds none
bool changeNumber(std::string& text, Chance& chance);

/// Leaves out, doubles or moves one of the pieces of `text` that begin with `open` and end with
/// `close`. @return  false if there are none
bool moveElement(std::string& text, char open, const std::string& close, Chance& chance);

/// What LLVMFuzzerCustomMutator hands back: `bytes` if they fit, else what libFuzzer makes of the
/// input.
std::size_t handBack(const std::string& bytes, std::uint8_t* data, std::size_t size,
                     std::size_t max_size);

}  // namespace relievo::fuzz
