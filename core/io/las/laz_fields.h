// SPDX-License-Identifier: BSD-3-Clause
// Fields that records of all point formats pack in the same way.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/io/las/laz_arithmetic.h"

namespace relievo {

/// Times of pulses: up to four sequences, each by its last steps.
class LazTime {
 public:
  /// In layered records another field says where the time does not change.
  enum class Unchanged { said_here, said_elsewhere };

  LazTime(Unchanged unchanged, std::uint64_t first);
  /// The next time, bits of a double.
  std::uint64_t decode(ArithmeticDecoder& decoder);

 private:
  struct Sequence {
    std::uint64_t time = 0;
    std::int32_t step = 0;
    int far_steps = 0;  ///< In a row.
  };
  bool decodeFirstStep(ArithmeticDecoder& decoder);
  bool decodeStep(ArithmeticDecoder& decoder);
  void advance(std::uint32_t step);
  void advanceFar(std::uint32_t step);
  void jump(ArithmeticDecoder& decoder);

  unsigned shift_;  ///< 1 where a symbol says that the time does not change.
  std::array<Sequence, 4> sequences_;
  std::size_t last_ = 0, newest_ = 0;
  SymbolModel first_steps_, steps_;
  IntegerModel numbers_{32, 9};
};

using LazColour = std::array<std::uint16_t, 3>;  ///< Red, green, blue.

class LazColours {
 public:
  LazColour decode(ArithmeticDecoder& decoder, const LazColour& last);

 private:
  SymbolModel changed_{128};
  std::array<SymbolModel, 6> bytes_;  ///< Low and high of each.
};

/// Near infrared.
class LazInfrared {
 public:
  std::uint16_t decode(ArithmeticDecoder& decoder, std::uint16_t last);

 private:
  SymbolModel changed_{4};
  std::array<SymbolModel, 2> bytes_;
};

/// Where a full waveform is kept, and how it lies: 29 bytes of a record. Pulses follow each other
/// in the file of waveforms, so that most places need one symbol.
class LazWaves {
 public:
  static constexpr std::size_t kBytes = 29;

  /// @param values  of the point before; the next point's afterwards
  void decode(ArithmeticDecoder& decoder, char* values);

 private:
  SymbolModel descriptor_{256};
  std::array<SymbolModel, 4> steps_{SymbolModel(4), SymbolModel(4), SymbolModel(4), SymbolModel(4)};
  IntegerModel distances_{32, 1}, sizes_{32, 1}, returns_{32, 1}, directions_{32, 3};
  unsigned last_step_ = 0;
  std::uint32_t last_distance_ = 0;
};

/// One model for each earlier value of a byte.
class LazBytes {
 public:
  explicit LazBytes(std::size_t earlier, unsigned symbols = 256);
  unsigned decode(ArithmeticDecoder& decoder, std::size_t earlier) {
    return decoder.symbol(models_[earlier]);
  }

 private:
  std::vector<SymbolModel> models_;
};

}  // namespace relievo
