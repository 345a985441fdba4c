// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/package.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/file/atomic_file.h"
#include "core/io/file_check.h"
#include "core/project/project_files.h"
#include "core/project/zip_session.h"
#include "core/project/zip_target.h"
#include "core/provenance/name_text.h"
#include "core/provenance/program.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/tiled_map.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest-sha256.txt";
constexpr const char* kProject = "project.json";
constexpr const char* kReadme = "README.txt";
constexpr std::uint64_t kMostTextBytes = 64U << 20U;
constexpr std::uint64_t kSmallBytes = 64U << 20U;  // Unpacked; no disk is filled by so much.
constexpr std::uint64_t kMostRatio = 200;  // Of bytes unpacked to bytes packed; scans have 2 to 20.
constexpr std::uint64_t kMostBytes = std::uint64_t{1}
                                     << 50U;  // Of an entry; a sum cannot overflow.
constexpr std::time_t kNoDate = 315532800;    // 1980-01-01, the oldest that a zip can hold.

// ---- writing -------------------------------------------------------------------------------

// Characters that end a manifest's line, and how `sha256sum` writes them behind a backslash.
constexpr std::string_view kSpecial = "\\\n\r", kWritten = "\\nr";

/// A line of the manifest as `sha256sum` writes it: a name of several lines is escaped, and a
/// backslash before the checksum says so.
std::string manifestLine(const std::string& sha256, const std::string& name) {
  std::string escaped;
  for (const char c : name) {
    const std::size_t which = kSpecial.find(c);
    if (which != std::string_view::npos) escaped += '\\';
    escaped += which == std::string_view::npos ? c : kWritten[which];
  }
  return (escaped == name ? "" : "\\") + sha256 + "  " + escaped + '\n';
}

class PackageWriter {
 public:
  explicit PackageWriter(std::filesystem::path target)
      : target_(std::move(target)), part_(target_), zip_(part_.path()) {
    zip_source_t* const source = zip_.source();
    if (source == nullptr) fail(std::strerror(errno));
    zip_error_t error;
    zip_error_init(&error);
    archive_.reset(zip_open_from_source(source, ZIP_CREATE | ZIP_TRUNCATE, &error));
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    if (archive_) return;
    zip_source_free(source);
    fail(reason);
  }

  /// @return its name in the package; a second one of the same name gets a number
  std::string addFile(const std::string& folder, const std::filesystem::path& file,
                      const std::string& sha256) {
    // A zip's names are UTF-8.
    const std::string own_name = textOfName(file.filename().string());
    std::string name = folder + "/" + own_name;
    for (int i = 2; manifest_.contains(name); ++i) {
      name = folder + "/" + std::to_string(i) + "-" + own_name;
    }
    add(name, zip_source_file(archive_.get(), file.c_str(), 0, -1), sha256);
    return name;
  }

  void addText(const std::string& name, std::string text) {
    texts_.push_back(std::make_unique<std::string>(std::move(text)));
    const std::string& kept = *texts_.back();
    add(name, zip_source_buffer(archive_.get(), kept.data(), kept.size(), 0), sha256OfText(kept));
  }

  void close(const Task& task) {
    std::string lines;
    for (const auto& [name, sha256] : manifest_) lines += manifestLine(sha256, name);
    addText(kManifest, lines);
    // Everything is read, packed and written here.
    zip_register_cancel_callback_with_state(
        archive_.get(),
        [](zip_t*, void* state) {
          return static_cast<Task*>(state)->stop.stop_requested() ? 1 : 0;
        },
        nullptr, const_cast<Task*>(&task));
    if (zip_close(archive_.get()) != 0) {
      task.check();
      fail(zip_strerror(archive_.get()));
    }
    archive_.release();  // NOLINT(bugprone-unused-return-value): closed, hence freed.
    part_.commit();
  }

 private:
  void add(const std::string& name, zip_source_t* source, const std::string& sha256) {
    const zip_int64_t index =
        source == nullptr ? -1
                          : zip_file_add(archive_.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      zip_source_free(source);
      fail(zip_strerror(archive_.get()));
    }
    zip_file_set_mtime(archive_.get(), static_cast<zip_uint64_t>(index), kNoDate, 0);
    zip_file_set_external_attributes(archive_.get(), static_cast<zip_uint64_t>(index), 0,
                                     ZIP_OPSYS_UNIX, 0100644U << 16U);
    manifest_[name] = sha256;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw failure<MessageId::package_not_written>(target_, reason);
  }

