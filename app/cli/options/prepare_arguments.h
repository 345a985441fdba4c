// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/state.h"
#include "core/prepare/prepare.h"
#include "core/provenance/sha256.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace relievo::batch {

/// Which scans, and what is done to them: a recipe from a file, or options in a fixed order.
struct PrepareArguments {
  std::vector<std::string> files;  ///< Empty: as the recipe names them.
  std::string recipe;              ///< Empty: from the options below.
  std::string unit;                ///< Of all scans; empty: as each file says.
  std::string crop, classes, returns, intensity, outliers, lonely, sparse, align, base;
  bool drop_duplicates = false, clean = false;
  std::optional<unsigned> reference, seed;
  std::optional<double> thin_mm;
  std::optional<int> normals;
  OutsideFiles outside_files = OutsideFiles::refuse;  ///< Of the recipe.
  ScanArguments scan;                                 ///< Of all files.
};
void addStepOptions(CLI::App& verb, PrepareArguments& arguments);

/// The steps that they ask for; with a recipe file its scans and steps.
/// @throw ArgumentError  a value that is not of its option's form, or a step beside a recipe
/// @throw FileError  the recipe or the file of pairs cannot be read
Recipe recipeOf(const PrepareArguments& arguments);

/// The scans that are read: those given, else those of the recipe, found from its folder.
/// @throw ArgumentError  there are none
std::vector<std::filesystem::path> scansOf(const PrepareArguments& arguments, const Recipe& recipe);

/// What a recipe made of files.
struct PreparedFiles {
  Prepared prepared;
  Recipe again;  ///< Does the same again, from the folder of what is written.
  std::vector<InputFile> inputs;
  std::vector<std::uint64_t> points;  ///< Records stored, per input.
};

/// Reads the scans, does the steps, and tells all warnings on stderr.
/// @param out  what is written: files are named as they are found from its folder
/// @throw Error  as importScan and prepare  @throw ChangedInputError  a scan of the recipe is
///               another file now, and was not given
PreparedFiles preparedFiles(const PrepareArguments& arguments, const PrepareOptions& options,
                            const std::filesystem::path& out, const Task& task);

}  // namespace relievo::batch
