// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/relief/look.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace relievo::batch {

/// How heights are painted, as it stands on the command line.
struct LookArguments {
  std::string relief, colours;  ///< Empty, like all of these: as in the look they change.
  std::string light;            ///< "AZIMUTH,ELEVATION"
  std::string range;            ///< "LOW,HIGH"
  std::optional<double> radius_mm;
  std::optional<double> shading;  ///< 0 ... 1
};
/// --relief, --light and --radius: what decides the values.
void addValueOptions(CLI::App& verb, LookArguments& arguments);
/// These, --colours, --range and --shading.
void addLookOptions(CLI::App& verb, LookArguments& arguments);

/// An option that could change nothing is refused; in the window its field is off.
/// @param needs  what it belongs to @throw ArgumentError  given, but it does not apply
void requireUse(const char* option, bool given, bool applies, const std::string& needs);

struct HostFileArguments;
/// @throw ArgumentError  --changed-input without a state
void requireHostFile(const HostFileArguments& arguments);
/// @throw ArgumentError  --place without a state
void requireProject(const HostFileArguments& arguments);

/// A look with what the arguments say in place of what it said.
/// @throw ArgumentError  a value that is not of its option's form, beyond its limits, or of no use
ReliefLook reliefLook(const LookArguments& arguments, ReliefLook look = {});

/// The words of an option, for its help and for errors.
template <class Names>
std::string listOf(const Names& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : " ") + std::string(name);
  return list;
}

[[noreturn]] void refuseWord(const char* option, const std::string& text, const std::string& words);

template <class Value, class Names>
Value word(const char* option, const std::string& text, std::optional<Value> value,
           const Names& names) {
  if (!value) refuseWord(option, text, listOf(names));
  return *value;
}

}  // namespace relievo::batch
