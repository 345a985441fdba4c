// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/state.h"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <utility>

#include "app/cli/early_input.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/project/embedded_state.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/tiled_map.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

Provenance withInput(Provenance provenance, const MapArguments& arguments, InputFile input) {
  provenance.input = std::move(input);
  provenance.accept_incomplete = arguments.scan.accept_incomplete;
  provenance.scan = importOptions(arguments.scan).scan;
  return provenance;
}

InputFile inputOf(const MapArguments& arguments, const fs::path& out, const Task& task) {
  const fs::path folder = out.parent_path();
  return inputFile(arguments.file, folder.empty() ? fs::path(".") : folder, task);
}

}  // namespace

void addOutsideOption(CLI::App& verb, OutsideFiles& outside) {
  verb.add_option_function<std::string>(
          "--outside-files",
          [&outside](const std::string& word) {
            outside = word == "allow" ? OutsideFiles::allow : OutsideFiles::refuse;
          },
          "Files that a project, picture, log or recipe names outside of its own folder, other "
          "than "
          "those it was made from: refuse (as by itself; exit 2) or allow")
      ->check(CLI::IsMember({"allow", "refuse"}));
}

void requireOwn(const fs::path& host_file, const InputFile& named, OutsideFiles outside,
                const std::string& instead, const Task& task) {
  if (outside == OutsideFiles::allow || mayBeRead(host_file, named, task)) return;
  throw failure<MessageId::named_file_outside>(shownName(host_file), printable(named.file),
                                               instead);
}

void findInput(Project& project, const fs::path& host_file, const InputChoice& choice,
               const Task& task) {
  const bool is_given = !choice.given.empty();
  const fs::path file = is_given ? fs::path(choice.given) : foundInput(host_file, project.file);
  project.file = file.string();
  const bool asks = !is_given && choice.outside == OutsideFiles::refuse;
  // Of what differs, with leave to differ, or has no checksum, only its place can tell.
  if (asks && (choice.accept_changed || project.sha256.empty())) {
    requireOwn(host_file, {project.file, project.sha256, project.bytes}, choice.outside,
               "Give it as FILE if it is the right one.", task);
  }
  if (project.sha256.empty()) return;  // Without a checksum nobody can tell.
  const std::string sha256 = sha256OfFile(file, task);
  if (sha256 == project.sha256) return;
  const std::string address = addressOfKeptMap(file), made = host_file.filename().string();
  const std::string name = address.empty() ? file.filename().string() : address;
  if (!choice.accept_changed) {
    throw ChangedInputError(said<MessageId::input_is_not_that_file>(name, made));
  }
  tell("'" + name + "' is not the file that " + made +
       " was made from (checksum differs, E501). It was used all the same.");
  project.sha256 = sha256;  // What is drawn now comes from these bytes.
  project.bytes = fs::file_size(file);
}

Surface surfaceOf(const Project& project, const Task& task) {
  if (TiledMap::isOne(project.file)) return openTiledSurface(project.file);
  ImportOptions import;
  import.accept_incomplete = project.accept_incomplete;
  import.scan = project.scan;
  return loadForVerb(project.file, project.options, import, task);
}

Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const fs::path& out, const Task& task) {
  return provenanceOfVerb(arguments, surface, inputOf(arguments, out, task));
}

Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            InputFile input) {
  return withInput(provenanceOf(surface, surfaceOptions(arguments)), arguments, std::move(input));
}

Project projectOfVerb(const MapArguments& arguments, const Surface& surface, const Region& region,
                      double gain, const Task& task) {
  Project p;
  p.file = arguments.file;
  p.sha256 = sha256OfFile(arguments.file, task);
  p.bytes = fs::file_size(arguments.file);
  p.accept_incomplete = arguments.scan.accept_incomplete;
  p.scan = importOptions(arguments.scan).scan;
  p.options = resolved(surfaceOptions(arguments), surface);
  p.region = region;
  p.gain = gain;
  return p;
}

void addHostFileOptions(CLI::App& verb, HostFileArguments& a) {
  verb.get_option("FILE")->required(false);
  verb.add_option("--from-image", a.from_image,
                  "Draw again what this picture of relievo shows; FILE is then found by itself, or "
                  "given");
  verb.add_option("--project", a.project, "Draw what this project shows");
  verb.add_option(
      "--place", a.place,
      "With these: this bookmark of the project, with its exaggeration; --view NAME: this "
      "view, also how it is looked at; --region, --level and --gain go beyond both");
  verb.add_flag("--changed-input", a.changed_input,
                "With these: take an input whose checksum differs (else exit 5)");
  addOutsideOption(verb, a.outside_files);
}

