// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/replay_window.h"

#include <map>
#include <memory>

#include "app/batch/state.h"
#include "core/base/error.h"
#include "core/session/finer_heights.h"
#include "core/session/tiled_surface.h"
#include "haptics/proxy/texture.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/rt/build_id.h"

namespace relievo::batch {
namespace {

/// The surfaces of a recording, each prepared once.
class Scenes {
 public:
  explicit Scenes(Surface surface) : surface_(std::move(surface)) {}

  const HapticSpace& at(const RecordedScene& scene) {
    std::unique_ptr<HapticSpace>& space = spaces_[scene.id];
    if (!space) space = made(scene);
    return *space;
  }

 private:
  std::unique_ptr<HapticSpace> made(const RecordedScene& scene) const {
    RegionWindow window = windowOf(surface_, scene.region, scene.gain);
    window.id = scene.window_id;
    auto space = std::make_unique<HapticSpace>();
    const DetailLadder& ladder = surface_.ladder;
    fill(*space, window, {ladder.detailOf(scene.region.level), ladder.levels()}, scene.kind,
         scene.anchor);
    if (scene.textured) fillTexture(*space, finerHeights(surface_, scene.region, scene.gain));
    space->scene_id = scene.id;
    if (sceneChecksum(*space) != scene.checksum) {
      throw FileError("Window " + std::to_string(scene.window_id) +
                      " is not what was touched: the surface was changed during the recording, or "
                      "its depth map cannot be made again. Nothing was replayed.");
    }
    return space;
  }

  Surface surface_;
  std::map<std::uint64_t, std::unique_ptr<HapticSpace>> spaces_;
};

}  // namespace

std::optional<ReplayResult> replayOfWindow(
    const LogTable& log, const std::string& file, const std::string& input,
    const std::function<void(const HapticSample&, double t_s)>& each, const Task& task) {
  const std::optional<RecordedLoop> loop = recordedLoop(log.footer, buildId());
  if (!loop) return std::nullopt;
  Scenes scenes(loadStored({.from_image = file, .project = {}}, input, task).surface);
  return replayLoop(
      *loop, log,
      [&scenes](const RecordedScene& scene) -> const HapticSpace& { return scenes.at(scene); },
      each, task);
}

}  // namespace relievo::batch
