// SPDX-License-Identifier: BSD-3-Clause
#pragma once

struct _XDisplay;  // NOLINT(bugprone-reserved-identifier): Xlib's Display, without its macros.

namespace relievo {

/// A connection to the X server, if there is one. While it is open, a server that resets when its
/// last client leaves (Xvfb does) keeps running. A server in the middle of that is waited for.
class DisplayConnection {
 public:
  DisplayConnection();
  ~DisplayConnection();
  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection& operator=(const DisplayConnection&) = delete;
  bool isOpen() const { return display_ != nullptr; }

 private:
  _XDisplay* display_;
};

}  // namespace relievo
