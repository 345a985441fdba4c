// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "app/cli/drawing.h"
#include "app/cli/json.h"
#include "app/cli/options/eye_angle_range.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/published/published_input.h"
#include "app/cli/report_text.h"
#include "app/cli/sound_track.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "app/draw/drawing_verbs.h"
#include "core/base/failure.h"
#include "core/project/caption.h"
#include "core/project/recording.h"
#include "ui/figure/figure.h"
#include "ui/video/video.h"
#include "ui/video/video_frames.h"
#include "ui/video/video_sound.h"
#include "ui/vtk/files/picture_file.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

struct VideoArguments {
  std::string path;
  std::string recording, input, out, profile = "talk", size = "1280x720", stereo;
  LookArguments look;
  std::optional<double> eye_angle_deg;
  std::vector<std::string> without;
  VideoRequest request;
  std::optional<std::uint64_t> frame;
  bool changed_input = false, both_eyes = false;
  OutsideFiles outside_files = OutsideFiles::refuse;
};

VideoFiles filesOfVideo(const VideoArguments& a) {
  return {.video = a.out, .both_eyes = a.both_eyes && !a.frame};
}

template <class T>
T chosen(const char* option, const std::string& word, const std::optional<T>& value) {
  if (value) return *value;
  throw failure<MessageId::option_word_unknown>(option, word);
}

VideoRequest requestOf(const VideoArguments& a) {
  VideoRequest v = a.request;
  v.profile = chosen("--profile", a.profile, videoProfile(a.profile));
  const std::size_t x = a.size.find('x');
  if (x == std::string::npos) throw failure<MessageId::option_size>();
  const std::vector<double> size =
      numberList("--size", a.size.substr(0, x) + "," + a.size.substr(x + 1), 2);
  if (size[0] != std::trunc(size[0]) || size[1] != std::trunc(size[1])) {
    throw failure<MessageId::option_size>();
  }
  v.width_px = static_cast<int>(size[0]);
  v.height_px = static_cast<int>(size[1]);
  const bool grey = a.stereo.empty() && v.profile == VideoProfile::anaglyph;
  if (grey) v.stereo = StereoPrint::grey;
  if (!a.stereo.empty()) v.stereo = chosen("--stereo", a.stereo, stereoPrint(a.stereo));
  const bool eyes = v.stereo != StereoPrint::off;
  const std::string what = "a kind of --stereo, or --both-eyes";
  requireUse("--eye-angle", a.eye_angle_deg.has_value(), eyes || a.both_eyes, what);
  requireUse("--swap-eyes", v.swap_eyes, eyes || a.both_eyes, what);
  v.eye_angle_deg = a.eye_angle_deg.value_or(v.eye_angle_deg);
  if (a.frame) {
    v.sound = false;
    requirePictureName(a.out);
  }
  v.look = reliefLook(a.look, v.look);
  for (const std::string& part : a.without) {
    if (part == "plots") v.plots = false;
    if (part == "overview") v.overview = false;
    if (part == "scalebar") v.scale_bar = false;
    if (part == "sound") v.sound = false;
  }
  check(v);
  return v;
}

/// The map that a recording was made on, and where it came from.
struct Recorded {
  Surface surface;
  Provenance provenance;
};
Recorded recordedOf(Stored stored, const VideoArguments& a, const Task& task) {
  Provenance made = provenanceOf(stored.surface, stored.project.options);
  made.accept_incomplete = stored.project.accept_incomplete;
  made.scan = stored.project.scan;
  made.input = inputFile(stored.project.file, fs::absolute(a.out).parent_path(), task);
  return {.surface = std::move(stored.surface), .provenance = std::move(made)};
}

Recorded loadRecorded(const TouchRecording& recording, const VideoArguments& a, const Task& task) {
  if (recording.state.empty()) {
    throw failure<MessageId::recording_without_map>(recording.name);
  }
  return recordedOf(loadStored({.from_image = a.recording,
                                .project = {},
                                .changed_input = a.changed_input,
                                .outside_files = a.outside_files},
                               a.input, task),
                    a, task);
}

CommandResult drawOne(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request, const VideoArguments& a,
                      const std::string& state) {
  VideoFrames frames(surface, recording, request);
  if (*a.frame >= frames.times().frames) {
    throw failure<MessageId::video_frame_beyond>(frames.times().frames);
  }
  const RgbaImage image = frames.draw(*a.frame);
  const PictureText text{{"Software", std::string("relievo ") + RELIEVO_VERSION_STRING},
                         {kStateEntry, state}};
  if (pictureFormatOf(a.out) == PictureFormat::tiff) {
    writeTiff(a.out, image, kScreenDpi, text);
  } else {
    writePng(a.out, image, kScreenDpi, text);
  }
  return {.json = reportText(Json{{"file", a.out}, {"time_s", frames.times().ofFrame(*a.frame)}}),
          .lines = {a.out + ": one frame"}};
}

/// The map of a project, for its camera path alone.
Recorded loadOfProject(const VideoArguments& a, const Task& task) {
  return recordedOf(loadStored({.from_image = {},
                                .project = a.path,
                                .changed_input = a.changed_input,
                                .outside_files = a.outside_files},
                               a.input, task),
                    a, task);
}

