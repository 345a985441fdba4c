// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/project_files.h"
#include "core/provenance/provenance.h"
#include "core/session/surface.h"

namespace relievo::batch {

/// An input whose checksum is not the one that a state names (E501); exit status 5.
struct ChangedInputError : FileError {
  using FileError::FileError;
};

/// Where what a verb writes to `out` comes from.
Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const std::filesystem::path& out, const Task& task);

/// The same as a project, for pictures; `file` is as given.
Project projectOfVerb(const MapArguments& arguments, const Surface& surface, const Region& region,
                      double gain, const Task& task);

/// Files that a project, picture or log names, who made it chose: may those be read that lie
/// outside of its folder and are not, by their checksums, what it was made from (docs/adr/0136)?
enum class OutsideFiles { refuse, allow };
void addOutsideOption(CLI::App& verb, OutsideFiles& outside);
/// @throw FileError  `named` must not be read; `instead`: how to give the file by oneself
void requireOwn(const std::filesystem::path& host_file, const InputFile& named,
                OutsideFiles outside, const std::string& instead, const Task& task);

/// Which state comes back, and whether what it was made from may have changed.
struct HostFileArguments {
  std::string from_image, project;  ///< At most one.
  std::string place = {};           ///< Which of its places; empty: what it shows.
  bool changed_input = false;
  OutsideFiles outside_files = OutsideFiles::refuse;
  bool given() const { return !from_image.empty() || !project.empty(); }
};
void addHostFileOptions(CLI::App& verb, HostFileArguments& arguments);

/// What the state says must not be said again, differently.
/// @throw ArgumentError  naming an option that is given beside it and not among `allowed`
void refuseBeside(const CLI::App& verb, const HostFileArguments& arguments,
                  std::initializer_list<const char*> allowed);

/// Which file is taken for the one that a state names.
struct InputChoice {
  std::string given;  ///< Empty: looked for.
  bool accept_changed = false;
  OutsideFiles outside = OutsideFiles::refuse;
};

/// Sets file and checksum of a state to what is there now, as loadStored does.
/// @throw FileError  E501, nowhere there, or outside of the host file's folder and not
/// accepted  @throw ChangedInputError  not accepted
void findInput(Project& project, const std::filesystem::path& host_file, const InputChoice& choice,
               const Task& task);
Surface surfaceOf(const Project& project, const Task& task);

/// The state that a file carries, its input found and checked; no surface is made.
/// @throw FileError, ChangedInputError  as loadStored
Project storedProject(const HostFileArguments& arguments, const std::string& given,
                      const Task& task);

/// The recording that the state would have plotted: one of the project's, or of its very input.
/// @throw FileError  it must not be read
void requireOwnRecording(const Project& project, const HostFileArguments& host_file,
                         const Task& task);

/// A state that came back, and the surface it belongs to.
struct Stored {
  Surface surface;
  Project project;
};
/// Finds and checks the input: `given` if it is not empty, else where the state says, beside the
/// host file, and in the working folder; then makes the surface.
/// @throw FileError  no state, or (E501) no input  @throw ChangedInputError  not accepted
Stored loadStored(const HostFileArguments& arguments, const std::string& given, const Task& task);

/// What of the state is shown: a view of its places, one of them, a region, in this order; each
/// goes beyond those before. @param view  a view's name; empty: none
/// @return whether anything was asked for  @throw ArgumentError  no such place, view or level
bool showChosen(Stored& state, const HostFileArguments& host_file, const std::string& view,
                const RegionArguments& region);

}  // namespace relievo::batch
