// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/verbs/verb_files.h"
#include "core/base/task.h"
#include "core/file/output_set.h"
#include "core/relief/stereo.h"

namespace relievo::batch {

/// What a verb leaves behind: a JSON object as text for `--report json`, lines for people else.
struct CommandResult {
  std::string json;
  std::vector<std::string> lines;
  int exit_code = 0;
};

/// One verb: declares its options on a parser, then runs. @throw Error
struct Verb {
  std::string name;
  std::string help;
  std::function<void(CLI::App&)> declare;
  /// Looked at before it runs; empty: it replaces no file that it reads.
  std::function<VerbFiles()> files = {};
  std::function<CommandResult(const Task&)> run;
};

// Each makes a verb whose options live as long as the verb does.
Verb infoVerb();
Verb depthmapVerb();
Verb fillVerb();
Verb convertVerb();
Verb pyramidVerb();
Verb publishVerb();
Verb prepareVerb();
Verb devicesVerb();
Verb measureVerb();
Verb suggestVerb();
Verb describeVerb();
Verb projectVerb();
/// `words`: the command line, which the log keeps.
Verb touchVerb(std::vector<std::string> words);
Verb recordVerb(std::vector<std::string> words);
Verb replayVerb();
Verb soundVerb();

/// All verbs, in the order in which --help lists them. `words`: the command line, which logs keep.
std::vector<Verb> verbs(const std::vector<std::string>& words = {});

/// Loads a surface with the engine the options name, and tells its messages on stderr.
Surface loadForVerb(const MapArguments& arguments, const Task& task);

/// 0, or 4 if a requested step could not be done.
inline int exitCodeAfter(const Surface& surface) {
  return surface.not_done.empty() ? 0 : 4;
}

Surface loadForVerb(const std::string& file, const SurfaceOptions& options,
                    const ImportOptions& import, const Task& task);

/// Where a level is much finer than the 200 samples across its region: so, in a sentence; or empty.
std::string aliasNote(const Surface& surface, const Region& region);
/// Says so on stderr where a level is much finer than the 200 samples across its region.
void warnIfAliased(const Surface& surface, const Region& region);
/// Warns where coloured glasses would show much of the picture to one eye only.
void tellRivalry(const Surface& surface, const RegionWindow& window, ReliefKind kind,
                 StereoPrint print);

/// Writes the window's samples, as members of the set, if asked to.
void writeWindowIfAsked(const RegionArguments& arguments, const Surface& surface,
                        const RegionWindow& window, OutputSet& set);

/// One line on stderr: "relievo: message".
void tell(const std::string& message);

}  // namespace relievo::batch
