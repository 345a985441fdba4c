// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <memory>
#include <QPointF>
#include <QString>
#include <QTemporaryDir>

#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"

class QAction;

namespace relievo {

/// A small window with a small relief, in XDG places of its own.
class GuiTest : public ::testing::Test {
 protected:
  GuiTest();
  ~GuiTest() override;

  MainWindow& window() { return *window_; }
  Document& document() { return window_->document(); }
  /// Closes the window and makes another one, as the next start of the program does.
  void restart();

  /// Path in the test's own folder.
  QString path(const QString& name) const { return folder_.filePath(name); }
  /// 500 x 400 points, 0.5 mm apart, a dome on a plate; three details.
  QString writeRelief(const QString& name = QStringLiteral("relief.ply")) const;
  /// Opens a relief and answers the question for its unit beforehand.
  void openRelief();

  QAction* action(const char* name) const;
  template <class Widget>
  Widget* child(const char* name) const {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }

  // Events straight to a widget; the real pointer stays where it is.
  static void move(QWidget& widget, const QPointF& to, Qt::MouseButtons held = Qt::NoButton);
  static void press(QWidget& widget, const QPointF& at, Qt::MouseButton button = Qt::LeftButton);
  static void release(QWidget& widget, const QPointF& at, Qt::MouseButton button = Qt::LeftButton);
  static void drag(QWidget& widget, const QPointF& from, const QPointF& to,
                   Qt::MouseButton button = Qt::LeftButton);
  static void wheel(QWidget& widget, const QPointF& at, int notches,
                    Qt::KeyboardModifiers modifiers = Qt::NoModifier);

 private:
  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

/// Waits for a condition while events are handled; false after a generous while.
bool waitFor(const std::function<bool()>& condition);

}  // namespace relievo
