// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QtPlugin>

#include "plugins/api/host.h"

namespace relievo {

/// A module that the window loads at its start: attached once, detached before the program ends.
/// What throws anything in attach() or restoreState() is left out and named; the program goes on.
/// All calls: GUI thread.
class Plugin {
 public:
  virtual ~Plugin() = default;
  virtual void attach(Host& host) = 0;
  /// Follows every attach(), also one that threw. All its threads are joined on return, and it
  /// hears no signal of the host any more.
  virtual void detach() noexcept = 0;
  /// What is kept for the next start; asked before detach().
  virtual QByteArray saveState() const { return {}; }
  /// What saveState() gave once, of this plugin or of another version of it; after attach().
  virtual void restoreState(const QByteArray& /*state*/) {}
};

}  // namespace relievo

/// A plugin and the program understand each other if this version is the same in both. It is raised
/// with whatever changes in one of the installed headers; a test holds their checksum to it.
#define RELIEVO_PLUGIN_VERSION "2"
#define RELIEVO_PLUGIN_IID "org.relievo.Plugin/" RELIEVO_PLUGIN_VERSION
Q_DECLARE_INTERFACE(relievo::Plugin, RELIEVO_PLUGIN_IID)
