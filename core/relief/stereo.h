// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "core/depth/colours/colours.h"
#include "core/relief/look.h"

namespace relievo {

/// How two eyes' pictures become one, on paper and on screens.
enum class StereoPrint { off, grey, half_colour, dubois, side_by_side, over_under, interlaced };
inline constexpr std::array<std::string_view, 7> kStereoPrintNames{
    "off", "grey", "half", "dubois", "sidebyside", "overunder", "interlaced"};
/// Of these the ones that paper can show: alternate rows need a screen's filter.
inline constexpr std::array<std::string_view, 6> kPaperStereoNames{
    "off", "grey", "half", "dubois", "sidebyside", "overunder"};
inline constexpr std::string_view name(StereoPrint print) noexcept {
  return kStereoPrintNames[static_cast<std::size_t>(print)];
}
std::optional<StereoPrint> stereoPrint(std::string_view name);
/// Do the eyes get colours?
constexpr bool keepsColours(StereoPrint print) noexcept {
  return print == StereoPrint::half_colour || print == StereoPrint::dubois;
}
constexpr bool isAnaglyph(StereoPrint print) noexcept {
  return print == StereoPrint::grey || print == StereoPrint::half_colour ||
         print == StereoPrint::dubois;
}

/// Each eye has a place of its own in the picture, not a colour.
constexpr bool isPair(StereoPrint print) noexcept {
  return print == StereoPrint::side_by_side || print == StereoPrint::over_under ||
         print == StereoPrint::interlaced;
}

/// Of these the ones that squeeze the picture: what lies over it would be seen by one eye alone.
constexpr bool showsHalves(StereoPrint print) noexcept {
  return print == StereoPrint::side_by_side || print == StereoPrint::over_under;
}

/// The same way of mixing on screen and on paper.
constexpr StereoPrint printed(StereoMode mode) noexcept {
  return static_cast<StereoPrint>(static_cast<int>(mode));
}

/// Whose picture.
enum class FigureEye {
  both,  ///< As the stereo of the picture says.
  left,  ///< That which the left eye is to see, alone; eyes swapped: the other's.
  right,
};
inline constexpr std::array<std::string_view, 3> kFigureEyeNames{"both", "left", "right"};
inline constexpr std::string_view name(FigureEye eye) noexcept {
  return kFigureEyeNames[static_cast<std::size_t>(eye)];
}
/// Where one eye's picture lies beside that of both: NAME.left.ENDING, NAME.right.ENDING.
/// @param ending  with its point; empty: of a folder
std::filesystem::path eyeFile(std::filesystem::path file, FigureEye eye, std::string_view ending);

/// Mixes two pictures for red (left eye) and cyan glasses into `left`. Grey: both eyes' lightness.
/// Half colour: the left eye's lightness, the right eye's colours. Dubois: least squares through
/// the filters of common glasses, in linear light (Sanders and McAllister 2003).
/// @param left, right  8 bits, colours multiplied by alpha; as many bytes
/// @param channels     4: RGBA; 3: RGB, all opaque
void mixAnaglyph(StereoPrint print, std::span<std::uint8_t> left,
                 std::span<const std::uint8_t> right, std::size_t channels = 4);

/// A picture's pixels, as the two functions below take them.
struct PixelRows {
  int width = 0, height = 0;
  std::size_t channels = 4;
  bool from_bottom = false;  ///< The first row in memory is the lowest, as in OpenGL.
  int first_row = 0;         ///< Of the picture's top on the screen: odd and even rows are its own.
};

/// Two pictures as screens for two eyes take them, in one of the same size, into `left`. Side by
/// side: each squeezed to half the width, the left eye's on the left. Over and under: to half the
/// height, the left eye's above. Interlaced: the left eye has the even rows of the screen.
/// @param left, right  as many bytes, 8 bits each  @pre isPair(print)
void pairPictures(StereoPrint print, std::span<std::uint8_t> left,
                  std::span<const std::uint8_t> right, const PixelRows& rows);

/// Either of the two, as `print` says.
void joinEyes(StereoPrint print, std::span<std::uint8_t> left, std::span<const std::uint8_t> right,
              const PixelRows& rows);

/// A colour that both eyes' pictures have, as it looks in the mixed one: grey in a grey anaglyph.
/// StereoPrint::off and the pairs change nothing.
std::array<std::uint8_t, 3> mixedColour(StereoPrint print, std::array<std::uint8_t, 3> colour);

/// Share of the pixels that red and cyan glasses show to one eye as dark and to the other as
/// bright, because they are a strong red or cyan: half colour and Dubois keep colours, and the eyes
/// then fight instead of seeing depth. Pixels without alpha are stone.
double rivalShare(std::span<const Rgba> colours) noexcept;
inline constexpr double kMostRivalShare = 0.2;  ///< More is worth a warning.

/// What lies farthest from the plane of zero parallax, seen by two eyes.
struct Parallax {
  double paper_mm = 0;    ///< How far apart its two pictures lie.
  double visual_deg = 0;  ///< The angle of that at the viewer's eye.
};
inline constexpr double kComfortDeg = 1;           ///< Beyond, many people see double.
inline constexpr double kReadingDistanceMm = 400;  ///< Of a page.

/// The eyes look along slanted parallel lines that cross on the plane of zero parallax, so that
/// nothing moves up or down and what lies on that plane keeps its place and its size.
/// @param height_mm    greatest distance from the plane of zero parallax, on the object
/// @param paper_per_mm  millimetres of paper per millimetre of object
Parallax parallax(double height_mm, double eye_angle_deg, double paper_per_mm,
                  double distance_mm = kReadingDistanceMm);
/// The largest eye angle, at most `most_deg`, that keeps to kComfortDeg.
double comfortableEyeAngle(double height_mm, double paper_per_mm, double most_deg,
                           double distance_mm = kReadingDistanceMm);
/// Beyond, slopes of more than 60 degrees would be hidden from one of the eyes.
inline constexpr double kMostEyeAngleDeg = 60;
/// The eye angle at which the heights fill the comfortable range: that of kComfortDeg, but at most
/// kMostEyeAngleDeg; of a surface without heights that of StereoOptions.
double automaticEyeAngle(double height_mm, double paper_per_mm,
                         double distance_mm = kReadingDistanceMm);

/// A plane of zero parallax far above or below the heights would move the eyes' pictures out of
/// sight. @throw ArgumentError  farther from them than they reach, or than `side_mm` is wide
void checkZeroPlane(double zero_plane_mm, double low_mm, double high_mm, double side_mm);

}  // namespace relievo
