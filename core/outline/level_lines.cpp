// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline/level_lines.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace relievo {
namespace {

enum Side : std::uint8_t { kBottom, kRight, kTop, kLeft };

/// A piece of line through a cell, from one of its sides to another.
struct Piece {
  Side from, to;
};

/// What is higher lies left. Bits of `above`: 1 bottom left, 2 bottom right, 4 top right, 8 top
/// left. @return number of pieces
int piecesOf(unsigned above, bool middle_above, std::array<Piece, 2>& pieces) {
  constexpr std::array<Piece, 16> kOne{{{kBottom, kBottom},
                                        {kBottom, kLeft},
                                        {kRight, kBottom},
                                        {kRight, kLeft},
                                        {kTop, kRight},
                                        {kBottom, kBottom},
                                        {kTop, kBottom},
                                        {kTop, kLeft},
                                        {kLeft, kTop},
                                        {kBottom, kTop},
                                        {kBottom, kBottom},
                                        {kRight, kTop},
                                        {kLeft, kRight},
                                        {kBottom, kRight},
                                        {kLeft, kBottom},
                                        {kBottom, kBottom}}};
  constexpr unsigned kNone = 0, kAll = 15, kRising = 5, kFalling = 10;
  if (above == kNone || above == kAll) return 0;
  if (above == kRising) {
    pieces = middle_above ? std::array<Piece, 2>{{{kTop, kLeft}, {kBottom, kRight}}}
                          : std::array<Piece, 2>{{{kBottom, kLeft}, {kTop, kRight}}};
    return 2;
  }
  if (above == kFalling) {
    pieces = middle_above ? std::array<Piece, 2>{{{kLeft, kBottom}, {kRight, kTop}}}
                          : std::array<Piece, 2>{{{kRight, kBottom}, {kLeft, kTop}}};
    return 2;
  }
  pieces[0] = kOne[above];
  return 1;
}

/// The lines as chains of edges between neighbouring samples: edge 2 i goes right from sample i,
/// edge 2 i + 1 goes up.
class Lines {
 public:
  Lines(const Samples& samples, double level) : samples_(samples), level_(level) {
    next_.assign(2 * samples.values.size(), kNone);
    for (int row = 0; row + 1 < samples.rows; ++row) {
      for (int col = 0; col + 1 < samples.cols; ++col) addCell(col, row);
    }
  }

  std::vector<std::vector<SamplePlace>> closed() {
    std::vector<std::vector<SamplePlace>> lines;
    std::vector<bool> seen(next_.size(), false);
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (seen[start] || next_[start] == kNone) continue;
      std::vector<SamplePlace> line;
      std::size_t edge = start;
      while (edge != kNone && !seen[edge]) {
        seen[edge] = true;
        line.push_back(crossing(edge));
        edge = next_[edge];
      }
      if (edge == start) lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t edgeOf(int col, int row, Side side) const {
    switch (side) {
      case kBottom:
        return 2 * samples_.at(col, row);
      case kTop:
        return 2 * samples_.at(col, row + 1);
      case kLeft:
        return 2 * samples_.at(col, row) + 1;
      case kRight:
        break;
    }
    return 2 * samples_.at(col + 1, row) + 1;
  }

  void addCell(int col, int row) {
    const std::array<std::size_t, 4> corners{samples_.at(col, row), samples_.at(col + 1, row),
                                             samples_.at(col + 1, row + 1),
                                             samples_.at(col, row + 1)};
    unsigned above = 0;
    double sum = 0;
    for (unsigned i = 0; i < corners.size(); ++i) {
      if (!samples_.has[corners[i]]) return;
      const double value = samples_.values[corners[i]];
      sum += value;
      if (value > level_) above |= 1U << i;
    }
    std::array<Piece, 2> pieces{};
    const int count = piecesOf(above, sum / 4 > level_, pieces);
    for (int i = 0; i < count; ++i) {
      const Piece& piece = pieces[static_cast<std::size_t>(i)];
      next_[edgeOf(col, row, piece.from)] = edgeOf(col, row, piece.to);
    }
  }

  SamplePlace crossing(std::size_t edge) const {
    const std::size_t from = edge / 2;
    const bool up = edge % 2 == 1;
    const std::size_t to = from + (up ? static_cast<std::size_t>(samples_.cols) : 1);
    const double part =
        (level_ - samples_.values[from]) / (samples_.values[to] - samples_.values[from]);
    const auto cols = static_cast<std::size_t>(samples_.cols);
    const std::size_t cell_row = from / cols;
    const auto col = static_cast<double>(from % cols), row = static_cast<double>(cell_row);
    return up ? SamplePlace{col, row + part} : SamplePlace{col + part, row};
  }

  const Samples& samples_;
  double level_;
  std::vector<std::size_t> next_;  // Of each edge, the one to which the line goes on.
};

}  // namespace

std::vector<std::vector<SamplePlace>> closedLevelLines(const Samples& samples, double level) {
  return Lines(samples, level).closed();
}

double signedArea(const std::vector<SamplePlace>& line) {
  double twice = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const SamplePlace& a = line[i];
    const SamplePlace& b = line[(i + 1) % line.size()];
    twice += a.col * b.row - b.col * a.row;
  }
  return twice / 2;
}

}  // namespace relievo
