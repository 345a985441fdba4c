// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QWidget>

#include "ui/window/command_table.h"
#include "ui/window/window_messages.h"
#include "ui/work/document.h"
#include "ui/work/settings.h"

namespace relievo {

/// What every controller works with.
struct ControllerParts {
  Document& document;
  Settings& settings;
  CommandTable& commands;
  WindowMessages& messages;
  QWidget& window;  ///< Dialogs stand before it.
};

/// Owns one concern of the window: what its commands do, and what it has to remember for them. What
/// it needs of others it is given, or asks for by a signal; it does not know the window. [GUI
/// thread]
class Controller : public QObject {
 protected:
  explicit Controller(const ControllerParts& parts)
      : document_(parts.document),
        settings_(parts.settings),
        commands_(parts.commands),
        messages_(parts.messages),
        window_(parts.window) {}

  void announce(const QString& text) const { messages_.announce(text); }

  Document& document_;
  Settings& settings_;
  CommandTable& commands_;
  WindowMessages& messages_;
  QWidget& window_;
};

}  // namespace relievo