  std::filesystem::path target_;
  AtomicFile part_;
  ZipTarget zip_;
  std::vector<std::unique_ptr<std::string>> texts_;  ///< Until the archive is closed.
  std::map<std::string, std::string> manifest_;
  Zip archive_;
};

/// The file is there and is the one the project means.
void requireAsBefore(const FileCheck& check) {
  const fs::path file = check.file.file;
  if (check.state == FileState::missing) throw failure<MessageId::packed_file_missing>(file);
  if (check.state == FileState::changed) throw failure<MessageId::packed_file_changed>(file);
}

/// Likewise of one that is needed to repeat a recording.
void requireAsBefore(const FileCheck& check, const fs::path& recording) {
  const fs::path file = check.file.file;
  if (check.state == FileState::missing) {
    throw failure<MessageId::needed_file_missing>(file, recording);
  }
  if (check.state == FileState::changed) {
    throw failure<MessageId::needed_file_changed>(file, recording);
  }
}

/// What the recordings need beyond the input, each file once.
std::vector<InputFile> dependenciesOf(const Project& project, const PackageContents& contents,
                                      const Task& task) {
  std::vector<InputFile> all;
  if (!contents.dependencies) return all;
  std::set<std::string> known{project.sha256};
  for (const InputFile& recording : project.recordings) {
    for (InputFile& file : contents.dependencies(recording.file, task)) {
      if (!known.insert(file.sha256).second) continue;
      requireAsBefore(checkFile(file, task), fs::path(recording.file).filename());
      all.push_back(std::move(file));
    }
  }
  return all;
}

/// Empty: it is no map from the web.
std::string addressOf(const std::string& file) {
  return isWebAddress(file) ? file : addressOfKeptMap(file);
}

/// @param packed  names its input as the package does
std::string readmeText(const Project& packed, bool with_input) {
  const std::string object =
      isWebAddress(packed.file)
          ? printable(packed.file)
          : escapedName(std::filesystem::path(packed.file).filename().string());
  return "Package for citation, made by relievo " + std::string(programVersion()) + " (" +
         std::string(programCommit()) + ")\n\nObject: " + object + ", SHA-256 " + packed.sha256 +
         (with_input ? ", in input/" : ", not included; needed to make the figures again") +
         "\n\nproject.json         the work: views, regions, measurements; open it with relievo\n"
         "recordings/          what was felt, one row per millisecond, and files it needs\n"
         "figures/             each carries the state that it was made from\n" +
         kManifest +
         "  checksums of all files; check with: sha256sum -c\n\n"
         "Check all:           relievo project verify PACKAGE.zip\n"
         "Feel it again:       relievo replay PACKAGE.zip --verify\n"
         "Make a figure again: relievo render --from-image figures/NAME.png -o NEW.png\n";
}

// ---- reading -------------------------------------------------------------------------------

/// A few megabytes can say that they are a disk full of zeros.
void requireBounded(zip_t* archive, const std::filesystem::path& file) {
  std::uint64_t bytes = 0;
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t entry;
    zip_stat_init(&entry);
    if (zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &entry) != 0) continue;
    bytes += std::min<std::uint64_t>(entry.size, kMostBytes);
  }
  const std::uint64_t packed = std::filesystem::file_size(file);
  if (bytes <= kSmallBytes || bytes <= kMostRatio * packed) return;
  throw failure<MessageId::package_unpacks_too_large>(shownName(file),
                                                      CountArgument::grouped(bytes), kMostRatio);
}

