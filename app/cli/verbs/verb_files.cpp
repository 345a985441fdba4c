// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/verb_files.h"

#include <system_error>

#include "core/base/failure.h"
#include "core/io/export/export_grid.h"
#include "core/io/raster/colour_raster.h"
#include "core/project/embedded_state.h"
#include "core/project/project_files.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tiled_map.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLevels = 1000;  // Of the smallest factor between them, on any disk.

bool isThere(const fs::path& file) {
  std::error_code unknown;  // What cannot be asked cannot be read either.
  return fs::exists(file, unknown);
}

void addState(VerbFiles& files, const fs::path& host_file, const std::string& given) {
  if (!isThere(host_file)) return;  // Whoever reads it says so.
  const auto project = embeddedProject(host_file);
  if (!project) return;
  files.reads(given.empty() ? foundInput(host_file, project->file) : fs::path(given));
  for (const InputFile& recording : project->recordings) {
    files.reads(recording.file, "a recording of the project that is read");
  }
  files.reads(project->figure.recording, "the recording that is read");
}

}  // namespace

void VerbFiles::reads(const fs::path& file, const std::string& what) {
  if (!file.empty()) inputs.push_back({.file = file, .what = what});
}

void VerbFiles::reads(const fs::path& scan) {
  if (scan.empty()) return;
  inputs.push_back({.file = scan});
  const std::string part = "a part of the map that is read";
  if (scan.extension() == ".tif") {
    reads(originFile(scan), part);
    reads(colourFileOf(scan), part);
    reads(intensityFileOf(scan), part);
  }
  // Levels beside other rasters came from them and may come again.
  const bool tiled = isThere(levelFile(scan, 1)) && TiledMap::isOne(scan);
  for (int level = 1; tiled && isThere(levelFile(scan, level)); ++level) {
    reads(levelFile(scan, level), part);
    reads(originFile(levelFile(scan, level)), part);
  }
  for (const char* ending : {".tfw", ".pgw", ".wld", ".prj"}) {
    reads(fs::path(scan).replace_extension(ending), "the georeference of the scan");
  }
  reads(scan.string() + ".aux.xml", "the georeference of the scan");
}

void VerbFiles::readsStateOf(const HostFileArguments& host_file, const std::string& given) {
  if (!host_file.given()) {
    reads(given);
    return;
  }
  reads(host_file.from_image, "the picture that is read");
  reads(host_file.project, "the project that is read");
  addState(*this, host_file.from_image.empty() ? host_file.project : host_file.from_image, given);
}

void VerbFiles::readsStateOf(const fs::path& log, const std::string& given) {
  reads(log, "the recording that is read");
  addState(*this, log, given);
}

void VerbFiles::writes(const fs::path& file) {
  if (!file.empty() && file != "-") outputs.push_back(file);
}

void VerbFiles::writesMap(const fs::path& map) {
  if (map.empty()) return;
  writes(map);
  writes(originFile(map));
  writesColoursOf(map);
}

void VerbFiles::namesMap(const std::string& option, const fs::path& map) {
  if (!map.empty()) maps.push_back({.option = option, .file = map});
}

void VerbFiles::writesColoursOf(const fs::path& map) {
  writes(colourFileOf(map));
  writes(intensityFileOf(map));
}

void VerbFiles::writesLevels(const fs::path& finest) {
  writesMap(finest);
  for (int level = 1; level < kMostLevels; ++level) {
    const fs::path file = levelFile(finest, level);
    if (isThere(file) || isThere(originFile(file))) writesMap(file);
  }
}

void check(const VerbFiles& files) {
  for (const fs::path& out : files.outputs) requireNotAnInput(out, files.inputs);
  requireDifferentFiles(files.outputs);
  for (const VerbFiles::NamedMap& map : files.maps) {
    if (exportFormatOf(map.file) == ExportFormat::geotiff) continue;
    throw failure<MessageId::measure_name>(map.option, ".tif or .tiff", map.file.string());
  }
}

}  // namespace relievo::batch
