// SPDX-License-Identifier: BSD-3-Clause
#include "app/draw/compare_figure.h"

#include "app/cli/json.h"
#include "app/cli/library_versions.h"
#include "app/cli/report_text.h"
#include "core/project/embedded_state.h"
#include "core/provenance/program.h"
#include "core/session/large/tiled_surface.h"
#include "ui/figure/figure.h"
#include "ui/figure/view_picture.h"
#include "ui/vtk/files/read_picture.h"
#include "ui/vtk/offscreen.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

StoredPixels drawnAgain(const Stored& stored, const Task& task) {
  const DisplayGuard display;
  const Project& p = stored.project;
  if (p.picture) {
    const RegionWindow window = windowOf(stored.surface, p.region, p.gain);
    return storedPixels(drawViewPicture(stored.surface, window, p, task));
  }
  const FigureSession session;
  return storedPixels(drawFigure(stored.surface, p, task).image);
}

std::string textAt(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() && found->is_string() ? found->get<std::string>()
                                                                       : std::string();
}

Json objectAt(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) ? json.at(key) : Json::object();
}

/// Program and libraries that differ from those that drew the picture: name -> [then, now].
Json otherPrograms(const std::string& state) {
  const Json then = Json::parse(state, nullptr, false);
  Json differ = Json::object();
  const auto compare = [&](const std::string& name, const std::string& before,
                           const std::string& now) {
    if (!before.empty() && before != now) differ[name] = {before, now};
  };
  const Json program = objectAt(then, "program");
  compare("relievo", textAt(program, "version"), std::string(programVersion()));
  compare("commit", textAt(program, "commit"), std::string(programCommit()));
  const Json libraries = objectAt(objectAt(then, "made"), "libraries");
  for (const LibraryVersion& one : libraryVersions()) {
    compare(one.name, textAt(libraries, one.name.c_str()), one.version);
  }
  return differ;
}

std::string sizeText(const StoredPixels& p) {
  return std::to_string(p.width) + " x " + std::to_string(p.height) + " pixels";
}

}  // namespace

CommandResult compareFigure(const HostFileArguments& picture, const std::string& given,
                            const Task& task) {
  const fs::path file = picture.from_image;
  const std::string name = file.filename().string();
  const std::optional<StoredPixels> before = importPixels(file, task);
  if (!before) {
    throw FileError(
        name +
        " has no pixels of 8 bits in red, green and blue that could be compared. Nothing "
        "was drawn. Choose a .png or .tif that relievo drew.");
  }
  const Stored stored = loadStored(picture, given, task);
  if (!stored.project.figure.recording.empty()) {
    requireOwnRecording(stored.project, picture, task);
  }
  const StoredPixels now = drawnAgain(stored, task);
  task.check();
  const bool one_size = before->width == now.width && before->height == now.height;
  const PixelDifference difference = one_size ? differenceOf(*before, now) : PixelDifference{};
  const bool same = one_size && difference.pixels == 0;
  const Json others = otherPrograms(embeddedStateOf(file).value_or(std::string()));
  Json json;
  json["file"] = picture.from_image;
  json["same"] = same;
  json["pixels"] = {before->width, before->height};
  json["drawn_again"] = {now.width, now.height};
  json["differing_pixels"] = one_size ? Json(difference.pixels) : Json(nullptr);
  json["largest_difference"] = one_size ? Json(difference.largest) : Json(nullptr);
  json["other_programs"] = others;
  CommandResult outcome{.json = reportText(json), .lines = {}, .exit_code = same ? 0 : 5};
  if (same) {
    outcome.lines.push_back(name + ": drawn again with the same " + sizeText(now));
  } else if (!one_size) {
    outcome.lines.push_back(name + " has " + sizeText(*before) + ", drawn again it has " +
                            sizeText(now));
  } else {
    outcome.lines.push_back(
        name + ": " + counted(difference.pixels, "pixel differs", "pixels differ") +
        " when it is drawn again, by " + std::to_string(difference.largest) + " of 255 at most");
  }
  for (const auto& [what, versions] : others.items()) {
    outcome.lines.push_back(what + ": " + versions[0].get<std::string>() + " then, " +
                            versions[1].get<std::string>() + " now");
  }
  return outcome;
}

}  // namespace relievo::batch
