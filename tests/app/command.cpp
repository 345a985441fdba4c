// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/command.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace relievo::test {
namespace {

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void redirect(const std::filesystem::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(125);
}

void becomeNobody() {
  if (geteuid() != 0) return;
  constexpr unsigned kNobody = 65534;
  if (setgroups(0, nullptr) != 0 || setresgid(kNobody, kNobody, kNobody) != 0 ||
      setresuid(kNobody, kNobody, kNobody) != 0) {
    _exit(124);
  }
}

}  // namespace

CommandResult runRelievo(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment, RunAs as) {
  std::string folder = (std::filesystem::temp_directory_path() / "relievo-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder");
  const std::filesystem::path out = std::filesystem::path(folder) / "out";
  const std::filesystem::path err = std::filesystem::path(folder) / "err";
  std::vector<std::string> words{RELIEVO_BINARY_DIR "/bin/relievo"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    for (const std::string& entry : environment) {
      const std::size_t equals = entry.find('=');
      if (equals == std::string::npos) {
        unsetenv(entry.c_str());
      } else {
        setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
      }
    }
    // Opened before: nobody may not come through the folders above.
    const int program = open(argv[0], O_PATH | O_CLOEXEC);
    if (as == RunAs::nobody) becomeNobody();
    fexecve(program, argv.data(), environ);
    _exit(126);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CommandResult result{
      .exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
      .out = contentOf(out),
      .err = contentOf(err)};
  std::filesystem::remove_all(folder);
  return result;
}

}  // namespace relievo::test
