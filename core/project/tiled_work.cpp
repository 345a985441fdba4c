// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/tiled_work.h"

#include <optional>
#include <string>
#include <utility>

#include "core/base/plain_bytes.h"
#include "core/provenance/program.h"
#include "core/provenance/provenance.h"
#include "core/session/input_names.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// One file that was read, or several as one.
struct ReadFiles {
  InputFile input;
  std::vector<InputFile> files = {};  ///< As Provenance::files.
};

/// Each with its checksum; several processes read some of them each.
std::vector<InputFile> inputFiles(const std::vector<fs::path>& files, const fs::path& folder,
                                  Exchange& processes, const Task& task) {
  const auto ranks = static_cast<std::size_t>(processes.ranks());
  std::string mine;
  for (auto i = static_cast<std::size_t>(processes.rank()); i < files.size(); i += ranks) {
    const InputFile file = inputFile(files[i], folder, task);
    mine.append(plainBytes(file.bytes)).append(plainBytes(file.file.size())).append(file.file);
    mine.append(file.sha256);
  }
  const std::vector<std::string> told = processes.share(mine);
  std::vector<PlainBytes> bytes(told.begin(), told.end());
  std::vector<InputFile> all(files.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    constexpr std::size_t kSha256Digits = 64;
    std::size_t name = 0;
    bytes[i % ranks].take(all[i].bytes);
    bytes[i % ranks].take(name);
    bytes[i % ranks].take(all[i].file, name);
    bytes[i % ranks].take(all[i].sha256, kSha256Digits);
  }
  return all;
}

ReadFiles readFilesOf(const TiledWork& work, const std::vector<fs::path>& files,
                      Exchange& processes, const Task& task) {
  const fs::path parent = work.out.parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  ReadFiles read;
  read.files = inputFiles(files, folder, processes, task);
  if (files.size() == 1) return {.input = read.files.front()};
  // One name may stand for all; of several it is where the first is.
  const fs::path& name = work.names.front();
  const fs::path together = fs::is_directory(name) ? name : files.front().parent_path();
  read.input = togetherOf(together, folder, read.files);
  return read;
}

/// What makes the work what it is: another file, option or program would make other files.
JobFacts jobFacts(const TiledWork& work, const ReadFiles& read) {
  Provenance same;  // But for what is known only when it is made.
  same.options = work.options;
  same.accept_incomplete = work.import.accept_incomplete;
  same.scan = work.import.scan;
  same.input = {.file = "-", .sha256 = {}};
  const auto line = [](const InputFile& file) {
    return file.sha256 + " " + std::to_string(file.bytes) + "\n";
  };
  std::string files = read.files.empty() ? line(read.input) : "";
  for (const InputFile& file : read.files) files += line(file);
  return {{"the program", std::string(programVersion()) + " " + std::string(programCommit())},
          {"what the files hold", files},
          {"an option", toJson(same, -1)}};
}

std::string stateOf(const TiledWork& work, const LargeMap& map, const ReadFiles& read) {
  Provenance provenance = provenanceOf(map, work.options);
  provenance.input = read.input;
  provenance.files = read.files;
  provenance.accept_incomplete = work.import.accept_incomplete;
  provenance.scan = work.import.scan;
  return toJson(provenance, -1);
}
}  // namespace

LargeMap makeTiledMap(const TiledWork& work, const Task& task) {
  const std::vector<fs::path> files = filesNamed(work.names);
  std::optional<ReadFiles> read;
  Alone alone;
  LargeMapOptions large{.file = work.out,
                        .memory_bytes = work.memory_bytes,
                        .threads = work.threads,
                        .on_view = work.on_view,
                        .on_ready = work.on_ready,
                        .state =
                            [&](const LargeMap& map) {
                              // Its progress would be that of another step.
                              if (!read) read = readFilesOf(work, files, alone, {task.stop, {}});
                              return stateOf(work, map, *read);
                            },
                        .job = {},
                        .processes = work.processes};
  if (!work.job_folder.empty()) {
    read = readFilesOf(work, files, work.processes != nullptr ? *work.processes : alone, task);
    large.job = {.folder = work.job_folder, .facts = jobFacts(work, *read)};
  }
  return makeLargeMap(files, work.options, large, work.import, task);
}

}  // namespace relievo
