// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/cli/json.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/project/recording.h"
#include "core/provenance/program.h"
#include "core/provenance/sha256.h"
#include "haptics/sound/recorded_sound.h"
#include "haptics/sound/wav_file.h"

namespace relievo::batch {
namespace {

using sound::RecordedSound;

struct SoundArguments {
  std::string log, out, heights;
  sound::SoundRequest request;
};

constexpr std::array<const char*, sound::kEarcons> kEarconNames{
    "contact", "edge", "not_measured", "finer", "coarser", "done", "problem", "corner"};

bool isWavName(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".wav";
}

/// Where the sound came from, as a line inside the file.
Json stateOf(const SoundArguments& a, const RecordedSound& of, const Task& task) {
  return {{"program", {{"version", programVersion()}, {"commit", programCommit()}}},
          {"recording",
           {{"file", std::filesystem::path(a.log).filename().string()},
            {"sha256", sha256OfFile(a.log, task)}}},
          {"sound",
           {{"from_s", of.fromS()},
            {"seconds", of.seconds()},
            {"speed", a.request.speed},
            {"heights_mm", {of.heights().low_mm, of.heights().high_mm}},
            {"tone_for_s", a.request.synth.tone_for_s},
            {"ceiling", a.request.synth.ceiling}}}};
}

void requireRoom(const RecordedSound& of, const std::string& comment) {
  const std::uint64_t most = sound::mostWavFrames(comment);
  if (of.frames() <= most) return;
  const auto hours = [](std::uint64_t frames) {
    return NumberArgument{.value = static_cast<double>(frames) / sound::kSampleRateHz / 3600,
                          .digits = 1,
                          .form = NumberArgument::Form::trimmed};
  };
  throw failure<MessageId::sound_too_long>(hours(most), hours(of.frames()));
}

CommandResult runSound(const SoundArguments& a, const Task& task) {
  if (!isWavName(a.out)) throw failure<MessageId::sound_is_no_wav>(std::filesystem::path(a.out));
  sound::SoundRequest request = a.request;
  if (!a.heights.empty()) {
    const std::vector<double> heights = numberList("--heights", a.heights, 2);
    request.heights = sound::ToneHeights{heights[0], heights[1]};
  }
  const TouchRecording recording = readRecording(a.log, task);
  const RecordedSound of(recording, request);
  Json json = stateOf(a, of, task);
  const std::string comment = reportText(json);
  requireRoom(of, comment);
  sound::WavFile file(a.out, of.frames(), comment);
  const RecordedSound::Summary summary =
      of.render([&](std::span<const sound::Frame> frames) { file.write(frames); }, task);
  file.commit();
  Json struck;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < kEarconNames.size(); ++i) {
    struck[kEarconNames[i]] = summary.struck[i];
    count += summary.struck[i];
  }
  json["output"] = a.out;
  json["sample_rate_hz"] = sound::kSampleRateHz;
  json["heights_given"] = request.heights.has_value();
  json["heard"] = struck;
  json["peak"] = summary.peak;
  CommandResult outcome;
  outcome.json = reportText(json);
  std::string heard;
  for (std::size_t i = 0; i < kEarconNames.size(); ++i) {
    if (summary.struck[i] == 0) continue;
    heard += (heard.empty() ? "" : ", ") + std::string(kEarconNames[i]) + " " +
             std::to_string(summary.struck[i]);
  }
  outcome.lines.push_back(a.out + ": " + Json(std::round(1000 * of.seconds()) / 1000).dump() +
                          " s of sound" + (heard.empty() ? "" : "; " + heard));
  return outcome;
}

}  // namespace

Verb soundVerb() {
  auto arguments = std::make_shared<SoundArguments>();
  const auto declare = [arguments](CLI::App& verb) {
    SoundArguments& a = *arguments;
    verb.add_option("log", a.log, "LOG.csv or LOG.h5, of touch, record or the window")->required();
    verb.add_option("-o,--output", a.out, "TOUCH.wav: 48 kHz, two channels, 16 bits")->required();
    takes(verb.add_option("--from", a.request.from_s, "Seconds since the recording's start"),
          {.low = 0, .high = 1e6, .unit = "s"});
    takes(verb.add_option("--to", a.request.to_s, "Likewise"),
          {.low = 0, .high = 1e6, .unit = "s"});
    takes(verb.add_option(
              "--speed", a.request.speed,
              "1 as it was; 0.25 four times slower, each sound at its time and no deeper"),
          {.low = 0.01, .high = 100});
    takesList(verb.add_option("--heights", a.heights,
                              "LOW,HIGH in mm, from the tone's lowest to its highest pitch; those "
                              "that were touched"),
              2, {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
    takes(verb.add_option("--tone-for", a.request.synth.tone_for_s,
                          "How long the tone of heights is heard, from the first contact on; 120"),
          {.low = 0, .high = 1e6, .unit = "s"});
    takes(verb.add_option("--ceiling", a.request.synth.ceiling, "The largest sample, of 1; 0.9"),
          {.low = 0, .high = 1});
  };
  return {.name = "sound",
          .help = "The sound of a recorded touch: clicks, rustling and a tone of heights, as WAV",
          .declare = declare,
          .files =
              [arguments] {
                VerbFiles files;
                files.reads(arguments->log, "the recording that is read");
                files.writes(arguments->out);
                return files;
              },
          .run = [arguments](const Task& task) { return runSound(*arguments, task); }};
}

}  // namespace relievo::batch
