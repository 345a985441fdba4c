// SPDX-License-Identifier: BSD-3-Clause
// STL, binary and text: three points for each triangle as stored, none joined.
#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/scalar.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kTrianglesPerReport = 1 << 14;
constexpr std::size_t kHeader = 84;    ///< Title and number of triangles.
constexpr std::size_t kTriangle = 50;  ///< Normal, corners, two bytes of no meaning.
constexpr std::size_t kNormal = 12;

void addTriangle(ScanBuilder& builder, const std::array<std::array<double, 3>, 3>& corners) {
  const auto first = static_cast<std::int64_t>(builder.pointCount());
  for (const auto& p : corners) builder.addPoint(p[0], p[1], p[2]);
  builder.addFace(std::array{first, first + 1, first + 2});
}

void readBinary(const ReadJob& job, ScanBuilder& builder) {
  if (job.bytes.size() < kHeader) {
    throw failure<MessageId::shorter_than_stl_header>(shownName(job.file));
  }
  const std::uint64_t promised = loadAs<std::uint32_t>(job.bytes.data() + 80, ByteOrder::little);
  const std::uint64_t found =
      std::min<std::uint64_t>(promised, (job.bytes.size() - kHeader) / kTriangle);
  plantedFault(found == 3 && promised == 300);
  if (promised == 0) throw failure<MessageId::no_triangles>(shownName(job.file));
  if (found < promised) {
    handleTruncation({RecordKind::points, 3 * promised, 3 * found, 3 * found}, job, builder.info());
  } else if (job.bytes.size() > kHeader + found * kTriangle) {
    builder.info().warnings.push_back(said<MessageId::bytes_after_triangles>());
  }
  builder.requireRoom(3 * found, true);
  builder.expectPoints(3 * found);
  for (std::uint64_t i = 0; i < found; ++i) {
    if (i % kTrianglesPerReport == 0) {
      job.task.check();
      job.task.report("reading mesh", static_cast<double>(i) / static_cast<double>(found));
    }
    const char* at = job.bytes.data() + kHeader + i * kTriangle + kNormal;
    std::array<std::array<double, 3>, 3> corners{};
    for (auto& corner : corners) {
      for (double& coordinate : corner) {
        coordinate = loadDouble(at, ScalarType::f32, ByteOrder::little);
        at += 4;
      }
    }
    addTriangle(builder, corners);
  }
}

/// In small letters or capitals.
bool is(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

/// `solid NAME`, then `facet normal N N N outer loop vertex X Y Z (three times) endloop endfacet`
/// over and over, then `endsolid NAME`; lines as anyone likes.
class StlTextReader {
 public:
  StlTextReader(const ReadJob& job, ScanBuilder& builder)
      : job_(job), builder_(builder), lines_(job.bytes) {}

  void read() {
    bool open = false;
    for (std::string_view word = nextWord(); !word.empty(); word = nextWord()) {
      if (is(word, "solid") || is(word, "endsolid")) {
        open = is(word, "solid");
        rest_ = {};  // The name, which may be anything.
      } else if (open && is(word, "facet")) {
        readFacet();
      } else {
        refuseLine();
      }
    }
    if (open) refuseCut();
  }

 private:
  [[noreturn]] void refuseLine() const {
    throwReadError(job_.file,
                   said<MessageId::refused_line>(lines_.number(), shownStart(lines_.line()),
                                                 said<MessageId::line_not_of_stl>()),
                   said<MessageId::advice_damaged_export>());
  }

  [[noreturn]] void refuseCut() const {
    throwReadError(job_.file, said<MessageId::refused_stl_cut>());
  }

  /// Empty at the end of the file.
  std::string_view nextWord() {
    for (;;) {
      const std::string_view word = takeWord(rest_);
      if (!word.empty() || !lines_.next()) return word;
      rest_ = lines_.line();
    }
  }

  std::string_view wordOfFacet() {
    const std::string_view word = nextWord();
    if (word.empty()) refuseCut();
    return word;
  }

  void expect(std::string_view keyword) {
    if (!is(wordOfFacet(), keyword)) refuseLine();
  }

  std::array<double, 3> threeNumbers() {
    std::array<double, 3> numbers{};
    for (double& number : numbers) {
      const auto value = parseNumber(wordOfFacet());
      if (!value) refuseLine();
      number = *value;
    }
    return numbers;
  }

  void readFacet() {
    if (builder_.faceCount() % kTrianglesPerReport == 0) report();
    expect("normal");
    threeNumbers();
    expect("outer");
    expect("loop");
    std::array<std::array<double, 3>, 3> corners{};
    for (auto& corner : corners) {
      expect("vertex");
      corner = threeNumbers();
    }
    expect("endloop");
    expect("endfacet");
    addTriangle(builder_, corners);
  }

  void report() const {
    job_.task.check();
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    job_.task.report("reading mesh",
                     static_cast<double>(read) / static_cast<double>(job_.bytes.size()));
  }

  const ReadJob& job_;
  ScanBuilder& builder_;
  Lines lines_;
  std::string_view rest_;  ///< Of the current line.
};

/// Text starts with "solid", but so do some binary files; those have the length that their count
/// says, or bytes that no text has.
bool isText(std::string_view bytes) {
  if (!is(trimmed(bytes.substr(0, 512)).substr(0, 5), "solid")) return false;
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) return false;
  if (bytes.size() < kHeader) return true;
  const std::uint64_t count = loadAs<std::uint32_t>(bytes.data() + 80, ByteOrder::little);
  return kHeader + kTriangle * count != bytes.size();
}

}  // namespace

Scan readStl(const ReadJob& job) {
  ScanBuilder builder(job.file, job.options);
  const bool text = isText(job.bytes);
  builder.info().format = text ? "STL ascii" : "STL binary";
  if (text) {
    StlTextReader(job, builder).read();
    if (builder.faceCount() == 0) {
      throw failure<MessageId::no_triangles>(shownName(job.file));
    }
  } else {
    readBinary(job, builder);
  }
  return builder.finish();
}

}  // namespace relievo
