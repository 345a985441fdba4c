// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/unpack_las.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include "core/io/file_check.h"
#include "core/io/las_header.h"
#include "core/io/read_scan.h"
#include "core/io/spawn.h"

namespace relievo {
namespace {

constexpr int kPollMs = 50;
constexpr std::size_t kWordsKept = 4096;

constexpr std::size_t kHeaderBytes = 375;  ///< Of LAS 1.4, the longest.

/// Of the LAS file to come, from the header of the packed one; 0 if that cannot be read.
std::uint64_t expectedBytes(const std::filesystem::path& packed) {
  try {
    const LasHeader header = packedLasHeader(packed);
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 2;
    return header.points_at +
           std::min(header.points, kMost / header.record_bytes) * header.record_bytes;
  } catch (const FileError&) {
    return 0;  // The program will say what is wrong with it.
  }
}

std::vector<std::string> argumentsOf(const LasUnpacker& unpacker,
                                     const std::filesystem::path& packed,
                                     const std::filesystem::path& unpacked) {
  const std::string in = std::filesystem::absolute(packed).string();
  const std::string out = unpacked.string();
  if (unpacker.kind == LasUnpacker::Kind::laszip) return {"laszip", "-i", in, "-o", out};
  // Without forward=all pdal chooses a scale of its own, and coordinates change.
  return {"pdal", "translate", in, out, "--writers.las.forward=all"};
}

}  // namespace

LasHeader packedLasHeader(const std::filesystem::path& packed) {
  constexpr std::size_t kFormatAt = 104;
  constexpr char kFormatBits = 0x3F;  // The others say how it is packed.
  std::string head = readHead(packed, kHeaderBytes);
  if (head.size() > kFormatAt) head[kFormatAt] = static_cast<char>(head[kFormatAt] & kFormatBits);
  return parseLasHeader(head, packed);
}

std::optional<LasUnpacker> findLasUnpacker() {
  const char* const path = std::getenv("PATH");
  if (path == nullptr) return std::nullopt;
  using Kind = LasUnpacker::Kind;
  constexpr std::array<std::pair<std::string_view, Kind>, 3> kPrograms{
      {{"laszip", Kind::laszip}, {"laszip64", Kind::laszip}, {"pdal", Kind::pdal}}};
  for (const auto& [name, kind] : kPrograms) {
    std::string_view rest = path;
    while (!rest.empty()) {
      const std::string_view folder = rest.substr(0, rest.find(':'));
      rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
      if (!folder.starts_with('/'))
        continue;  // Never a program of the folder one happens to be in.
      const std::filesystem::path program = std::filesystem::path(folder) / name;
      std::error_code missing;
      if (std::filesystem::is_regular_file(program, missing) &&
          ::access(program.c_str(), X_OK) == 0) {
        return LasUnpacker{kind, program};
      }
    }
  }
  return std::nullopt;
}

UnpackedLas::UnpackedLas(const std::filesystem::path& packed, const Task& task)
    : packed_(packed),
      task_{.stop = task.stop, .progress = {}},
      expected_bytes_(expectedBytes(packed)) {
  task_.check();
  const auto unpacker = findLasUnpacker();
  if (!unpacker) {
    refuseScan(packed,
               "it is a compressed LAS file (LAZ or COPC), and no program is installed that "
               "unpacks it. Install laszip or pdal, or have the file converted to LAS.");
  }
  makeFolder();
  try {
    start(*unpacker);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    throw;
  }
}

UnpackedLas::~UnpackedLas() {
  child_.kill();  // Before its folder goes: it could write into it once more.
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void UnpackedLas::makeFolder() {
  std::error_code error;
  std::filesystem::path place = std::filesystem::temp_directory_path(error);
  if (error) place = "/tmp";
  const std::filesystem::space_info space = std::filesystem::space(place, error);
  if (!error && expected_bytes_ > space.available) {
    refuseScan(packed_, "unpacked it takes " + grouped(expected_bytes_ >> 20U) + " MB, and " +
                            place.string() + " has " + grouped(space.available >> 20U) +
                            " MB left. Make room, or set TMPDIR to another folder.");
  }
  std::string name = (place / "relievo-las-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    refuseScan(packed_, "no folder for its points can be made in " + place.string() +
                            ". Set TMPDIR to another folder.");
  }
  folder_ = name;
  file_ = folder_ / packed_.filename().replace_extension(".las");
}

void UnpackedLas::start(const LasUnpacker& unpacker) {
  program_ = unpacker.program.filename();
  OwnedFd child_words;
  makePipe(words_, child_words);
  child_.start({.program = unpacker.program,
                .arguments = argumentsOf(unpacker, packed_, file_),
                .more_environment = {},
                .fds = {{child_words.get(), 1}, {child_words.get(), 2}}});
}

std::uint64_t UnpackedLas::bytesNow() const {
  std::error_code missing;
  const std::uintmax_t bytes = std::filesystem::file_size(file_, missing);
  return missing ? 0 : bytes;
}

bool UnpackedLas::hasEnded() {
  const std::scoped_lock lock(mutex_);
  task_.check();
  if (!ended_ && child_.reap(false)) end();
  if (!failure_.empty()) refuseScan(packed_, failure_);
  if (ended_) return true;
  const bool open = words_.get() >= 0;
  pollfd source{words_.get(), POLLIN, 0};
  ::poll(&source, 1, open ? kPollMs : 5);
  if (open && !readAvailable(words_.get(), said_)) words_.reset();
  if (said_.size() > kWordsKept) said_.erase(0, said_.size() - kWordsKept);
  return false;
}

void UnpackedLas::end() {
  if (words_.get() >= 0) readAvailable(words_.get(), said_);
  ended_ = true;
  std::error_code missing;
  if (child_.exited() && child_.number() == 0 && std::filesystem::exists(file_, missing)) return;
  const std::string said = lastPrintableLine(said_);
  failure_ = program_.string() + " cannot unpack it" + (said.empty() ? "" : " (\"" + said + "\")") +
             ". The file is probably damaged; copy or export it again.";
}

bool UnpackedLas::waitFor(std::uint64_t bytes) {
  while (bytesNow() < bytes) {
    if (hasEnded()) return bytesNow() >= bytes;
  }
  return true;
}

void UnpackedLas::waitForAll(const Task& task) {
  const double expected = std::max(1.0, static_cast<double>(expected_bytes_));
  while (!hasEnded()) {
    task.report("unpacking", std::min(1.0, static_cast<double>(bytesNow()) / expected));
  }
}

}  // namespace relievo
