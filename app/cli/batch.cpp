// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/batch.h"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <numeric>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/cli/drawing.h"
#include "app/cli/library_versions.h"
#include "app/cli/options/map_option_use.h"
#include "app/cli/options/number_option.h"
#include "app/cli/other_program.h"
#include "app/cli/processes.h"
#include "app/cli/refusal_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "app/cli/verbs/declare_verbs.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/message/catalogue.h"
#include "core/provenance/name_text.h"
#include "core/provenance/program.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/load.h"

namespace relievo {
namespace batch {

namespace {

/// Without its options where this program does not draw; it is the other program then that runs it.
Verb drawingVerb(std::string_view name) {
  if (drawing() != nullptr) {
    for (Verb& verb : drawing()->verbs()) {
      if (verb.name == name) return std::move(verb);
    }
  }
  return {.name = std::string(name),
          .help = helpOfDrawingVerb(name),
          .declare = [](CLI::App&) {},
          .run = [](const Task&) -> CommandResult { throw NeedsDrawing{}; }};
}

}  // namespace

std::vector<Verb> verbs(const std::vector<std::string>& words) {
  return {infoVerb(),           prepareVerb(),         depthmapVerb(),
          fillVerb(),           pyramidVerb(),         convertVerb(),
          publishVerb(),        drawingVerb("render"), drawingVerb("figure"),
          measureVerb(),        suggestVerb(),         describeVerb(),
          projectVerb(),        devicesVerb(),         touchVerb(words),
          recordVerb(words),    replayVerb(),          soundVerb(),
          drawingVerb("video"), exhibitVerb()};
}

namespace {

int exitCodeOf(const std::exception& error) {
  if (dynamic_cast<const ArgumentError*>(&error) != nullptr) return 1;
  if (dynamic_cast<const ChangedInputError*>(&error) != nullptr) return 5;
  if (dynamic_cast<const FileError*>(&error) != nullptr) return 2;
  if (dynamic_cast<const WriteError*>(&error) != nullptr) return 3;
  if (dynamic_cast<const DeviceError*>(&error) != nullptr) return 6;
  if (dynamic_cast<const GraphicsError*>(&error) != nullptr) return 7;
  if (dynamic_cast<const Cancelled*>(&error) != nullptr) return 130;
  return 2;
}

/// As nohup leaves it; a signal that is blocked would be kept for us all the same.
bool isIgnored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

/// Turns Ctrl+C, termination and a closed terminal into a stop request; signals are blocked
/// everywhere else.
class InterruptWatch {
 public:
  InterruptWatch() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    if (!isIgnored(SIGHUP)) sigaddset(&signals_, SIGHUP);  // The terminal was closed.
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    thread_ = std::jthread([this](const std::stop_token& ended) {
      for (;;) {
        const int came = sigwaitinfo(&signals_, nullptr);
        if (ended.stop_requested()) return;
        if (came > 0) interrupt_.request_stop();
      }
    });
  }
  ~InterruptWatch() { end(); }
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  std::stop_token token() const { return interrupt_.get_token(); }
  /// Signals are as they were before: a program that this one goes on as inherits what is blocked.
  void handBack() {
    end();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  /// The thread waits for a signal and for nothing else: a time limit would be added to each verb.
  void end() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    pthread_kill(thread_.native_handle(), SIGTERM);
    thread_.join();
  }

