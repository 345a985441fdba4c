// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "app/draw/drawing_verbs.h"
#include "app/manual/manual.h"
#include "app/options.h"

namespace relievo::manual {
namespace {

std::vector<std::string> wordsOf(const std::string& value) {
  if (value.find('|') == std::string::npos) return {};
  std::vector<std::string> words;
  std::istringstream in(value);
  for (std::string word; std::getline(in, word, '|');) words.push_back(word);
  return words;
}

}  // namespace

CommandLine commandLine() {
  batch::setDrawing(batch::ownDrawing());  // Else the verbs that draw have no options.
  CommandLine line{.window = {}, .verbs = commandTable()};
  for (const WindowOptionRow& row : windowOptionRows()) {
    line.window.push_back(
        {.names = row.names, .value = row.value, .words = wordsOf(row.value), .help = row.help});
  }
  return line;
}

}  // namespace relievo::manual
