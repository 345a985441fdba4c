// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
class Option;
}  // namespace CLI

namespace relievo::batch {

/// Places and heights in mm: farther than any scan, so that sums stay exact to a micrometre.
inline constexpr double kFarMm = 1e9;

/// What an option's number may be, both ends included. A number that is not finite is in no range.
struct NumberRange {
  double low = 0;
  double high = 0;
  const char* unit = "";  ///< As --help and a refusal show it; empty: a bare number.
};

/// The option takes one number of this range, or several that CLI11 splits. The command line is
/// refused while it is read (CLI::ValidationError, exit 1), before any file is opened.
/// @return the same option
CLI::Option& takes(CLI::Option* option, const NumberRange& range);

/// The option takes `count` numbers in one text, separated by commas, each of this range.
/// @return the same option
CLI::Option& takesList(CLI::Option* option, std::size_t count, const NumberRange& range);

/// Every option of the verb and of its subcommands refuses an empty text: no file, word or number
/// is empty, and "-o ''" would write files that have an ending and no name.
void refuseEmptyTexts(CLI::App& verb);

}  // namespace relievo::batch