void refuseBeside(const CLI::App& verb, const HostFileArguments& a,
                  std::initializer_list<const char*> allowed) {
  if (!a.from_image.empty() && !a.project.empty()) {
    throw failure<MessageId::image_or_project>();
  }
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_lnames().empty() ? "FILE" : option->get_lnames()[0];
    const auto is = [&](const char* other) { return name == other; };
    constexpr std::array<const char*, 8> kAlways{"FILE",          "output",       "caption",
                                                 "report",        "from-image",   "project",
                                                 "changed-input", "outside-files"};
    if (std::any_of(kAlways.begin(), kAlways.end(), is)) continue;
    if (std::any_of(allowed.begin(), allowed.end(), is)) continue;
    if (a.project.empty()) throw failure<MessageId::option_said_by_image>(name);
    throw failure<MessageId::option_said_by_project>(name);
  }
}

void requireOwnRecording(const Project& p, const HostFileArguments& host_file, const Task& task) {
  if (host_file.outside_files == OutsideFiles::allow) return;
  const std::filesystem::path from =
      host_file.project.empty() ? host_file.from_image : host_file.project;
  Project only;
  only.sha256 = p.sha256;
  only.recordings = p.recordings;
  std::erase_if(only.recordings,
                [&](const InputFile& one) { return one.file != p.figure.recording; });
  only.figure.recording = p.figure.recording;
  for (const auto& foreign : foreignFiles(from, only, task)) {
    requireOwn(from, {.file = foreign.string(), .sha256 = {}}, host_file.outside_files,
               "Give it with --recording if it is the right one.", task);
  }
}

Project storedProject(const HostFileArguments& a, const std::string& given, const Task& task) {
  const fs::path host_file = a.from_image.empty() ? a.project : a.from_image;
  auto project = embeddedProject(host_file);
  if (!project) {
    throw failure<MessageId::carrier_without_region>(host_file.filename().string());
  }
  findInput(*project, host_file,
            {.given = given, .accept_changed = a.changed_input, .outside = a.outside_files}, task);
  return std::move(*project);
}

Stored loadStored(const HostFileArguments& a, const std::string& given, const Task& task) {
  Project project = storedProject(a, given, task);
  Surface surface = surfaceOf(project, task);
  Stored stored{.surface = std::move(surface), .project = std::move(project)};
  // A region typed for one version of the file may not exist on another.
  if (stored.project.region.level.value >= stored.surface.ladder.levels()) {
    throw failure<MessageId::stored_map_has_no_level>(stored.project.file,
                                                      stored.project.region.level.value);
  }
  return stored;
}

namespace {

const NamedRegion& namedPlace(const Project& p, const char* option, const std::string& name,
                              bool as_view) {
  std::string known;
  for (const NamedRegion& place : p.places) {
    if (as_view && !place.view) continue;
    if (place.name == name) return place;
    known += (known.empty() ? "" : ", ") + ("'" + place.name + "'");
  }
  throw ArgumentError(std::string(option) + ": the project has no " +
                      (as_view ? "view" : "bookmark") + " '" + name + "'" +
                      (known.empty() ? "" : "; it has " + known) + ". Nothing was drawn.");
}

void requireLevelOf(const DetailLadder& ladder, Level level, const std::string& what) {
  if (level.value < ladder.levels()) return;
  throw ArgumentError(what + ": the map has no level " + std::to_string(level.value) +
                      ". Nothing was drawn.");
}

}  // namespace

bool showChosen(Stored& state, const HostFileArguments& host_file, const std::string& view,
                const RegionArguments& region) {
  Project& p = state.project;
  const DetailLadder& ladder = state.surface.ladder;
  if (!view.empty()) {
    setView(p, *namedPlace(p, "--view", view, true).view);
    requireLevelOf(ladder, p.region.level, "--view " + view);
    p.figure.look = p.look;
    p.figure.stereo = printed(p.stereo.mode);
    p.figure.eye_angle_deg = p.stereo.eye_angle_deg;
    p.figure.zero_plane_mm = p.stereo.zero_plane_mm;
    p.figure.swap_eyes = p.stereo.swap_eyes;
  }
  if (!host_file.place.empty()) {
    const NamedRegion& place = namedPlace(p, "--place", host_file.place, false);
    requireLevelOf(ladder, place.region.level, "--place " + host_file.place);
    const Region at = place.region;
    p.gain = place.gain;
    p.region = at;
  }
  if (!region.region.empty()) {
    p.region = chosenRegion(state.surface, region);
  } else if (region.level) {
    const Level level{*region.level};
    requireLevelOf(ladder, level, "--level");
    p.region.level = level;
  }
  if (region.gain_given) p.gain = region.gain;
  return !view.empty() || !host_file.place.empty() || !region.region.empty() || region.level ||
         region.gain_given;
}

}  // namespace relievo::batch
