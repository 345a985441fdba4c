// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/project/project.h"

namespace relievo {

/// What goes into a package for citation besides the project itself.
struct PackageContents {
  bool with_input = true;  ///< False: only its name and checksum, if it may not be given away.
  std::vector<std::filesystem::path> figures = {};
  /// Which other files a recording needs to be repeated (rasters of firm ground, other scans);
  /// empty: none. They are packed beside it. [worker]
  std::function<std::vector<InputFile>(const std::filesystem::path& recording, const Task& task)>
      dependencies = {};
};

/// One zip that can be cited: project.json, input/ (of a map by tiles with all levels),
/// recordings/ with what else they need, figures/, README.txt, and manifest-sha256.txt (the form of
/// `sha256sum -c`) over all of them. The same contents give the same bytes. Written beside the
/// target and renamed. [worker]
/// @throw FileError  a file of the project is missing or changed  @throw WriteError, Cancelled
void writePackage(const std::filesystem::path& target, const Project& project,
                  const PackageContents& contents, const Task& task = {});

struct PackageCheck {
  std::uint64_t files = 0;            ///< Named by the manifest and as it says.
  std::vector<std::string> problems;  ///< One sentence each; empty: all is as it was packed.
};
/// Compares every file of a package with its manifest, and its project with the schema. Nothing is
/// unpacked. [worker] @throw FileError  no zip, or no manifest in it  @throw Cancelled
PackageCheck verifyPackage(const std::filesystem::path& file, const Task& task = {});

/// Is it a zip with the manifest and the project of a package? Neither is read.
bool isPackageOfRelievo(const std::filesystem::path& file);

/// The project of a package; it names its files as they are called in the zip. Nothing is unpacked,
/// and nothing is compared with the manifest. [worker]
/// @throw FileError  no zip, or no project in it that can be read  @throw Cancelled
Project projectInPackage(const std::filesystem::path& file, const Task& task = {});

/// Unpacks the files that the manifest names into a folder that exists. Names that lead out of it
/// are refused. [worker] @throw FileError  as verifyPackage, or a damaged file  @throw WriteError,
/// Cancelled
void unpackPackage(const std::filesystem::path& file, const std::filesystem::path& folder,
                   const Task& task = {});

}  // namespace relievo
