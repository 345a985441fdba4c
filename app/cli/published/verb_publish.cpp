// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/tiles/published/publish.h"
#include "core/tiles/tiled_map.h"

namespace relievo::batch {
namespace {

struct PublishArguments {
  std::string map, out;
  PublishWords words;
};

CommandResult runPublish(const PublishArguments& a, const Task& task) {
  checkedFileSize(a.map);
  if (!TiledMap::isOne(a.map)) {
    throw failure<MessageId::publish_not_by_tiles>(std::filesystem::path(a.map));
  }
  const TiledMap map(a.map);
  PublishWords words = a.words;
  if (words.title.empty()) words.title = shownName(std::filesystem::path(a.map).stem());
  const Published done = publish(map, a.out, words, task);
  Json json{{"folder", a.out},
            {"levels", map.frames().size()},
            {"tiles", done.tiles},
            {"outside_tiles", done.outside_tiles},
            {"packs", done.packs},
            {"bytes", done.bytes},
            {"bytes_of_tiles", done.bytes_of_tiles},
            {"title", words.title},
            {"licence", words.licence},
            {"citation", words.citation},
            {"sha256", done.sha256}};
  return {.json = reportText(json),
          .lines = {a.out + ": " + std::to_string(map.frames().size()) + " levels, " +
                        grouped(done.tiles) + " tiles in " + grouped(done.packs) + " files, " +
                        grouped(done.bytes / 1'000'000) + " MB",
                    "Put the folder on any web server that gives parts of files; its address is "
                    "what others open. SHA-256 " +
                        done.sha256}};
}

void declarePublish(CLI::App& verb, PublishArguments& a) {
  verb.add_option("FILE", a.map, "Map by tiles, of depthmap --memory or pyramid --memory")
      ->required();
  verb.add_option("-o,--output", a.out, "Folder, empty or not there yet")->required();
  verb.add_option("--licence", a.words.licence, "Under which others may use it, such as CC-BY-4.0")
      ->required();
  verb.add_option("--citation", a.words.citation, "How it is to be cited")->required();
  verb.add_option("--title", a.words.title, "What it is called; the file's name");
}

}  // namespace

Verb publishVerb() {
  auto arguments = std::make_shared<PublishArguments>();
  return {.name = "publish",
          .help = "Make a folder of a map by tiles that others open from a web address",
          .declare = [arguments](CLI::App& verb) { declarePublish(verb, *arguments); },
          .files =
              [arguments] {
                VerbFiles files;
                files.reads(arguments->map);
                return files;
              },
          .run = [arguments](const Task& task) { return runPublish(*arguments, task); }};
}

}  // namespace relievo::batch
