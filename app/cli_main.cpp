// SPDX-License-Identifier: BSD-3-Clause
// relievo-cli: the command line. `relievo` goes on as it, and it as relievo-draw or relievo-window
// where something is drawn, so that it loads no libraries of graphics (docs/adr/0151).
#include <csignal>
#include <iostream>

#include "app/cli/batch.h"
#include "app/cli/other_program.h"
#include "app/exhibit/supervisor.h"
#include "app/options.h"
#include "core/base/error.h"
#include "core/io/worker/reader_guard.h"
#include "core/provenance/program.h"

namespace {

constexpr int kUsage = 1, kCannotRead = 2;
constexpr int kNoGraphics = 7;

int fail(int exit_code, const std::string& why) {
  std::cerr << "relievo: " << why << '\n';
  return exit_code;
}

/// A verb, misspelt or not, is misuse behind options, too, and never opens a window; a word behind
/// "--" is a file.
std::string unknownWord(const relievo::WindowOptions& options) {
  for (const std::string& word : options.files) {
    if (options.only_files) break;
    if (std::string unknown = relievo::unknownVerb(word); !unknown.empty()) return unknown;
  }
  return {};
}

/// Of the program that draws, which has them all; its own where it is alone.
int listLibraries(char** argv) {
  try {
    relievo::goOnAs(relievo::Program::draw, argv);
  } catch (const relievo::GraphicsError&) {
    std::cout << relievo::versionText();
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  relievo::forbidReaders();
  // A file that may not grow is met like a full disk: what is written is completed.
  std::signal(SIGXFSZ, SIG_IGN);
  if (argc > 1 && relievo::isVerb(argv[1])) return relievo::runBatch(argc, argv);
  if (const std::string unknown = argc > 1 ? relievo::unknownVerb(argv[1]) : ""; !unknown.empty()) {
    return fail(kUsage, unknown);
  }
  try {
    const relievo::WindowOptions options = relievo::parseWindowOptions({argv + 1, argv + argc});
    if (const std::string unknown = unknownWord(options); !unknown.empty()) {
      return fail(kUsage, unknown);
    }
    if (options.help || options.version) {
      std::cout << (options.help ? relievo::windowHelp() + '\n' + relievo::verbHelp()
                                 : relievo::versionLines());
      return 0;
    }
    if (options.libraries) return listLibraries(argv);
    if (!options.exhibit.empty()) {
      return relievo::runExhibit(options.exhibit, {argv + 1, argv + argc});
    }
    relievo::goOnAs(relievo::Program::window, argv);
  } catch (const relievo::ArgumentError& error) {
    return fail(kUsage, error.what());
  } catch (const relievo::FileError& error) {
    return fail(kCannotRead, error.what());
  } catch (const relievo::Error& error) {
    return fail(kNoGraphics, error.what());
  }
}