  sigset_t signals_{}, before_{};
  std::stop_source interrupt_;
  std::jthread thread_;
};

int report(const CommandResult& outcome, const std::string& format) {
  if (format == "json") {
    std::cout << outcome.json << '\n';
  } else {
    // Names may hold line ends and bytes that steer a terminal.
    for (const std::string& line : outcome.lines) std::cout << escapedName(line) << '\n';
  }
  std::cout.flush();
  if (!std::cout) {
    tell("The report could not be written to standard output.");
    return 3;
  }
  return outcome.exit_code;
}

}  // namespace

void declareVerbs(CLI::App& app, std::vector<Verb>& verbs, std::string& format) {
  for (Verb& verb : verbs) {
    CLI::App* sub = app.add_subcommand(verb.name, verb.help);
    verb.declare(*sub);
    sub->add_option("--report", format, "json: one object on standard output")
        ->check(CLI::IsMember({"json", "text"}));
    refuseEmptyTexts(*sub);
  }
}

void tell(const std::string& message) {
  std::cerr << "relievo: " << escapedName(message) << '\n';
}

Surface loadForVerb(const MapArguments& arguments, const Task& task) {
  Surface surface =
      loadForVerb(arguments.file, surfaceOptions(arguments), importOptions(arguments.scan), task);
  tellUnusedMapOptions(arguments, surface);
  return surface;
}

Surface loadForVerb(const std::string& file, const SurfaceOptions& options,
                    const ImportOptions& import, const Task& task) {
  Surface surface;
  if (options.engine != "depthbuffer") {
    surface = loadSurface(file, options, rasterize, import, task);
  } else if (drawing() != nullptr) {
    surface = loadSurface(file, options, drawing()->depth_buffer, import, task);
  } else {
    throw NeedsDrawing{};
  }
  requireRasterUse(options, surface);
  for (const Message& message : surface.messages) tell(englishText(message));
  for (const Message& message : surface.not_done) tell(englishText(message));
  return surface;
}

std::string aliasNote(const Surface& surface, const Region& region) {
  const Level fitting = defaultLevel(surface.ladder, region.side_mm);
  if (region.level >= fitting) return {};
  return "Level " + std::to_string(region.level.value) +
         " is finer than 200 samples across this region can carry; fine structure aliases. Level " +
         std::to_string(fitting.value) + " fits, or choose a smaller region.";
}

void warnIfAliased(const Surface& surface, const Region& region) {
  const std::string note = aliasNote(surface, region);
  if (!note.empty()) tell(note);
}

void tellRivalry(const Surface& surface, const RegionWindow& window, ReliefKind kind,
                 StereoPrint print) {
  const std::string words = rivalryWords(rivalShare(surface, window, kind, print));
  if (!words.empty()) tell(words);
}

void writeWindowIfAsked(const RegionArguments& arguments, const Surface& surface,
                        const RegionWindow& window, OutputSet& set) {
  if (arguments.window_out.empty()) return;
  // Heights as they are under the hand: 0 outside, not NaN.
  writeMap(set.file(arguments.window_out), windowMap(window),
           {.view_from_file = surface.view_from_file, .outside_as_nan = false});
}

}  // namespace batch

