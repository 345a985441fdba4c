// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/pointer_bindings.h"

#include <QCoreApplication>
#include <QStringList>

namespace relievo {
namespace {

constexpr std::array<const char*, kPointerActs.size()> kKept{"turn", "move", "zoom", "none"};

QString said(const char* text) {
  return QCoreApplication::translate("relievo::PointerBindings", text);
}

/// Whole sentences rather than pieces: "turns" is another word with another button in some
/// languages.
QString leftText(PointerAct act) {
  switch (act) {
    case PointerAct::turn:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "left turns"));
    case PointerAct::move:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "left moves"));
    case PointerAct::zoom:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "left zooms"));
    case PointerAct::none:
      break;
  }
  return {};
}

QString middleText(PointerAct act) {
  switch (act) {
    case PointerAct::turn:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "middle turns"));
    case PointerAct::move:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "middle moves"));
    case PointerAct::zoom:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "middle zooms"));
    case PointerAct::none:
      break;
  }
  return {};
}

QString rightText(PointerAct act) {
  switch (act) {
    case PointerAct::turn:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "right turns"));
    case PointerAct::move:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "right moves"));
    case PointerAct::zoom:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "right zooms"));
    case PointerAct::none:
      break;
  }
  return {};
}

}  // namespace

QString keptName(PointerAct act) {
  return QString::fromLatin1(kKept.at(static_cast<std::size_t>(act)));
}

PointerAct pointerAct(const QString& kept, PointerAct otherwise) {
  for (const PointerAct act : kPointerActs) {
    if (kept == keptName(act)) return act;
  }
  return otherwise;
}

QString actText(PointerAct act) {
  switch (act) {
    case PointerAct::turn:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "turn the view"));
    case PointerAct::move:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "move the window"));
    case PointerAct::zoom:
      return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "zoom"));
    case PointerAct::none:
      break;
  }
  return said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "nothing"));
}

QString bindingsText(PointerMode mode, const PointerBindings& bindings) {
  const bool looks = mode == PointerMode::look;
  const PointerAct middle = looks ? bindings.look_middle : bindings.touch_middle;
  QStringList parts{
      looks ? leftText(bindings.look_left)
            : said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "left presses the hand in"))};
  // In look mode the middle button is named where it does what the left one does not.
  if (!looks || middle != bindings.look_left) parts << middleText(middle);
  parts << rightText(looks ? bindings.look_right : bindings.touch_right)
        << said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "wheel zooms"));
  parts.removeAll(QString());
  const QString name = looks ? said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "Look"))
                             : said(QT_TRANSLATE_NOOP("relievo::PointerBindings", "Touch"));
  return QStringLiteral("%1: %2").arg(name, parts.join(QStringLiteral(", ")));
}

}  // namespace relievo
