// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

/// Name of the entry that carries a state: PNG text chunk, comment line of a CSV file, line of a
/// TIFF's description after the caption, and element of an SVG's or a PDF's metadata.
inline constexpr std::string_view kStateKey = "relievo:state";

/// A provenance as a comment line of a CSV file, without the leading "#" and the line end.
std::string stateLine(std::string_view json);

/// Text for the content of an XML element.
std::string markupText(std::string_view text);

/// A state as an XML element, for an SVG's <metadata> and the XMP packet of a PDF.
std::string stateElement(std::string_view json);

/// A drawing with a state in its metadata. @param svg  with an <svg> element
std::string withState(std::string svg, std::string_view json);

/// The state that a PNG, TIFF, PDF, SVG, CSV or PLY file of ours carries, as JSON: a provenance, in
/// pictures a project, in clouds how they were prepared; nothing if it has none. The file is told
/// by its content, not by its name. [worker]
/// @throw FileError  missing, or damaged before the entry
std::optional<std::string> embeddedState(const std::filesystem::path& file);

}  // namespace relievo
