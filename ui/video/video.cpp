// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/video.h"

#include <chrono>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/name_text.h"
#include "ui/video/video_file.h"
#include "ui/video/video_frames.h"

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

VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request, const std::string& state, const fs::path& file,
                      const Task& task) {
  VideoFrames frames(surface, recording, request, task);
  OutputSet set;
  fs::path beside = file;
  beside += ".json";
  writeTextFile(set.file(beside), state + "\n");  // While there is room for it.
  const std::unique_ptr<VideoFile> out = openVideo(set.file(file), {.profile = request.profile,
                                                                    .width_px = request.width_px,
                                                                    .height_px = request.height_px,
                                                                    .fps = request.fps,
                                                                    .state = state,
                                                                    .title = file.stem().string()});
  VideoFacts facts;
  const std::uint64_t count = frames.times().frames;
  try {
    for (std::uint64_t i = 0; i < count; ++i) {
      task.check();
      task.report("Video", static_cast<double>(i) / static_cast<double>(count));
      const auto start = std::chrono::steady_clock::now();
      const RgbaImage& frame = frames.draw(i);
      facts.drawing_s += secondsSince(start);
      const auto drawn = std::chrono::steady_clock::now();
      out->add(frame, task);
      facts.packing_s += secondsSince(drawn);
    }
    const auto last = std::chrono::steady_clock::now();
    out->finish(task);
    facts.packing_s += secondsSince(last);
  } catch (const WriteError&) {
    if (out->isPartKept()) set.commit();
    throw;
  }
  set.commit();
  facts.frames = out->frames();
  facts.seconds = static_cast<double>(facts.frames) / request.fps;
  facts.bytes = sizeOf(file);
  return facts;
}

}  // namespace relievo
