// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for .cpp files of core/provenance: the records of the pipeline as JSON and back.
#include <nlohmann/json.hpp>

#include "core/provenance/provenance.h"

namespace relievo {

using Json = nlohmann::ordered_json;

/// A text from outside; what is nested deeper than 64 is refused, because writing it recurses.
/// @throw FileError, nlohmann::json::exception
Json parsedJson(std::string_view text);

Json jsonOf(const InputFile& input);
Json jsonOf(const SurfaceOptions& options);
Json jsonOf(const ViewState& view);
Json jsonOf(const PictureChoice& picture);

// Each reads what jsonOf wrote. @throw FileError or nlohmann::json::exception saying which value
InputFile inputFrom(const Json& json);
SurfaceOptions optionsFrom(const Json& json);
ViewState viewFrom(const Json& json);
PictureChoice pictureFrom(const Json& json);

}  // namespace relievo
