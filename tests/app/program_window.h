// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace relievo::test {

/// The program itself, started as people start it, with its window on this screen: keys go in as X
/// events, pictures come from the screen. One thread.
class ProgramWindow {
 public:
  /// Environment and folder are the test's own. @throw std::runtime_error  no screen, no process
  explicit ProgramWindow(const std::vector<std::string>& arguments,
                         const std::string& program = RELIEVO_BINARY_DIR "/bin/relievo");
  ~ProgramWindow();  ///< Ends it by force if it still runs.
  ProgramWindow(const ProgramWindow&) = delete;
  ProgramWindow& operator=(const ProgramWindow&) = delete;

  bool runs();
  int process() const;   ///< Its number.
  int exitCode() const;  ///< Once it does not run; 128 + signal if it was killed.
  std::string title();   ///< Of its main window; empty: it has none yet.
  bool hasIcon();        ///< Does its main window have a picture for task bars?
  /// A press and release, "F5" or "r", into the main window.
  void key(const std::string& name, bool control = false, bool alt = false);
  /// What the screen shows, as PNG.
  void picture(const std::string& file);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waits until it holds, generously: what happens is tested, not how fast.
bool eventually(const std::function<bool()>& holds);

}  // namespace relievo::test