CommandResult runVideo(const VideoArguments& a, const Task& task) {
  VideoRequest request = requestOf(a);
  std::optional<Project> project;
  if (!a.path.empty()) {
    project = readProject(a.path);
    if (project->paths.empty()) {
      throw failure<MessageId::project_without_path>(a.path);
    }
    request.path = project->paths.front();
    if (a.recording.empty()) request.overview = false;
    check(request);
  } else if (a.recording.empty()) {
    throw failure<MessageId::video_of_no_recording>();
  }
  TouchRecording recording;
  if (!a.recording.empty()) recording = readRecording(a.recording, task);
  const TouchRecording* const shown = a.recording.empty() ? nullptr : &recording;
  [[maybe_unused]] const VideoTimes times = timesOf(request, shown);  // Before maps are made.
  if (const std::string cut = whatIsCut(request, shown); !cut.empty()) tell(cut);
  const Recorded recorded =
      shown != nullptr ? loadRecorded(recording, a, task) : loadOfProject(a, task);
  const Surface& surface = recorded.surface;
  const int placed = placeUnknownWindows(recording, surface.ladder);
  if (placed > 0) {
    tell("The recording does not say where " + std::to_string(placed) +
         " windows lay; they are shown around what was touched.");
  }
  const fs::path folder = fs::absolute(a.out).parent_path();
  const InputFile log = shown != nullptr ? inputFile(a.recording, folder, task) : InputFile{};
  const DisplayGuard display;
  const FigureSession session;
  if (a.frame) {
    return drawOne(surface, shown, request, a, videoState(recorded.provenance, request, log));
  }
  const auto state_of = [&](const VideoRequest& one) {
    return videoState(recorded.provenance, one, log);
  };
  const VideoSound sound = soundOf(request, shown, soundTrackOf);
  if (sound.missing) {
    tell("The video has no sound. " + std::string(sound.missing->what()));
  }
  VideoFiles files = filesOfVideo(a);
  files.sound = sound.track ? &*sound.track : nullptr;
  const VideoFacts facts = writeVideo(surface, shown, request, state_of, files, task);
  Json json;
  json["file"] = a.out;
  json["profile"] = name(request.profile);
  json["pixels"] = {request.width_px, request.height_px};
  json["sound"] = sound.track.has_value();
  json["frames"] = facts.frames;
  json["seconds"] = facts.seconds;
  json["bytes"] = facts.bytes;
  json["drawing_s"] = facts.drawing_s;
  json["packing_s"] = facts.packing_s;
  return {
      .json = reportText(json),
      .lines = {a.out + ": " + std::to_string(facts.frames) + " frames, " +
                shortNumber(facts.seconds) + " s, " + std::to_string(facts.bytes / 1024) + " kB"}};
}

VerbFiles filesOf(const VideoArguments& a) {
  VerbFiles files;
  if (!a.recording.empty()) {
    files.readsStateOf(a.recording, a.input);
    files.reads(a.path, "the project that is read");  // For its camera path alone.
  } else if (!a.path.empty()) {
    files.readsStateOf({.from_image = {}, .project = a.path}, a.input);
  }
  for (const auto& out : namesOf(filesOfVideo(a))) files.writes(out);
  return files;
}

void declareVideo(CLI::App& verb, VideoArguments& a) {
  verb.add_option("recording", a.recording, "LOG.csv or LOG.h5 of the window, touch or record");
  verb.add_option("--path", a.path, "PROJECT.json whose key views the camera passes");
  verb.add_option("-o,--output", a.out, "VIDEO.mp4; for images a folder")->required();
  mayBeWebAddress(verb.add_option(
      "--input", a.input,
      "The scan or map, or the address of a published map, if it is not where the log says"));
  verb.add_flag("--changed-input", a.changed_input, "Use it although its checksum differs");
  addOutsideOption(verb, a.outside_files);
  verb.add_option("--profile", a.profile,
                  "talk: plays everywhere; archive: without loss; anaglyph: full colour "
                  "resolution; images: PNG files, without ffmpeg");
  verb.add_option("--size", a.size, "WIDTHxHEIGHT in pixels, even; 1280x720");
  takes(verb.add_option("--fps", a.request.fps, "Frames per second; 30"), {.low = 1, .high = 120});
  takes(verb.add_option("--speed", a.request.speed,
                        "1 as it was; 0.25 four times slower, with each sound at its time"),
        {.low = 0.01, .high = 100});
  takes(verb.add_option("--from", a.request.from_s, "Seconds since the recording's start"),
        {.low = 0, .high = 1e6, .unit = "s"});
  takes(verb.add_option("--to", a.request.to_s, "Likewise"), {.low = 0, .high = 1e6, .unit = "s"});
  verb.add_option("--without", a.without, "plots, overview, scalebar, sound")
      ->delimiter(',')
      ->check(CLI::IsMember({"plots", "overview", "scalebar", "sound"}));
  verb.add_option("--stereo", a.stereo,
                  "off, grey, half, dubois, sidebyside, overunder or interlaced; anaglyph: grey");
  takes(verb.add_option("--eye-angle", a.eye_angle_deg, "Degrees between the eyes; 4"), kEyeAngles);
  verb.add_flag("--both-eyes", a.both_eyes,
                "Also write each eye's video, NAME.left.mp4 and NAME.right.mp4");
  verb.add_flag("--swap-eyes", a.request.swap_eyes, "Red for the right eye");
  verb.add_option("--relief", a.look.relief, "How heights are painted, as for figure");
  verb.add_option("--colours", a.look.colours, listOf(kColourMapNames));
  takesList(verb.add_option("--light", a.look.light, "AZIMUTH,ELEVATION in degrees; 315,45"), 2,
            {.low = -360, .high = 360, .unit = "degrees"});
  takes(verb.add_option("--frame", a.frame,
                        "Only this frame, counted from 0, as a picture: .png or .tif"),
        {.low = 0, .high = 1e8});
}

}  // namespace

Verb videoVerb() {
  auto arguments = std::make_shared<VideoArguments>();
  return {.name = "video",
          .help = helpOfDrawingVerb("video"),
          .declare = [arguments](CLI::App& verb) { declareVideo(verb, *arguments); },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runVideo(*arguments, task); }};
}

}  // namespace relievo::batch
