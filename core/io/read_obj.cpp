// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: vertices and faces. Ours rather than PCL's, whose coordinates are float.
#include <string>

#include "core/base/error.h"
#include "core/io/lines.h"
#include "core/io/planted_fault.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::uint64_t kReportEvery = 1 << 16;
constexpr std::size_t kMaxLine = 1 << 20;

class ObjReader {
 public:
  explicit ObjReader(const ReadJob& job)
      : job_(job), builder_(job.file, job.options.max_points), lines_(job.bytes) {}

  Scan read() {
    builder_.info().format = "OBJ";
    while (nextStatement()) {
      if (lines_.number() % kReportEvery == 0) report();
      std::string_view rest = statement_;
      const std::string_view word = takeWord(rest);
      if (word == "v") readVertex(rest);
      if (word == "f") readFace(rest);
    }
    if (builder_.pointCount() == 0) {
      refuseScan(job_.file, "it has no vertices (\"v x y z\"). Choose another file.");
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

  [[noreturn]] void refuseLine(const std::string& finding) const {
    refuseScan(job_.file, "line " + std::to_string(lines_.number()) + " (\"" +
                              std::string(trimmed(statement_).substr(0, 60)) + "\") " + finding +
                              ". The file is damaged; export it again.");
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
      refuseScan(job_.file, "line " + std::to_string(lines_.number()) +
                                " is longer than 1 MB. The file is damaged; export it again.");
    }
    return true;
  }

  void readVertex(std::string_view rest) {
    std::array<double, 3> p{};
    for (double& coordinate : p) {
      const auto value = parseNumber(takeWord(rest));
      if (!value) refuseLine("does not hold three coordinates");
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

  /// `f a b c`, `f a/t b/t c/t`, `f a/t/n ...`, `f a//n ...`; from 1, or backwards from -1.
  void readFace(std::string_view rest) {
    corners_.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (word.front() == '#') break;
      corners_.push_back(corner(word.substr(0, word.find('/'))));
    }
    builder_.addFace(corners_);
  }

  std::int64_t corner(std::string_view word) const {
    std::int64_t index = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, index);
    if (error == std::errc::invalid_argument || stop != end) {
      refuseLine("names a corner that is no number");
    }
    plantedFault(index < -1000);
    if (error == std::errc::result_out_of_range || index == 0) return -1;
    return index > 0 ? index - 1 : static_cast<std::int64_t>(builder_.pointCount()) + index;
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  Lines lines_;
  std::string_view statement_;
  std::string joined_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

Scan readObj(const ReadJob& job) {
  return ObjReader(job).read();
}

}  // namespace relievo
