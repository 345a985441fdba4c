// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/gui_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QtTest/QTest>
#include <QWheelEvent>

#include "ui/vtk/depth_capture.h"

namespace relievo {
namespace {

constexpr int kTimeoutMs = 240'000;  // What happens is tested, not how fast on a busy computer.
constexpr int kCols = 500;
constexpr int kRows = 400;
constexpr double kSpacing = 0.5;

float domeHeight(double x, double y) {
  const double r2 = (x - 100) * (x - 100) + (y - 90) * (y - 90);
  return static_cast<float>(std::max(0.0, 20 - r2 / 125));
}

}  // namespace

bool waitFor(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, kTimeoutMs);
}

GuiTest::GuiTest() {
  qputenv("XDG_CONFIG_HOME", path(QStringLiteral("config")).toLocal8Bit());
  qputenv("XDG_CACHE_HOME", path(QStringLiteral("cache")).toLocal8Bit());
  qputenv("XDG_STATE_HOME", path(QStringLiteral("state")).toLocal8Bit());
  restart();
}

GuiTest::~GuiTest() {
  window_->close();
}

void GuiTest::restart() {
  if (window_) window_->close();
  window_.reset();
  window_ = std::make_unique<MainWindow>(captureDepths);
  if (!window_->settings().layout(QStringLiteral("geometry")).isValid()) window_->resize(860, 560);
  window_->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get(), kTimeoutMs));
  // Xvfb has no window manager that would; keys reach commands only in the active window.
  QApplication::setActiveWindow(window_.get());
}

QString GuiTest::writeRelief(const QString& name) const {
  QByteArray bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     QByteArray::number(kCols * kRows) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (int row = 0; row < kRows; ++row) {
    for (int col = 0; col < kCols; ++col) {
      const double x = col * kSpacing;
      const double y = row * kSpacing;
      const std::array<float, 3> point{static_cast<float>(x), static_cast<float>(y),
                                       domeHeight(x, y)};
      bytes.append(reinterpret_cast<const char*>(point.data()), sizeof point);
    }
  }
  QFile file(path(name));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
  return file.fileName();
}

void GuiTest::openRelief() {
  OpenRequest request;
  request.file = writeRelief();
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  window_->open(request);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_EQ(document().details(), 3);
  QApplication::processEvents();
}

QAction* GuiTest::action(const char* name) const {
  return window_->findChild<QAction*>(QString::fromLatin1(name));
}

namespace {
void send(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
          Qt::MouseButtons held) {
  QMouseEvent event(type, at, widget.mapToGlobal(at.toPoint()), button, held, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}
}  // namespace

void GuiTest::move(QWidget& widget, const QPointF& to, Qt::MouseButtons held) {
  send(widget, QEvent::MouseMove, to, Qt::NoButton, held);
}

void GuiTest::press(QWidget& widget, const QPointF& at, Qt::MouseButton button) {
  send(widget, QEvent::MouseButtonPress, at, button, button);
}

void GuiTest::release(QWidget& widget, const QPointF& at, Qt::MouseButton button) {
  send(widget, QEvent::MouseButtonRelease, at, button, Qt::NoButton);
}

void GuiTest::drag(QWidget& widget, const QPointF& from, const QPointF& to,
                   Qt::MouseButton button) {
  press(widget, from, button);
  for (int i = 1; i <= 4; ++i) move(widget, from + 0.25 * i * (to - from), button);
  release(widget, to, button);
}

void GuiTest::wheel(QWidget& widget, const QPointF& at, int notches,
                    Qt::KeyboardModifiers modifiers) {
  QWheelEvent event(at, QPointF(widget.mapToGlobal(at.toPoint())), QPoint(),
                    QPoint(0, 120 * notches), Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

}  // namespace relievo
