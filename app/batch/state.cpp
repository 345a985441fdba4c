// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/state.h"

#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/provenance/embedded.h"
#include "core/session/tiled_surface.h"
#include "core/tiles/tiled_map.h"

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
                      "', which is not there. Nothing was made. Give its place as FILE.",
                  "E501");
}

/// @throw FileError (E501)
StoredState withInput(const Provenance& provenance, const std::filesystem::path& carrier,
                      const std::string& given, bool accept_changed, const Task& task) {
  StoredState state{.provenance = provenance, .input = given};
  if (given.empty()) state.input = foundInput(carrier, provenance.input);
  if (sha256OfFile(state.input, task) == provenance.input.sha256) return state;
  const std::string changed = "'" + state.input.filename().string() + "' is not the file that " +
                              carrier.filename().string() + " was made from (checksum differs).";
  if (!accept_changed) {
    throw FileError(changed +
                        " Nothing was made. Give the right one as FILE, or --changed-input to use "
                        "this one.",
                    "E501");
  }
  tell(changed + " It was used all the same.");
  state.input_changed = true;
  return state;
}

}  // namespace

Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const std::filesystem::path& out, const Task& task) {
  Provenance provenance = provenanceOf(surface, surfaceOptions(arguments));
  const std::filesystem::path folder = out.parent_path();
  provenance.input =
      inputFile(arguments.file, folder.empty() ? std::filesystem::path(".") : folder, task);
  provenance.accept_incomplete = arguments.accept_incomplete;
  return provenance;
}

StoredState storedState(const std::filesystem::path& file, const std::string& given,
                        bool accept_changed, const Task& task) {
  const std::optional<std::string> json = embeddedState(file);
  const std::string shown = file.filename().string();
  if (!json) {
    throw FileError(shown +
                    " carries no state of relievo. Nothing was made. Choose a file as relievo "
                    "wrote it; other programs may drop what is inside.");
  }
  const Provenance provenance = provenanceFromJson(*json, shown);
  return withInput(provenance, file, given, accept_changed, task);
}

Surface loadStored(const StoredState& state, const Task& task) {
  if (TiledMap::isOne(state.input)) return openTiledSurface(state.input);
  ImportOptions import;
  import.accept_incomplete = state.provenance.accept_incomplete;
  return loadForVerb(state.input.string(), state.provenance.options, import, task);
}

}  // namespace relievo::batch
