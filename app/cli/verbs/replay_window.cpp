// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/replay_window.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "app/cli/state.h"
#include "app/cli/verbs/packed_file.h"
#include "core/base/failure.h"
#include "core/io/web/web_link.h"
#include "core/project/embedded_state.h"
#include "core/provenance/sha256.h"
#include "core/session/finer_heights.h"
#include "core/session/firmness.h"
#include "core/session/large/tiled_surface.h"
#include "haptics/proxy/texture.h"
#include "haptics/record/recorded_loop.h"

namespace relievo::batch {
namespace {

/// The surfaces of a recording, each prepared once.
class Scenes {
 public:
  /// @param header  what the recording's header says, its input found
  Scenes(Project header, const RecordedLoop& loop, const RecordingPlace& place, Task task)
      : header_(std::move(header)),
        loop_(loop),
        recording_(place.file),
        package_folder_(place.package_folder),
        outside_files_(place.outside_files),
        task_(std::move(task)) {}

  const HapticSpace& at(const RecordedScene& scene) {
    std::unique_ptr<HapticSpace>& space = spaces_[scene.id];
    if (!space) space = made(scene);
    return *space;
  }

 private:
  std::unique_ptr<HapticSpace> made(const RecordedScene& scene) {
    const Surface& surface = surfaceUnder(scene);
    RegionWindow window = windowOf(surface, scene.region, scene.gain);
    window.id = scene.window_id;
    auto space = std::make_unique<HapticSpace>();
    const DetailLadder& ladder = surface.ladder;
    std::vector<float> firmness;
    if (!scene.firmness.empty()) {
      firmness = firmnessUnder(firmnessOf(scene.firmness), ladder, scene.region);
    }
    fill(*space, window, {ladder.detailOf(scene.region.level), ladder.levels()}, scene.kind,
         scene.anchor, firmness);
    if (scene.textured) fillTexture(*space, finerHeights(surface, scene.region, scene.gain));
    space->scene_id = scene.id;
    if (sceneChecksum(*space) != scene.checksum) {
      throw failure<MessageId::replayed_window_differs>(scene.window_id);
    }
    return space;
  }

  /// One map at a time is in memory: the one that was touched last.
  const Surface& surfaceUnder(const RecordedScene& scene) {
    if (!surface_ || map_ != scene.map) {
      surface_.reset();
      surface_ = std::make_unique<Surface>(surfaceOf(projectOf(scene.map), task_));
      map_ = scene.map;
    }
    if (scene.region.level.value >= surface_->ladder.levels()) {
      throw failure<MessageId::replayed_map_has_no_level>(scene.region.level.value);
    }
    return *surface_;
  }

  Project projectOf(std::uint64_t map) const {
    if (map == 0) return header_;
    const auto told = loop_.files.maps.find(map);
    std::optional<Project> project;
    if (told != loop_.files.maps.end()) project = embeddedProject(recording_, told->second);
    if (!project) {
      throw failure<MessageId::replayed_map_unknown>();
    }
    if (project->sha256 == header_.sha256) {  // Found already, wherever it is now.
      project->file = header_.file;
    } else if (package_folder_.empty() || isWebAddress(project->file)) {
      findInput(*project, recording_, {.given = {}, .outside = outside_files_}, task_);
    } else {
      const auto packed =
          packedFile(package_folder_, recording_, project->file, project->sha256, task_);
      findInput(*project, recording_, {.given = packed.string()}, task_);
    }
    return std::move(*project);
  }

  /// Read once, if it is the one that was felt.
  const FirmnessMap& firmnessOf(const std::string& sha256) {
    if (const auto read = firmness_.find(sha256); read != firmness_.end()) return read->second;
    const auto named = loop_.files.firmness.find(sha256);
    if (named == loop_.files.firmness.end()) {
      throw failure<MessageId::replayed_raster_unknown>();
    }
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::absolute(recording_, error).parent_path();
    const std::filesystem::path place = (folder / named->second).lexically_normal();
    const std::filesystem::path file =
        package_folder_.empty() ? foundInput(recording_, place, sha256, task_)
                                : packedFile(package_folder_, recording_, place, sha256, task_);
    if (sha256OfFile(file, task_) != sha256) {
      throw ChangedInputError(said<MessageId::raster_is_not_that_felt>(file.filename().string()));
    }
    return firmness_.emplace(sha256, readFirmness(file, task_)).first->second;
  }

  Project header_;
  const RecordedLoop& loop_;
  std::filesystem::path recording_;
  std::filesystem::path package_folder_;  ///< Empty: of none.
  OutsideFiles outside_files_;
  Task task_;
  std::unique_ptr<Surface> surface_;
  std::uint64_t map_ = 0;                        ///< Of surface_.
  std::map<std::string, FirmnessMap> firmness_;  ///< By SHA-256.
  std::map<std::uint64_t, std::unique_ptr<HapticSpace>> spaces_;
};

}  // namespace

std::optional<ReplayResult> replayOfWindow(
    const LogTable& log, const RecordingPlace& place,
    const std::function<void(const HapticSample&, double t_s)>& each, const Task& task) {
  const std::optional<RecordedLoop> loop = recordedLoop(log.footer);
  if (!loop) return std::nullopt;
  const HostFileArguments host_file{
      .from_image = place.file, .project = {}, .outside_files = place.outside_files};
  Scenes scenes(storedProject(host_file, place.input, task), *loop, place, task);
  return replayLoop(
      *loop, log,
      [&scenes](const RecordedScene& scene) -> const HapticSpace& { return scenes.at(scene); },
      each, task);
}

}  // namespace relievo::batch
