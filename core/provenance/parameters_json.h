// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for .cpp files of core/provenance and core/project: the records of the pipeline as JSON and
// back.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/provenance/provenance.h"

namespace relievo {

using Json = nlohmann::ordered_json;

/// A text from outside; what is nested deeper than 64 is refused, because writing it recurses.
/// @throw FileError, nlohmann::json::exception
Json parsedJson(std::string_view text);

/// @throw FileError  always
[[noreturn]] void throwUnknownWord(const std::string& word, const char* key);

/// One of the words of a list, by its place. @throw FileError naming the key
template <class Enum, std::size_t N>
Enum word(const Json& json, const char* key, const std::array<std::string_view, N>& names) {
  const auto said = json.at(key).get<std::string>();
  const auto* const found = std::find(names.begin(), names.end(), said);
  if (found == names.end()) {
    throwUnknownWord(said, key);
  }
  return static_cast<Enum>(found - names.begin());
}

Json jsonOf(const InputFile& input);
/// Into the object of the input; keys only for what is not the default.
void putScanChoices(const ScanChoices& choices, Json& input);
Json jsonOf(const SurfaceOptions& options);
Json jsonOf(const ReliefLook& look);
Json jsonOf(const ViewState& view);
Json jsonOf(const PictureChoice& picture);

// Each reads what jsonOf wrote. @throw FileError or nlohmann::json::exception saying which value
InputFile inputFrom(const Json& json);
ScanChoices scanChoicesFrom(const Json& input);
SurfaceOptions optionsFrom(const Json& json);
ReliefLook lookFrom(const Json& json);
ViewState viewFrom(const Json& json);
PictureChoice pictureFrom(const Json& json);

}  // namespace relievo