Zip openZip(const std::filesystem::path& file) {
  checkedFileSize(file);
  int code = 0;
  Zip archive(zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
  if (!archive) {
    throw failure<MessageId::not_a_zip>(shownName(file));
  }
  requireBounded(archive.get(), file);
  return archive;
}

/// Hands an entry on in pieces. @return false if it is damaged
template <class Take>
bool readEntry(zip_t* archive, const std::string& name, const Take& take, const Task& task) {
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> entry(
      zip_fopen(archive, name.c_str(), ZIP_FL_ENC_UTF_8), &zip_fclose);
  if (!entry) return false;
  zip_stat_t said;
  zip_stat_init(&said);
  if (zip_stat(archive, name.c_str(), ZIP_FL_ENC_UTF_8, &said) != 0) return false;
  std::vector<char> piece(1U << 18U);
  std::uint64_t bytes = 0;
  for (;;) {
    task.check();
    const zip_int64_t count = zip_fread(entry.get(), piece.data(), piece.size());
    if (count < 0) return false;
    if (count == 0) return bytes == said.size;
    bytes += static_cast<std::uint64_t>(count);
    if (bytes > said.size) return false;  // More than was counted before.
    if (!take(std::string_view(piece.data(), static_cast<std::size_t>(count)))) return false;
  }
}

std::optional<std::string> entryText(zip_t* archive, const std::string& name, const Task& task) {
  std::string text;
  const bool whole = readEntry(
      archive, name,
      [&](std::string_view piece) {
        text += piece;
        return text.size() <= kMostTextBytes;
      },
      task);
  if (!whole) return std::nullopt;
  return text;
}

/// The name that manifestLine() escaped; nothing if it is none.
std::optional<std::string> unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      name += text[i];
      continue;
    }
    const std::size_t which = ++i < text.size() ? kWritten.find(text[i]) : std::string_view::npos;
    if (which == std::string_view::npos) return std::nullopt;
    name += kSpecial[which];
  }
  return name;
}

/// Name to checksum; nothing for a line of another form.
std::optional<std::map<std::string, std::string>> manifestFrom(std::string_view text) {
  std::map<std::string, std::string> manifest;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_escaped = line.starts_with('\\');
    line.remove_prefix(is_escaped ? 1 : 0);
    if (line.size() < 67 || line.substr(64, 2) != "  ") return std::nullopt;
    const std::string_view written = line.substr(66);
    const auto name = is_escaped ? unescaped(written) : std::optional(std::string(written));
    if (!name) return std::nullopt;
    manifest[*name] = line.substr(0, 64);
  }
  return manifest;
}

/// Files of the project that are not among those packed: whoever checks a package from elsewhere
/// would have files of his own read, and told about. An input that was left out is a bare name.
void checkNames(const Project& project, const std::map<std::string, std::string>& manifest,
                PackageCheck& check) {
  const auto refuse = [&check](const std::string& name) {
    check.problems.push_back("The project names a file outside of the package ('" + name + "').");
  };
  const std::filesystem::path input = project.file;
  const bool is_outside = input != input.filename() && !isWebAddress(project.file);
  if (!manifest.contains(project.file) && is_outside) refuse(project.file);
  for (const InputFile& recording : project.recordings) {
    if (!manifest.contains(recording.file)) refuse(recording.file);
  }
}

void checkEntry(zip_t* archive, const std::string& name, const std::string& sha256,
                PackageCheck& check, const Task& task) {
  Sha256 hash;
  const bool whole = readEntry(
      archive, name,
      [&](std::string_view piece) {
        hash.add(piece);
        return true;
      },
      task);
  if (!whole) {
    check.problems.push_back("'" + name + "' is missing or damaged.");
  } else if (hash.finish() != sha256) {
    check.problems.push_back("'" + name + "' is not what was packed (checksum differs).");
  } else {
    ++check.files;
  }
}

}  // namespace

