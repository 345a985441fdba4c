// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/stereo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double linearOf(std::uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t byteOf(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double coded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * coded));
}

const std::array<double, 256>& linearTable() {
  static const std::array<double, 256> kTable = [] {
    std::array<double, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = linearOf(static_cast<std::uint8_t>(i));
    return t;
  }();
  return kTable;
}

/// 4096 steps of linear light are finer than 8 bits of sRGB anywhere but in the darkest three.
std::uint8_t codedOf(double linear) {
  constexpr int kSteps = 4096;
  static const std::array<std::uint8_t, kSteps + 1> kTable = [] {
    std::array<std::uint8_t, kSteps + 1> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = byteOf(static_cast<double>(i) / kSteps);
    return t;
  }();
  // Not std::lround: it is a call, and each picture makes three a pixel.
  const double rounded = std::clamp(linear, 0.0, 1.0) * kSteps + 0.5;
  return kTable[static_cast<std::size_t>(rounded)];
}

using Pixel = std::array<double, 3>;

double luminance(const Pixel& p) {
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

Pixel mixed(StereoPrint print, const Pixel& left, const Pixel& right) {
  if (print == StereoPrint::grey) {
    const double r = luminance(right);
    return {luminance(left), r, r};
  }
  if (print == StereoPrint::half_colour) return {luminance(left), right[1], right[2]};
  using Row = std::array<double, 6>;  // Of left red, green, blue, right red, green, blue.
  constexpr std::array<Row, 3> kDubois{{{0.456, 0.500, 0.176, -0.043, -0.088, -0.002},
                                        {-0.040, -0.038, -0.016, 0.378, 0.734, -0.018},
                                        {-0.015, -0.021, -0.005, -0.072, -0.113, 1.226}}};
  Pixel out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      out[i] += kDubois[i][k] * left[k] + kDubois[i][k + 3] * right[k];
    }
  }
  return out;
}

}  // namespace

std::optional<StereoMode> stereoMode(std::string_view name) {
  const auto* const found = std::find(kStereoModeNames.begin(), kStereoModeNames.end(), name);
  if (found == kStereoModeNames.end()) return std::nullopt;
  return static_cast<StereoMode>(found - kStereoModeNames.begin());
}

std::filesystem::path eyeFile(std::filesystem::path file, FigureEye eye, std::string_view ending) {
  return file.replace_extension("." + std::string(name(eye)) + std::string(ending));
}

std::optional<StereoPrint> stereoPrint(std::string_view name) {
  const auto* const found = std::find(kStereoPrintNames.begin(), kStereoPrintNames.end(), name);
  if (found == kStereoPrintNames.end()) return std::nullopt;
  return static_cast<StereoPrint>(found - kStereoPrintNames.begin());
}

void mixAnaglyph(StereoPrint print, std::span<std::uint8_t> left,
                 std::span<const std::uint8_t> right, std::size_t channels) {
  if (left.size() != right.size() || left.size() % channels != 0) {
    throw failure<MessageId::anaglyph_of_two_sizes>();
  }
  const auto& linear = linearTable();
  for (std::size_t i = 0; i < left.size(); i += channels) {
    const Pixel l{linear[left[i]], linear[left[i + 1]], linear[left[i + 2]]};
    const Pixel r{linear[right[i]], linear[right[i + 1]], linear[right[i + 2]]};
    const Pixel out = mixed(print, l, r);
    // Where either eye sees the relief the page must not shine through.
    if (channels == 4) left[i + 3] = std::max(left[i + 3], right[i + 3]);
    const std::uint8_t most = channels == 4 ? left[i + 3] : 255;
    for (std::size_t k = 0; k < 3; ++k) left[i + k] = std::min(codedOf(out[k]), most);
  }
}

namespace {

/// The mean of a rectangle of a picture's pixels, for every channel.
class Squeezed {
 public:
  Squeezed(std::span<const std::uint8_t> from, const PixelRows& rows) : from_(from), rows_(rows) {}
  std::uint8_t at(int first_col, int cols, int first_row, int rows, std::size_t channel) const {
    unsigned sum = 0;
    for (int row = first_row; row < first_row + rows; ++row) {
      for (int col = first_col; col < first_col + cols; ++col) {
        sum += from_[rows_.channels *
                         (static_cast<std::size_t>(row) * static_cast<std::size_t>(rows_.width) +
                          static_cast<std::size_t>(col)) +
                     channel];
      }
    }
    const auto count = static_cast<unsigned>(cols * rows);
    return static_cast<std::uint8_t>((sum + count / 2) / count);
  }

 private:
  std::span<const std::uint8_t> from_;
  PixelRows rows_;
};

/// Which pixels of `all` a pixel of `part` stands for.
struct Stretch {
  int first = 0, count = 1;
  Stretch(int index, int part, int all)
      : first(static_cast<int>(std::int64_t{index} * all / part)),
        count(std::max(1, static_cast<int>((std::int64_t{index} + 1) * all / part) - first)) {}
};

}  // namespace

