// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/replaceable.h"

#include <unistd.h>

#include <string>
#include <system_error>

#include "core/base/failure.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

bool areOneFile(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code missing;  // Then the names tell, below the folders that are there.
  if (fs::equivalent(a, b, missing)) return true;
  const fs::path place = fs::weakly_canonical(a, missing);
  return !missing && place == fs::weakly_canonical(b, missing) && !missing;
}

[[noreturn]] void refuse(const fs::path& file, const Message& why) {
  throw NotReplaceable(file, why);
}

/// Links of the system name open files of a process, not places: /dev/stdout, /proc/self/fd/1.
bool isOfTheSystem(const fs::path& link) {
  const std::string name = link.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

fs::path behindLinks(const fs::path& file) {
  constexpr int kMostLinks = 40;  // As the system itself follows.
  fs::path place = file;
  std::error_code unknown;
  for (int i = 0; fs::is_symlink(fs::symlink_status(place, unknown)); ++i) {
    if (i == kMostLinks) refuse(file, said<MessageId::links_in_circle>());
    if (isOfTheSystem(place)) refuse(file, said<MessageId::is_no_regular_file>());
    place = place.parent_path() / fs::read_symlink(place, unknown);
  }
  return place;
}

}  // namespace

NotReplaceable::NotReplaceable(const fs::path& file, const Message& because)
    : WriteError(said<MessageId::not_replaceable>(file, because)), why(because) {}

fs::path requireReplaceable(const fs::path& file) {
  fs::path place = behindLinks(file);
  std::error_code unknown;  // What cannot be asked cannot be opened either, which says why.
  const fs::file_status status = fs::status(place, unknown);
  if (!fs::exists(status)) return place;
  if (!fs::is_regular_file(status)) refuse(file, said<MessageId::is_no_regular_file>());
  // The superuser may write to it all the same; who made it read-only meant everybody.
  constexpr fs::perms kWrite =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  const bool writable =
      (status.permissions() & kWrite) != fs::perms::none && ::access(place.c_str(), W_OK) == 0;
  if (!writable) refuse(file, said<MessageId::is_read_only>());
  return place;
}

void requireNotAnInput(const fs::path& out, const std::vector<FileRead>& inputs) {
  for (const FileRead& input : inputs) {
    if (!areOneFile(out, input.file)) continue;
    if (input.what.empty()) throw failure<MessageId::output_is_the_scan>(out);
    throw failure<MessageId::output_is_read>(out, input.what);
  }
}

void requireDifferentFiles(const std::vector<fs::path>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!areOneFile(outputs[k], outputs[i])) continue;
      throw failure<MessageId::outputs_are_one>(outputs[i]);
    }
  }
}

}  // namespace relievo
