// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: vertices and faces. Ours rather than PCL's, whose coordinates are float.
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/obj_materials.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kMaxLine = 1 << 20;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

class ObjReader {
 public:
  explicit ObjReader(const ReadJob& job)
      : job_(job), builder_(job.file, job.options), materials_(job, builder_), lines_(job.bytes) {}

  Scan read() {
    builder_.info().format = "OBJ";
    while (nextStatement()) {
      if (lines_.number() % kReportEvery == 0) report();
      std::string_view rest = statement_;
      const std::string_view word = takeWord(rest);
      if (word == "v") readVertex(rest);
      if (word == "f") readFace(rest);
      if (word == "vt") readPlace(rest);
      if (word == "usemtl") texture_ = materials_.use(rest);
      if (word == "mtllib") materials_.readLibraries(rest);
    }
    if (textured_corners_ > 0) {
      builder_.info().colour =
          ColourFact{.source = "texture", .bits = 8, .points = textured_corners_};
    }
    if (builder_.pointCount() == 0) {
      throwReadError(job_.file, said<MessageId::refused_obj_without_vertices>());
    }
    return builder_.finish();
  }

 private:
  void report() const {
    job_.task.check();
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    job_.task.report("reading mesh",
                     static_cast<double>(read) / static_cast<double>(job_.bytes.size()));
  }

  [[noreturn]] void refuseLine(Message finding) const {
    throwReadError(
        job_.file,
        said<MessageId::refused_line>(lines_.number(), shownStart(statement_), std::move(finding)),
        said<MessageId::advice_damaged_export>());
  }

  /// The next line, with those that a backslash continues.
  bool nextStatement() {
    if (!lines_.next()) return false;
    statement_ = lines_.line();
    if (!trimmed(statement_).ends_with('\\')) return checkLength();
    joined_.clear();
    do {
      const std::string_view part = trimmed(lines_.line());
      if (!part.ends_with('\\')) {
        joined_ += part;
        break;
      }
      joined_ += part.substr(0, part.size() - 1);
      joined_ += ' ';
      if (joined_.size() > kMaxLine) break;
    } while (lines_.next());
    statement_ = joined_;
    return checkLength();
  }

  bool checkLength() const {
    if (statement_.size() > kMaxLine) {
      throwReadError(job_.file, said<MessageId::refused_line_of_obj>(lines_.number()),
                     said<MessageId::advice_damaged_export>());
    }
    return true;
  }

  void readVertex(std::string_view rest) {
    std::array<double, 3> p{};
    for (double& coordinate : p) {
      const auto value = parseNumber(takeWord(rest));
      if (!value) refuseLine(said<MessageId::line_without_coordinates>());
      coordinate = *value;
    }
    if (builder_.addPoint(p[0], p[1], p[2])) readColour(rest);
  }

  /// `v x y z r g b`. Four numbers are x y z w, seven x y z w and two more: no colours.
  void readColour(std::string_view rest) {
    std::array<float, 3> colour{};
    for (float& channel : colour) {
      const auto value = parseNumber(takeWord(rest));
      if (!value) return;
      channel = static_cast<float>(*value);
    }
    const std::string_view more = takeWord(rest);
    if (!more.empty() && more.front() != '#') return;
    auto& fact = builder_.info().colour;
    if (!fact) fact = ColourFact{.source = "v x y z r g b", .bits = 8, .points = 0};
    builder_.addWideColour(colour);
  }

  /// `vt u v`, v upward. Only counted until a material with a picture is known.
  void readPlace(std::string_view rest) {
    if (!materials_.hasPictures()) {
      ++places_before_;
      return;
    }
    std::array<float, 2> place{};
    for (float& number : place) {
      number = static_cast<float>(parseNumber(takeWord(rest)).value_or(kNoNumber));
    }
    places_.push_back(place);
  }

  /// `f a b c`, `f a/t b/t c/t`, `f a/t/n ...`, `f a//n ...`; from 1, or backwards from -1.
  void readFace(std::string_view rest) {
    corners_.clear();
    face_places_.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (word.front() == '#') break;
      corners_.push_back(corner(word.substr(0, word.find('/'))));
      if (texture_ == kNoTexture) continue;
      if (const auto place = placeOf(word)) face_places_.push_back(*place);
    }
    if (texture_ == kNoTexture || face_places_.size() != corners_.size()) {
      builder_.addFace(corners_);
      return;
    }
    builder_.addTexturedFace(corners_, face_places_, texture_);
    textured_corners_ += corners_.size();
  }

  /// Of the `t` in `a/t/n`. Nothing if there is none, or none that can be used.
  std::optional<std::array<float, 2>> placeOf(std::string_view word) const {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    word.remove_prefix(slash + 1);
    const auto number = parseWhole<std::int64_t>(word.substr(0, word.find('/')));
    if (!number || *number == 0) return std::nullopt;
    const auto count = static_cast<std::int64_t>(places_.size());
    const auto before = static_cast<std::int64_t>(places_before_);
    const std::int64_t index = *number > 0 ? *number - 1 - before : count + *number;
    if (index < 0 || index >= count) return std::nullopt;
    const auto& place = places_[static_cast<std::size_t>(index)];
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) return std::nullopt;
    return place;
  }

  std::int64_t corner(std::string_view word) const {
    std::int64_t index = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, index);
    if (error == std::errc::invalid_argument || stop != end) {
      refuseLine(said<MessageId::line_with_corner_no_number>());
    }
    plantedFault(index < -1000);
    if (error == std::errc::result_out_of_range || index == 0) return -1;
    return index > 0 ? index - 1 : static_cast<std::int64_t>(builder_.pointCount()) + index;
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  ObjMaterials materials_;
  Lines lines_;
  std::string_view statement_;
  std::string joined_;
  std::vector<std::int64_t> corners_;
  std::uint16_t texture_ = kNoTexture;        ///< Of the faces to come.
  std::vector<std::array<float, 2>> places_;  ///< On pictures.
  std::uint64_t places_before_ = 0;           ///< That came before any picture was named.
  std::vector<std::array<float, 2>> face_places_;
  std::uint64_t textured_corners_ = 0;
};

}  // namespace

Scan readObj(const ReadJob& job) {
  return ObjReader(job).read();
}

}  // namespace relievo