void pairPictures(StereoPrint print, std::span<std::uint8_t> left,
                  std::span<const std::uint8_t> right, const PixelRows& rows) {
  const int w = rows.width, h = rows.height;
  if (left.size() != right.size() ||
      left.size() != rows.channels * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
    throw failure<MessageId::anaglyph_of_two_sizes>();
  }
  const std::vector<std::uint8_t> whole_left(left.begin(), left.end());
  const std::array<Squeezed, 2> eyes{Squeezed(whole_left, rows), Squeezed(right, rows)};
  const bool beside = print == StereoPrint::side_by_side, over = print == StereoPrint::over_under;
  for (int stored = 0; stored < h; ++stored) {
    const int row = rows.from_bottom ? h - 1 - stored : stored;  // From the top.
    for (int col = 0; col < w; ++col) {
      // An odd pixel in the middle belongs to the second.
      const bool second = beside ? col >= w / 2
                          : over ? row >= h / 2
                                 : (row + rows.first_row) % 2 != 0;
      const int cols_of = beside ? (second ? w - w / 2 : w / 2) : w;
      const int rows_of = over ? (second ? h - h / 2 : h / 2) : h;
      const Stretch across(beside && second ? col - w / 2 : col, cols_of, w);
      const Stretch down(over && second ? row - h / 2 : row, rows_of, h);
      const int from = rows.from_bottom ? h - down.first - down.count : down.first;
      for (std::size_t k = 0; k < rows.channels; ++k) {
        left[rows.channels * (static_cast<std::size_t>(stored) * static_cast<std::size_t>(w) +
                              static_cast<std::size_t>(col)) +
             k] = eyes[second ? 1 : 0].at(across.first, across.count, from, down.count, k);
      }
    }
  }
}

void joinEyes(StereoPrint print, std::span<std::uint8_t> left, std::span<const std::uint8_t> right,
              const PixelRows& rows) {
  if (isPair(print)) {
    pairPictures(print, left, right, rows);
  } else {
    mixAnaglyph(print, left, right, rows.channels);
  }
}

std::array<std::uint8_t, 3> mixedColour(StereoPrint print, std::array<std::uint8_t, 3> colour) {
  if (!isAnaglyph(print)) return colour;
  mixAnaglyph(print, colour, std::array(colour), colour.size());
  return colour;
}

double rivalShare(std::span<const Rgba> colours) noexcept {
  constexpr int kDarkest = 64;         // Darker than that it is dark for both.
  constexpr double kSaturation = 0.6;  // Of a hue within 30 degrees of red or cyan.
  const auto is_rival = [](const Rgba& c) {
    const auto [low, high] = std::minmax({int{c[0]}, int{c[1]}, int{c[2]}});
    if (c[3] == 0 || high < kDarkest || high - low < kSaturation * high) return false;
    return (c[0] == high || c[0] == low) && 2 * std::abs(c[1] - c[2]) < high - low;
  };
  const auto rivals = std::count_if(colours.begin(), colours.end(), is_rival);
  return static_cast<double>(rivals) /
         static_cast<double>(std::max<std::size_t>(colours.size(), 1));
}

Parallax parallax(double height_mm, double eye_angle_deg, double paper_per_mm, double distance_mm) {
  const double paper = 2 * height_mm * std::tan(0.5 * eye_angle_deg * kDegree) * paper_per_mm;
  return {.paper_mm = paper, .visual_deg = 2 * std::atan(0.5 * paper / distance_mm) / kDegree};
}

double comfortableEyeAngle(double height_mm, double paper_per_mm, double most_deg,
                           double distance_mm) {
  const double paper = 2 * distance_mm * std::tan(0.5 * kComfortDeg * kDegree);
  const double tangent = paper / std::max(2 * height_mm * paper_per_mm, 1e-12);
  if (tangent >= std::tan(0.5 * most_deg * kDegree)) return most_deg;
  return 2 * std::atan(tangent) / kDegree;
}

double automaticEyeAngle(double height_mm, double paper_per_mm, double distance_mm) {
  if (!(height_mm > 0) || !(paper_per_mm > 0)) return StereoOptions{}.eye_angle_deg;
  return comfortableEyeAngle(height_mm, paper_per_mm, kMostEyeAngleDeg, distance_mm);
}

void checkZeroPlane(double zero_plane_mm, double low_mm, double high_mm, double side_mm) {
  const double margin = std::max(high_mm - low_mm, side_mm);
  if (zero_plane_mm >= low_mm - margin && zero_plane_mm <= high_mm + margin) return;
  const auto shown = [](double mm) {
    return NumberArgument{.value = mm, .digits = 6, .form = NumberArgument::Form::significant};
  };
  throw failure<MessageId::zero_plane_far>(shown(zero_plane_mm), shown(low_mm), shown(high_mm));
}

}  // namespace relievo
