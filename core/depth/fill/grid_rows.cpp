// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/grid_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace relievo {
namespace {

static_assert(std::endian::native == std::endian::little);  // Eight bytes are taken as one word.

/// Eight bytes, each 0 or 1, to eight bits.
std::uint64_t bitsOf(std::uint64_t bytes) {
  return bytes * 0x0102040810204080U >> 56U;
}

/// Eight bits to eight bytes, each 0 or 1.
std::uint64_t bytesOf(std::uint64_t bits) {
  const std::uint64_t each_its_own = bits * 0x0101010101010101U & 0x8040201008040201U;
  return (each_its_own + 0x7f7f7f7f7f7f7f7fU) >> 7U & 0x0101010101010101U;
}

void packRow(const std::uint8_t* mask, std::size_t cols, std::uint64_t* words) {
  for (std::size_t col = 0; col < cols; col += 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, mask + col, std::min<std::size_t>(8, cols - col));
    words[col / 64] |= bitsOf(bytes) << col % 64;
  }
}

void unpackRow(const std::uint64_t* words, std::size_t cols, std::uint8_t* mask) {
  for (std::size_t col = 0; col < cols; col += 8) {
    const std::uint64_t bytes = bytesOf(words[col / 64] >> col % 64 & 0xffU);
    std::memcpy(mask + col, &bytes, std::min<std::size_t>(8, cols - col));
  }
}

/// Calls take(word, bits) for every word of such bytes.
template <class Take>
void forWords(std::string_view packed, const Take& take) {
  for (std::size_t i = 0; i < packed.size() / sizeof(std::uint64_t); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, packed.data() + i * sizeof(bits), sizeof(bits));
    take(i, bits);
  }
}

}  // namespace

GridRows GridRows::inMemory(std::span<const float> values, GridSize size) {
  GridRows rows;
  if (values.empty()) return rows;
  rows.all = values.data();
  rows.read = [values, size](int first, int count, float* out) {
    const std::size_t start = size.index({.col = 0, .row = first});
    const std::size_t end = size.index({.col = 0, .row = first + count});
    std::copy_n(values.data() + start, end - start, out);
  };
  return rows;
}

const float* GridRows::rows(int first_row, int count, GridSize size,
                            std::vector<float>& buffer) const {
  if (all != nullptr) return all + size.index({.col = 0, .row = first_row});
  buffer.resize(size.index({.col = 0, .row = count}));
  read(first_row, count, buffer.data());
  return buffer.data();
}

BitRows::BitRows(GridSize size)
    : size_(size),
      words_per_row_(wordsPerRow(size.cols)),
      words_(words_per_row_ * static_cast<std::size_t>(size.rows)) {}

std::size_t BitRows::count() const noexcept {
  std::size_t ones = 0;
  for (const std::uint64_t w : words_) ones += static_cast<std::size_t>(std::popcount(w));
  return ones;
}

int BitRows::countInSquare(Cell lowest, int side) const noexcept {
  const std::size_t first = static_cast<std::size_t>(lowest.col) / 64;
  const std::size_t last = static_cast<std::size_t>(lowest.col + side - 1) / 64;
  const std::uint64_t from = ~std::uint64_t{0} << (static_cast<unsigned>(lowest.col) % 64U);
  const std::uint64_t to =
      ~std::uint64_t{0} >> (63U - static_cast<unsigned>(lowest.col + side - 1) % 64U);
  int ones = 0;
  for (int row = lowest.row; row < lowest.row + side; ++row) {
    const std::uint64_t* const words = &words_[static_cast<std::size_t>(row) * words_per_row_];
    for (std::size_t w = first; w <= last; ++w) {
      std::uint64_t bits = words[w];
      if (w == first) bits &= from;
      if (w == last) bits &= to;
      ones += std::popcount(bits);
    }
  }
  return ones;
}

void BitRows::setRows(int first_row, std::span<const std::uint8_t> mask) noexcept {
  const auto cols = static_cast<std::size_t>(size_.cols);
  std::size_t to = static_cast<std::size_t>(first_row) * words_per_row_;
  for (std::size_t at = 0; at < mask.size(); at += cols, to += words_per_row_) {
    packRow(&mask[at], cols, &words_[to]);
  }
}

void BitRows::setPacked(int first_row, std::string_view packed) noexcept {
  std::uint64_t* const words = &words_[static_cast<std::size_t>(first_row) * words_per_row_];
  forWords(packed, [&](std::size_t i, std::uint64_t bits) { words[i] |= bits; });
}

void BitRows::clear(const BitRows& cells) noexcept {
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~cells.words_[i];
}

std::vector<std::uint8_t> BitRows::bytes(int first_row, int rows) const {
  const auto cols = static_cast<std::size_t>(size_.cols);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(rows) * cols);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    unpackRow(&words_[(static_cast<std::size_t>(first_row) + row) * words_per_row_], cols,
              &bytes[row * cols]);
  }
  return bytes;
}

std::string packedRows(std::span<const std::uint8_t> mask, int cols) {
  const auto width = static_cast<std::size_t>(cols);
  const std::size_t words = BitRows::wordsPerRow(cols);
  std::string packed;
  packed.reserve(mask.size() / width * words * sizeof(std::uint64_t));
  std::vector<std::uint64_t> row(words);
  for (std::size_t at = 0; at < mask.size(); at += width) {
    std::fill(row.begin(), row.end(), 0);
    packRow(&mask[at], width, row.data());
    packed.append(reinterpret_cast<const char*>(row.data()), words * sizeof(std::uint64_t));
  }
  return packed;
}

std::size_t onesIn(std::string_view packed) noexcept {
  std::size_t ones = 0;
  forWords(packed, [&](std::size_t, std::uint64_t bits) {
    ones += static_cast<std::size_t>(std::popcount(bits));
  });
  return ones;
}

}  // namespace relievo
