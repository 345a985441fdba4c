// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QList>

#include "ui/views/pointer_bindings.h"

class QAction;

namespace relievo {

/// Every key that works, from the commands themselves, by menus, and what the mouse does; found by
/// words. [GUI thread]
class KeysSheet : public QDialog {
  Q_OBJECT
 public:
  KeysSheet(const QList<QAction*>& commands, const PointerBindings& bindings, QWidget* parent);
};

}  // namespace relievo
