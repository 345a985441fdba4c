// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/input_facts.h"
#include "core/io/raster/picture_pixels.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/worker/scan_transport.h"

namespace relievo {

// How what is known of a file travels from the import process. Nothing: it makes no sense.
WorkerText textOf(const std::vector<std::optional<InputFacts>>& facts);
std::optional<std::vector<std::optional<InputFacts>>> inputFactsOf(const WorkerText& text);

WorkerText textOf(const std::optional<std::string>& state);
std::optional<std::optional<std::string>> stateOf(const WorkerText& text);

WorkerText textOf(const std::optional<StoredPixels>& pixels);
std::optional<std::optional<StoredPixels>> pixelsOf(const WorkerText& text);

WorkerText textOf(const std::vector<std::optional<TiffHead>>& heads);
std::optional<std::vector<std::optional<TiffHead>>> tiffHeadsOf(const WorkerText& text);

}  // namespace relievo
