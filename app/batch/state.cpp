// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/state.h"

#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/provenance/embedded.h"
#include "core/session/tiled_surface.h"
#include "core/tiles/tiled_map.h"
#include "haptics/record/sample_log.h"
#include "ui/vtk/picture_file.h"

namespace relievo::batch {
namespace {

std::filesystem::path foundInput(const std::filesystem::path& carrier, const InputFile& input) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(carrier, error).parent_path();
  const fs::path stored(input.file);
  for (const fs::path& candidate :
       {(folder / stored).lexically_normal(), folder / stored.filename(), stored.filename(),
        (folder / "../input" / stored.filename()).lexically_normal()}) {  // An unpacked package.
    if (fs::is_regular_file(candidate, error)) return candidate;
  }
  throw FileError(carrier.filename().string() + " was made from '" + input.file +
                      "', which is not there (E501). Nothing was made. Give its place as FILE.",
                  "E501");
}

Provenance withInput(Provenance provenance, const MapArguments& arguments,
                     const std::filesystem::path& out, const Task& task) {
  const std::filesystem::path folder = out.parent_path();
  provenance.input =
      inputFile(arguments.file, folder.empty() ? std::filesystem::path(".") : folder, task);
  provenance.accept_incomplete = arguments.accept_incomplete;
  return provenance;
}

}  // namespace

Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const std::filesystem::path& out, const Task& task) {
  return withInput(provenanceOf(surface, surfaceOptions(arguments)), arguments, out, task);
}

Provenance provenanceOfVerb(const MapArguments& arguments, const LargeMap& map,
                            const std::filesystem::path& out, const Task& task) {
  return withInput(provenanceOf(map, surfaceOptions(arguments)), arguments, out, task);
}

std::optional<std::string> carriedState(const std::filesystem::path& file) {
  // A figure's TIFF keeps its state behind the caption, a map's in place of one.
  const std::string head = readHead(file, 2);
  if (head == "II" || head == "MM") {
    if (auto state = pictureState(file)) return state;
  }
  if (readHead(file, 4) == "\x89HDF") return hdf5State(file);
  auto state = embeddedState(file);
  if (state && !state->starts_with('{')) return std::nullopt;  // Another program's description.
  return state;
}

FoundInput findInput(const std::filesystem::path& carrier, const InputFile& input,
                     const std::string& given, bool accept_changed, const Task& task) {
  FoundInput found{.file = given};
  if (given.empty()) found.file = foundInput(carrier, input);
  // Without a checksum nobody can tell.
  if (input.sha256.empty() || sha256OfFile(found.file, task) == input.sha256) return found;
  const std::string changed = "'" + found.file.filename().string() + "' is not the file that " +
                              carrier.filename().string() +
                              " was made from (checksum differs, E501).";
  if (!accept_changed) {
    throw FileError(changed +
                        " Nothing was made. Give the right one as FILE, or --changed-input to use "
                        "this one.",
                    "E501");
  }
  tell(changed + " It was used all the same.");
  found.changed = true;
  return found;
}

StoredState storedState(const std::filesystem::path& file, const std::string& given,
                        bool accept_changed, const Task& task) {
  const std::optional<std::string> json = carriedState(file);
  const std::string shown = file.filename().string();
  if (!json) {
    throw FileError(shown +
                    " carries no state of relievo. Nothing was made. Choose a file as relievo "
                    "wrote it; other programs may drop what is inside.");
  }
  const Provenance provenance = provenanceFromJson(*json, shown);
  const FoundInput input = findInput(file, provenance.input, given, accept_changed, task);
  return {.provenance = provenance, .input = input.file};
}

Surface loadStored(const StoredState& state, const Task& task) {
  if (TiledMap::isOne(state.input)) return openTiledSurface(state.input);
  ImportOptions import;
  import.accept_incomplete = state.provenance.accept_incomplete;
  return loadForVerb(state.input.string(), state.provenance.options, import, task);
}

}  // namespace relievo::batch
