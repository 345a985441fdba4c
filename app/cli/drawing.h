// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/verb.h"
#include "core/depth/depth_request.h"
#include "core/provenance/libraries.h"

namespace relievo::batch {

/// What needs OpenGL and fonts. Only the program `relievo-draw` has it; `relievo`, which needs none
/// of those libraries, goes on as that program where it is needed (docs/adr/0151).
struct Drawing {
  DepthEngine depth_buffer;
  std::vector<LibraryVersion> (*libraries)() = nullptr;
  std::vector<Verb> (*verbs)() = nullptr;  ///< render, figure, video, as `drawingVerbs` lists them.
};

/// Before the command line is read. [main thread]
void setDrawing(Drawing drawing);

/// Null where this program does not draw.
const Drawing* drawing();

/// Name and line of help of the verbs that draw, known to every program.
struct DrawingVerb {
  const char* name;
  const char* help;
};
const std::vector<DrawingVerb>& drawingVerbs();
bool isDrawingVerb(std::string_view name);
std::string helpOfDrawingVerb(std::string_view name);

/// What a verb throws that finds, after its options are read, that it needs the depth buffer in a
/// program that does not draw. It is no error: only `runBatch` catches it.
struct NeedsDrawing {};

}  // namespace relievo::batch