namespace {

constexpr const char* kOutOfMemory =
    "There is not enough memory for this: the computer, or a limit that was set (ulimit -v), gives "
    "no more. The work was given up. Choose larger cells or a smaller picture, or raise the limit.";

/// What a log can be searched for, then the sentence, unless that says it already.
std::string withCode(const std::exception& error) {
  // Threads need room for their stacks; without it they say "try again".
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  const bool no_thread =
      system != nullptr && system->code() == std::errc::resource_unavailable_try_again;
  if (no_thread || dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return kOutOfMemory;
  const auto* known = dynamic_cast<const Error*>(&error);
  std::string sentence = error.what();
  if (known == nullptr || sentence.find(known->code) != std::string::npos) return sentence;
  return known->code + ": " + sentence;
}

/// Says why it came to nothing. Of several processes all end with the reason of one of them.
/// @return  exit code
int end(int exit_code, std::string sentence) {
  Exchange& all = batch::processes();
  if (const std::optional<Exchange::Stopped>& stopped = all.stopped()) {
    exit_code = stopped->exit_code;
    sentence = stopped->sentence;
    if (stopped->rank > 0) {
      sentence = englishText(
          said<MessageId::process_stopped>(NumberArgument{.value = stopped->rank + 1.0},
                                           NumberArgument{.value = 1.0 * all.ranks()}, sentence));
    }
  }
  batch::tell(sentence);
  return exit_code;
}

int refuse(int exit_code, const std::string& sentence) {
  batch::processes().stop(exit_code, sentence);
  return end(exit_code, sentence);
}

int refuse(const std::exception& error) {
  if (dynamic_cast<const OtherProcessStopped*>(&error) != nullptr) return end(1, error.what());
  return refuse(batch::exitCodeOf(error), withCode(error));
}

}  // namespace

namespace {

/// What the parser refuses, and where to look.
std::string sentenceOf(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const std::string verb = chosen.empty() ? "" : " " + chosen.front()->get_name();
  return batch::refusalText(error.what()) + " 'relievo" + verb + " --help' says what there is.";
}

/// Letters that are put in, taken out or changed to make one word of the other (Levenshtein).
std::size_t changesBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = before + (a[i - 1] == b[j - 1] ? 0 : 1);
      before = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

bool isVerb(std::string_view word) {
  for (const batch::Verb& verb : batch::verbs()) {
    if (verb.name == word) return true;
  }
  return false;
}

std::string unknownVerb(const std::string& word) {
  std::error_code unknown;
  const bool like_a_file = word.empty() || word.front() == '-' ||
                           word.find_first_of("./") != std::string::npos ||
                           std::filesystem::exists(word, unknown);
  if (like_a_file) return {};
  if (isVerb(word)) {
    return "The verb '" + word + "' stands before all options. Nothing was done. 'relievo " + word +
           " --help' says what there is.";
  }
  std::string nearest;
  std::size_t least = 3;  // More changes than two make another word.
  for (const batch::Verb& verb : batch::verbs()) {
    const std::size_t changes = changesBetween(word, verb.name);
    if (changes >= least) continue;
    least = changes;
    nearest = verb.name;
  }
  return "'" + word + "' is neither a verb nor a file that is there. Nothing was done. " +
         (nearest.empty() ? "" : "Did you mean 'relievo " + nearest + "'? ") +
         "'relievo --help' lists the verbs.";
}

std::string verbHelp() {
  constexpr std::size_t kColumn = 10;
  std::string text = "Verbs:\n";
  for (const batch::Verb& verb : batch::verbs()) {
    text += "  " + verb.name + std::string(kColumn - verb.name.size(), ' ') + verb.help + '\n';
  }
  return text +
         "Exit codes: 0 done, 1 usage, 2 cannot read, 3 cannot write, 4 not all done,\n"
         "            5 not as before, 6 device, 7 no graphics, 130 interrupted\n";
}

namespace {

/// @throw GraphicsError  the program that draws is not there
int runOrGoOn(const batch::Verb& verb, const std::string& format, char** argv) {
  batch::InterruptWatch interrupt;
  const Task task{.stop = interrupt.token(), .progress = {}};
  if (verb.files) check(verb.files());
  try {
    return batch::report(verb.run(task), format);
  } catch (const batch::NeedsDrawing&) {
    task.check();
    interrupt.handBack();
  }
  goOnAs(Program::draw, argv);
}

}  // namespace

std::string versionText() {
  std::string text = versionLines();
  for (const LibraryVersion& one : batch::libraryVersions()) {
    text += one.name + ' ' + one.version + '\n';
  }
  return text;
}

int runBatch(int argc, char** argv) {
  try {
    // Its options are known to the program that draws alone.
    if (batch::drawing() == nullptr && argc > 1 && batch::isDrawingVerb(argv[1])) {
      goOnAs(Program::draw, argv);
    }
  } catch (const Error& error) {
    batch::tell(withCode(error));
    return batch::exitCodeOf(error);
  }
  CLI::App app("relievo: feel and see scanned heritage at every scale", "relievo");
  app.require_subcommand(1);
  std::vector<batch::Verb> verbs = batch::verbs({argv + 1, argv + argc});
  std::string format = "text";
  batch::declareVerbs(app, verbs, format);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11 has its own numbers; ours are 0 for help and 1 for every misuse.
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse(1, sentenceOf(error, app));
  } catch (const Error& error) {
    return refuse(error);
  }
  try {
    for (const batch::Verb& verb : verbs) {
      if (app.got_subcommand(verb.name)) return runOrGoOn(verb, format, argv);
    }
  } catch (const std::exception& error) {
    return refuse(error);
  }
  return 1;
}

}  // namespace relievo
