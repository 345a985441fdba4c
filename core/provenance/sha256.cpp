// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/sha256.h"

#include <fstream>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/tiles/published/published_tiles.h"

namespace relievo {
namespace {
constexpr std::size_t kPieceBytes = 1U << 18U;  // Still in the nearer memory when it is summed up.
}

std::string sha256OfFile(const std::filesystem::path& file, const Task& task) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw failure<MessageId::checksum_of_no_file>(shownName(file));
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  std::ifstream in(file, std::ios::binary);
  std::vector<char> piece(kPieceBytes);
  Sha256 hash;
  double done = 0;
  while (in) {
    task.check();
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    hash.add(std::string_view(piece.data(), count));
    done += static_cast<double>(count);
    if (bytes > 0) task.report("Checksum", done / bytes);
  }
  if (!in.eof()) {
    throw failure<MessageId::checksum_cut>(shownName(file));
  }
  return hash.finish();
}

std::string relativePath(const std::filesystem::path& file, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  // Of a map from the web it is its address that others know.
  if (isWebAddress(file.string())) return file.string();
  if (std::string address = addressOfKeptMap(file); !address.empty()) return address;
  std::error_code error;
  const fs::path to = fs::weakly_canonical(fs::absolute(file), error);
  const fs::path start = fs::weakly_canonical(fs::absolute(folder), error);
  const fs::path relative = to.lexically_relative(start);
  return (relative.empty() ? to : relative).generic_string();
}

std::string namedFrom(const std::filesystem::path& folder, const std::string& name) {
  if (isWebAddress(name)) return name;
  return (folder / name).lexically_normal().generic_string();
}

InputFile inputFile(const std::filesystem::path& file, const std::filesystem::path& from,
                    const Task& task) {
  InputFile input{.file = file.filename().generic_string(),
                  .sha256 = sha256OfFile(file, task),
                  .bytes = std::filesystem::file_size(file)};
  if (!from.empty()) input.file = relativePath(file, from);
  if (const std::string address = addressOfKeptMap(file); !address.empty()) input.file = address;
  return input;
}

InputFile togetherOf(const std::filesystem::path& name, const std::filesystem::path& from,
                     const std::vector<InputFile>& files) {
  InputFile all{.file = relativePath(name, from), .sha256 = {}};
  std::string sums;
  for (const InputFile& file : files) {
    sums += file.sha256 + '\n';
    all.bytes += file.bytes;
  }
  all.sha256 = sha256OfText(sums);
  return all;
}

}  // namespace relievo
