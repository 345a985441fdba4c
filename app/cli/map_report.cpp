// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/map_report.h"

#include "core/project/caption.h"

namespace relievo::batch {

Json sharesJson(const std::array<double, kOriginCount>& shares) {
  const auto share = [&](CellStatus origin) { return shares[static_cast<std::size_t>(origin)]; };
  return {{"measured", share(CellStatus::measured)},
          {"interpolated", share(CellStatus::interpolated)},
          {"hole", share(CellStatus::base_plane)},
          {"steep", share(CellStatus::steep)},
          {"outside", share(CellStatus::outside)}};
}

Json holesJson(const std::vector<Hole>& holes) {
  Json json = Json::array();
  for (const Hole& hole : holes) {
    json.push_back({{"cells", hole.cells},
                    {"area_mm2", hole.area_mm2},
                    {"centre_mm", {hole.centre_x_mm, hole.centre_y_mm}},
                    {"filled", hole.filled}});
  }
  return json;
}

Json lossesJson(const std::optional<DepthLosses>& losses) {
  if (!losses) return nullptr;
  return {{"hidden_share", losses->hidden_share},
          {"undercut_share", losses->undercut_share},
          {"steep_share", losses->steep_share},
          {"flyers", losses->outliers}};
}

Json sentencesJson(const std::vector<Message>& sentences) {
  Json json = Json::array();
  for (const Message& sentence : sentences) json.push_back(englishText(sentence));
  return json;
}

Json straysJson(const Strays& strays) {
  return {{"points", strays.points},
          {"share_of_box", strays.share_of_box},
          {"kept", strays.kept},
          {"grouped", strays.grouped},
          {"share_of_box_grouped", strays.share_of_box_grouped},
          {"groups_kept", strays.groups_kept}};
}

Json suspectJson(const std::optional<SuspectHeight>& suspect) {
  if (!suspect) return nullptr;
  return {{"value", suspect->value}, {"count", suspect->count}};
}

Json scaleJson(const std::optional<ScaleInUse>& scale) {
  if (!scale) return nullptr;
  return {{"pixel_mm", scale->pixel_mm},
          {"pixel_source", name(scale->pixel_source)},
          {"height_mm", scale->height_mm},
          {"height_source", name(scale->height_source)},
          {"zero", scale->zero ? Json(*scale->zero) : Json(nullptr)}};
}

std::string lossesText(const std::optional<DepthLosses>& losses) {
  if (!losses) return "losses: not known";
  const auto percent = [](double share) { return shortNumber(100 * share, 3) + " % "; };
  return "losses: " + percent(losses->hidden_share) + "of the scan hidden, " +
         percent(losses->undercut_share) + "of the cells with an undercut, " +
         percent(losses->steep_share) + "too steep, " + std::to_string(losses->outliers) +
         " stray points";
}

}  // namespace relievo::batch
