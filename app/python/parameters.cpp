// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/parameters.h"

#include <CLI/CLI.hpp>

#include "app/cli/options/number_option.h"
#include "app/cli/refusal_text.h"
#include "app/python/plain_numbers.h"
#include "core/base/error.h"

namespace relievo::python {
namespace {

void parse(CLI::App& parser, const Words& words) {
  const PlainNumbers points_in_numbers;
  batch::refuseEmptyTexts(parser);
  try {
    parser.parse(Words(words.rbegin(), words.rend()));  // The parser takes the last one first.
  } catch (const CLI::ParseError& error) {
    const std::string message = batch::refusalText(error.what());
    throw ArgumentError(message);
  }
}

}  // namespace

batch::MapArguments mapArguments(const Words& words) {
  CLI::App parser;
  batch::MapArguments arguments;
  batch::addMapOptions(parser, arguments);
  parse(parser, words);
  return arguments;
}

batch::RegionArguments regionArguments(const Words& words) {
  CLI::App parser;
  batch::RegionArguments arguments;
  batch::addRegionOptions(parser, arguments);
  parse(parser, words);
  return arguments;
}

batch::TouchArguments touchArguments(const Words& words) {
  CLI::App parser;
  batch::TouchArguments arguments;
  batch::declareTouch(parser, arguments);
  parser.get_option("--stroke")->required(false);
  parser.get_option("--output")->required(false);
  parse(parser, words);
  arguments.words = words;
  arguments.words.insert(arguments.words.begin(), "touch");
  return arguments;
}

}  // namespace relievo::python
