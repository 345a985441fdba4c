// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/unpack_las.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
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

/// Of the LAS file to come, from the header of the packed one; 0 if that cannot be read.
std::uint64_t expectedBytes(const std::filesystem::path& packed) {
  try {
    const LasHeader header = parseLasHeader(readHead(packed, 375), packed);
    return header.points_at + header.points * header.record_bytes;
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

UnpackedLas::UnpackedLas(const std::filesystem::path& packed, const Task& task) {
  task.check();
  const auto unpacker = findLasUnpacker();
  if (!unpacker) {
    refuseScan(packed,
               "it is a compressed LAS file (LAZ or COPC), and no program is installed that "
               "unpacks it. Install laszip or pdal, or have the file converted to LAS.");
  }
  makeFolder(packed);
  try {
    unpack(packed, *unpacker, task);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    throw;
  }
}

UnpackedLas::~UnpackedLas() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void UnpackedLas::makeFolder(const std::filesystem::path& packed) {
  std::error_code error;
  std::filesystem::path place = std::filesystem::temp_directory_path(error);
  if (error) place = "/tmp";
  const std::filesystem::space_info space = std::filesystem::space(place, error);
  const std::uint64_t expected = expectedBytes(packed);
  if (!error && expected > space.available) {
    refuseScan(packed, "unpacked it takes " + grouped(expected >> 20U) + " MB, and " +
                           place.string() + " has " + grouped(space.available >> 20U) +
                           " MB left. Make room, or set TMPDIR to another folder.");
  }
  std::string name = (place / "relievo-las-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    refuseScan(packed, "no folder for its points can be made in " + place.string() +
                           ". Set TMPDIR to another folder.");
  }
  folder_ = name;
  file_ = folder_ / packed.filename().replace_extension(".las");
}

void UnpackedLas::unpack(const std::filesystem::path& packed, const LasUnpacker& unpacker,
                         const Task& task) {
  const double expected = std::max(1.0, static_cast<double>(expectedBytes(packed)));
  OwnedFd words;
  OwnedFd child_words;
  makePipe(words, child_words);
  ChildProcess child;
  child.start({.program = unpacker.program,
               .arguments = argumentsOf(unpacker, packed, file_),
               .more_environment = {},
               .fds = {{child_words.get(), 1}, {child_words.get(), 2}}});
  child_words.reset();
  std::string text;
  bool open = true;
  while (!child.reap(false)) {
    task.check();  // Throws; the child's destructor ends it.
    pollfd source{open ? words.get() : -1, POLLIN, 0};
    ::poll(&source, 1, open ? kPollMs : 5);
    if (open) open = readAvailable(words.get(), text);
    if (text.size() > kWordsKept) text.erase(0, text.size() - kWordsKept);
    std::error_code missing;
    const std::uintmax_t written = std::filesystem::file_size(file_, missing);
    if (!missing) {
      task.report("unpacking", std::min(1.0, static_cast<double>(written) / expected));
    }
  }
  if (open) readAvailable(words.get(), text);
  std::error_code missing;
  if (child.exited() && child.number() == 0 && std::filesystem::exists(file_, missing)) return;
  const std::string said = lastPrintableLine(text);
  refuseScan(packed, unpacker.program.filename().string() + " cannot unpack it" +
                         (said.empty() ? "" : " (\"" + said + "\")") +
                         ". The file is probably damaged; copy or export it again.");
}

}  // namespace relievo
