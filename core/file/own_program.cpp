// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/own_program.h"

#include "core/base/error.h"

namespace relievo {
namespace {

std::filesystem::path& givenFolder() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

void setProgramFolder(const std::filesystem::path& folder) {
  givenFolder() = folder;
}

std::filesystem::path ownFolder(const std::string& does) {
  if (!givenFolder().empty()) return givenFolder();
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) return self.parent_path();
  throw FileError(
      does +
      " /proc, by which relievo finds its own programs, is not there. Mount it, and try "
      "again.");
}

std::filesystem::path programSeenFrom(const std::filesystem::path& folder,
                                      const std::filesystem::path& name) {
  for (const char* const place : {RELIEVO_LIBEXECDIR "/relievo", ".", "../bin"}) {
    std::error_code missing;
    std::filesystem::path found = (folder / place / name).lexically_normal();
    if (std::filesystem::is_regular_file(found, missing)) return found;
  }
  return {};
}

std::filesystem::path placeOfPrograms(const std::filesystem::path& folder) {
  // Programs that relievo goes on as lie among those that they start.
  const bool among_them = folder.filename() == "relievo";
  return among_them ? folder : (folder / RELIEVO_LIBEXECDIR "/relievo").lexically_normal();
}

std::filesystem::path ownProgram(const std::string& name, const std::string& does) {
  return programSeenFrom(ownFolder(does), name);
}

}  // namespace relievo
