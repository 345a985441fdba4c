// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/video.h"

#include <array>
#include <chrono>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/name_text.h"
#include "ui/video/video_file.h"
#include "ui/video/video_frames.h"
#include "ui/video/video_sound.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

QString word(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QJsonObject jsonOf(const VideoRequest& v) {
  QJsonObject json{{"profile", word(name(v.profile))},
                   {"pixels", QJsonArray{v.width_px, v.height_px}},
                   {"fps", v.fps},
                   {"speed", v.speed},
                   {"plots", v.plots},
                   {"overview", v.overview},
                   {"scale_bar", v.scale_bar},
                   {"relief", word(name(v.look.kind))},
                   {"colours", word(name(v.look.colours))},
                   {"light_deg", QJsonArray{v.look.light.azimuth_deg, v.look.light.elevation_deg}},
                   {"stereo", word(name(v.stereo))},
                   {"eye_angle_deg", v.eye_angle_deg},
                   {"swap_eyes", v.swap_eyes}};
  if (v.sound) json["sound"] = word(soundCodec(v.profile));
  if (v.eye != FigureEye::both) json["eye"] = word(name(v.eye));
  if (v.from_s) json["from_s"] = *v.from_s;
  if (v.to_s) json["to_s"] = *v.to_s;
  if (!v.path) return json;
  QJsonArray keys;
  for (const KeyView& key : v.path->keys) {
    const QByteArray view = QByteArray::fromStdString(toText(key.view));
    keys.append(QJsonObject{{"t_s", key.t_s}, {"view", QString::fromUtf8(view)}});
  }
  json["path"] = QJsonObject{{"name", QString::fromStdString(v.path->name)}, {"keys", keys}};
  return json;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::uint64_t sizeOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_directory(file, error)) return fs::file_size(file, error);
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(file, error)) bytes += entry.file_size(error);
  return bytes;
}

/// Adds its life to a sum of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += secondsSince(start_); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

constexpr std::array<FigureEye, 2> kEyes{FigureEye::left, FigureEye::right};

/// A video that is being written, and which eye's pictures it has.
struct Packed {
  FigureEye eye;
  std::unique_ptr<VideoFile> file;
};

Packed begin(OutputSet& set, const VideoRequest& request, const std::string& state,
             const fs::path& file, const std::optional<SoundSpool>& sound) {
  fs::path beside = file;
  beside += ".json";
  writeTextFile(set.file(beside), state + "\n");  // While there is room for it.
  return {.eye = request.eye,
          .file = openVideo(set.file(file), {.profile = request.profile,
                                             .width_px = request.width_px,
                                             .height_px = request.height_px,
                                             .fps = request.fps,
                                             .state = state,
                                             .title = file.stem().string(),
                                             .sound = sound ? sound->path() : fs::path(),
                                             .sound_rate_hz = sound ? sound->rateHz() : 0})};
}

/// Earlier files stay whole where the disk is full.
template <class Work>
void keepingWhole(OutputSet& set, const VideoFile& file, const Work& work) {
  try {
    work();
  } catch (const WriteError&) {
    if (file.isPartKept()) set.commit();
    throw;
  }
}

}  // namespace

std::string videoState(const Provenance& provenance, const VideoRequest& request,
                       const InputFile& recording) {
  Provenance made = provenance;
  QJsonObject figure{{"video", jsonOf(request)}};
  if (!recording.file.empty()) {
    figure["recording"] = QJsonObject{{"file", QString::fromStdString(textOfName(recording.file))},
                                      {"sha256", QString::fromStdString(recording.sha256)}};
  }
  made.figure = QJsonDocument(figure).toJson(QJsonDocument::Compact).toStdString();
  return toJson(made, -1);
}

std::vector<fs::path> namesOf(const VideoFiles& files) {
  std::vector<fs::path> names;
  if (files.both_eyes) {
    const std::string ending = files.video.extension().string();
    for (const FigureEye eye : kEyes) names.push_back(eyeFile(files.video, eye, ending));
  }
  names.push_back(files.video);
  return names;
}

VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request, const std::string& state, const fs::path& file,
                      const Task& task) {
  return writeVideo(
      surface, recording, request, [&state](const VideoRequest&) { return state; },
      VideoFiles{.video = file}, task);
}

VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request,
                      const std::function<std::string(const VideoRequest&)>& state,
                      const VideoFiles& files, const Task& task) {
  VideoFrames frames(surface, recording, request, task);
  if (files.both_eyes) frames.keepEyes();
  const std::uint64_t count = frames.times().frames;
  std::optional<SoundSpool> sound;
  if (files.sound != nullptr && request.profile != VideoProfile::images) {
    sound.emplace(*files.sound, static_cast<double>(count) / request.fps, files.video, task);
  }
  OutputSet set;
  std::vector<Packed> videos;
  for (const fs::path& name : namesOf(files)) {
    VideoRequest one = request;
    one.sound = sound.has_value();
    if (videos.size() + 1 < namesOf(files).size()) one.eye = kEyes.at(videos.size());
    videos.push_back(begin(set, one, state(one), name, sound));
  }
  VideoFacts facts;
  const auto timed = [](double& sum, const auto& work) -> decltype(auto) {
    const Stopwatch watch(sum);
    return work();
  };
  for (std::uint64_t i = 0; i < count; ++i) {
    task.check();
    task.report("Video", static_cast<double>(i) / static_cast<double>(count));
    const RgbaImage& whole =
        timed(facts.drawing_s, [&]() -> const RgbaImage& { return frames.draw(i); });
    for (Packed& video : videos) {
      const RgbaImage& frame = video.eye == FigureEye::both ? whole : frames.ofEye(video.eye);
      timed(facts.packing_s,
            [&] { keepingWhole(set, *video.file, [&] { video.file->add(frame, task); }); });
    }
  }
  for (Packed& video : videos) {
    timed(facts.packing_s,
          [&] { keepingWhole(set, *video.file, [&] { video.file->finish(task); }); });
  }
  set.commit();
  facts.frames = videos.back().file->frames();
  facts.seconds = static_cast<double>(facts.frames) / request.fps;
  for (const fs::path& name : namesOf(files)) facts.bytes += sizeOf(name);
  return facts;
}

}  // namespace relievo
