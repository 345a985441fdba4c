// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/drawing.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace relievo::batch {
namespace {

std::optional<Drawing>& drawingOfThisProgram() {
  static std::optional<Drawing> drawing;
  return drawing;
}

}  // namespace

void setDrawing(Drawing drawing) {
  drawingOfThisProgram() = std::move(drawing);
}

const Drawing* drawing() {
  const std::optional<Drawing>& own = drawingOfThisProgram();
  return own ? &*own : nullptr;
}

const std::vector<DrawingVerb>& drawingVerbs() {
  static const std::vector<DrawingVerb> verbs{
      {"render", "Picture of a region at its level, as the detail view shows it"},
      {"figure", "Figure for print: overview and detail with scale bar, legend and caption"},
      {"video", "Video of a recording: detail, whole object and plots, frame by frame"}};
  return verbs;
}

bool isDrawingVerb(std::string_view name) {
  return std::any_of(drawingVerbs().begin(), drawingVerbs().end(),
                     [name](const DrawingVerb& verb) { return verb.name == name; });
}

std::string helpOfDrawingVerb(std::string_view name) {
  for (const DrawingVerb& verb : drawingVerbs()) {
    if (verb.name == name) return verb.help;
  }
  return {};
}

}  // namespace relievo::batch
