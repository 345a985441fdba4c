// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/published/published_input.h"

#include <CLI/CLI.hpp>

#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/provenance/name_text.h"
#include "core/provenance/sha256.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/tiled_map.h"

namespace relievo::batch {
namespace {

constexpr const char* kLooksAtAddress = "looks at an address";  // The parser's name of it.

}  // namespace

CLI::Option* mayBeWebAddress(CLI::Option* file) {
  return file->transform(
      [](const std::string& word) {
        if (!isWebAddress(word)) return word;
        const WebMap map = webMap(word);
        if (map.from_before) tell(englishText(said<MessageId::web_map_from_before>(word)));
        return map.manifest.string();
      },
      "", kLooksAtAddress);
}

void leaveWebAddress(CLI::Option* file) {
  file->get_validator(kLooksAtAddress)->active(false);
}

std::string calledInput(const std::string& file) {
  const std::string address = addressOfKeptMap(file);
  return address.empty() ? file : address;
}

CommandResult infoOfPublished(const std::string& file, const Task& task) {
  const TiledMap map(file);
  const PublishedMap& says = *map.published();
  const GridSize size = map.frames().front().size;
  const double spacing_mm = map.frames().front().spacing_mm;
  Json levels = Json::array();
  for (const GridFrame& frame : map.frames()) {
    levels.push_back(
        {{"cells", {frame.size.cols, frame.size.rows}}, {"spacing_mm", frame.spacing_mm}});
  }
  const std::string sha256 = sha256OfFile(file, task);
  Json json{{"file", textOfName(file)},
            {"format", "published map"},
            {"place", textOfName(map.place())},
            {"title", says.title},
            {"licence", says.licence},
            {"citation", says.citation},
            {"made_from", says.made_from},
            {"levels", std::move(levels)},
            {"heights_mm", {says.low_mm, says.high_mm}},
            {"unit", "mm"},
            {"colours", map.hasColours()},
            {"intensities", map.hasIntensities()},
            {"sha256", sha256}};
  const auto text = [](double number) { return Json(number).dump(); };
  return {
      .json = reportText(json),
      .lines = {map.place() + ": published map, " + std::to_string(map.frames().size()) + " levels",
                "\"" + says.title + "\", licence " + says.licence + ", cite as: " + says.citation,
                std::to_string(size.cols) + " x " + std::to_string(size.rows) + " cells of " +
                    text(spacing_mm) + " mm, heights from " + text(says.low_mm) + " to " +
                    text(says.high_mm) + " mm",
                "SHA-256 " + sha256}};
}

}  // namespace relievo::batch
