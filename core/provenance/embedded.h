// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/io/raster/embedded_state.h"

namespace relievo {

/// A provenance as a comment line of a CSV file, without the leading "#" and the line end.
std::string stateLine(std::string_view json);

/// Text for the content of an XML element.
std::string markupText(std::string_view text);

/// A state as an XML element, for an SVG's <metadata> and the XMP packet of a PDF.
std::string stateElement(std::string_view json);

/// A drawing with a state in its metadata. @param svg  with an <svg> element
std::string withState(std::string svg, std::string_view json);

}  // namespace relievo