void writePackage(const std::filesystem::path& target, const Project& project,
                  const PackageContents& contents, const Task& task) {
  std::vector<FileRead> packs{{.file = project.file}};
  for (const InputFile& recording : project.recordings) {
    packs.push_back({.file = recording.file, .what = "a recording that is packed"});
  }
  for (const auto& figure : contents.figures) packs.push_back({figure, "a figure that is packed"});
  requireNotAnInput(target, packs);
  Project packed = project;
  std::vector<FileCheck> checks = checkFiles(project, task);
  // Of a map from the web only what was looked at is here: its address is packed.
  const std::string address = addressOf(project.file);
  const bool with_input = contents.with_input && address.empty();
  if (!with_input) checks.erase(checks.begin());
  for (const FileCheck& check : checks) requireAsBefore(check);
  const std::vector<InputFile> dependencies = dependenciesOf(project, contents, task);
  std::vector<std::string> figure_sums;
  for (const auto& figure : contents.figures) figure_sums.push_back(sha256OfFile(figure, task));

  std::vector<std::pair<std::filesystem::path, std::string>> levels;
  if (with_input && TiledMap::isOne(project.file)) {
    for (const auto& file : TiledMap(project.file).otherFiles()) {
      levels.emplace_back(file, sha256OfFile(file, task));
    }
  }

  PackageWriter writer(target);
  packed.figures.clear();
  packed.file = with_input        ? writer.addFile("input", project.file, project.sha256)
                : address.empty() ? std::filesystem::path(project.file).filename().string()
                                  : address;
  for (const auto& [level, sha256] : levels) writer.addFile("input", level, sha256);
  for (InputFile& recording : packed.recordings) {
    recording.file = writer.addFile("recordings", recording.file, recording.sha256);
  }
  for (const InputFile& file : dependencies) writer.addFile("recordings", file.file, file.sha256);
  for (std::size_t i = 0; i < figure_sums.size(); ++i) {
    packed.figures.push_back(writer.addFile("figures", contents.figures[i], figure_sums[i]));
  }
  writer.addText(kProject, projectJson(packed));
  writer.addText(kReadme, readmeText(packed, with_input));
  writer.close(task);
}

bool isPackageOfRelievo(const std::filesystem::path& file) {
  int code = 0;
  const Zip archive(zip_open(file.c_str(), ZIP_RDONLY, &code));
  const auto holds = [&archive](const char* name) {
    return zip_name_locate(archive.get(), name, ZIP_FL_ENC_UTF_8) >= 0;
  };
  return archive && holds(kManifest) && holds(kProject);
}

Project projectInPackage(const std::filesystem::path& file, const Task& task) {
  const Zip archive = openZip(file);
  const auto text = entryText(archive.get(), kProject, task);
  if (!text) throw failure<MessageId::package_not_checked>(shownName(file), kProject);
  return projectFromJson(*text, shownName(file));
}

void unpackPackage(const std::filesystem::path& file, const std::filesystem::path& folder,
                   const Task& task) {
  const Zip archive = openZip(file);
  const auto text = entryText(archive.get(), kManifest, task);
  const auto manifest = text ? manifestFrom(*text) : std::nullopt;
  if (!manifest) {
    throw failure<MessageId::package_without_manifest>(shownName(file), kManifest);
  }
  for (const auto& [name, sha256] : *manifest) {
    const std::filesystem::path inside = std::filesystem::path(name).lexically_normal();
    if (inside.is_absolute() || inside.empty() || *inside.begin() == "..") {
      throw failure<MessageId::package_names_outside>(shownName(file), name);
    }
    std::error_code error;
    std::filesystem::create_directories((folder / inside).parent_path(), error);
    std::ofstream out(folder / inside, std::ios::binary);
    const bool whole = readEntry(
        archive.get(), name,
        [&](std::string_view piece) {
          out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
          return static_cast<bool>(out);
        },
        task);
    out.close();
    if (!out) throw failure<MessageId::package_not_unpacked>(name);
    if (!whole) throw failure<MessageId::package_part_damaged>(name, shownName(file));
  }
}

PackageCheck verifyPackage(const std::filesystem::path& file, const Task& task) {
  const Zip archive = openZip(file);
  const auto text = entryText(archive.get(), kManifest, task);
  const auto manifest = text ? manifestFrom(*text) : std::nullopt;
  if (!manifest) {
    throw failure<MessageId::package_not_checked>(shownName(file), kManifest);
  }
  PackageCheck check;
  for (const auto& [name, sha256] : *manifest) {
    checkEntry(archive.get(), name, sha256, check, task);
  }
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_UTF_8);
    if (name == nullptr || std::string_view(name) == kManifest || manifest->contains(name))
      continue;
    if (std::string_view(name).ends_with('/')) continue;  // A folder, as other programs store them.
    check.problems.push_back("'" + std::string(name) + "' was added after packing.");
  }
  const auto project = entryText(archive.get(), kProject, task);
  if (!project) {
    check.problems.push_back("There is no " + std::string(kProject) + ".");
    return check;
  }
  try {
    checkNames(projectFromJson(*project, kProject), *manifest, check);
  } catch (const FileError& error) {
    check.problems.emplace_back(error.what());
  }
  return check;
}

}  // namespace relievo
