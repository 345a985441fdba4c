// SPDX-License-Identifier: BSD-3-Clause
// Writes the manual pages and the completions of shells into a folder, as they are installed.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "app/manual/manual.h"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: relievo_manual FOLDER\n", stderr);
    return 1;
  }
  try {
    using namespace relievo::manual;
    const std::filesystem::path share(argv[1]);
    const CommandLine line = commandLine();
    for (const auto& [name, text] : pages(line)) write(share / "man/man1" / name, text);
    write(share / "bash-completion/completions/relievo", bashCompletion(line));
    write(share / "zsh/vendor-completions/_relievo", zshCompletion(line));
    write(share / "fish/vendor_completions.d/relievo.fish", fishCompletion(line));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "relievo_manual: %s\n", error.what());
    return 3;
  }
}
