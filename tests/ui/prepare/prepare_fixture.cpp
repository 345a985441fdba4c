// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/prepare/prepare_fixture.h"

#include <array>
#include <cmath>
#include <numbers>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest/QTest>

namespace relievo {

PrepareDialog& PrepareGuiTest::openDialog() {
  EXPECT_TRUE(window().runCommand("prepare"));
  EXPECT_TRUE(isShown(dialog()));
  return dialog();
}

PrepareDialog& PrepareGuiTest::openTogether(const QStringList& files) {
  window().openTogether(files);
  EXPECT_TRUE(isShown(dialog()));
  return dialog();
}

void PrepareGuiTest::carryCross(CloudView& view, const QPointF& to) {
  const QPointF target = to.toPoint();
  for (int presses = 0; presses < 2000; ++presses) {
    const QPointF left = target - view.cross();
    const bool sideways = std::abs(left.x()) >= 1;
    const double by = sideways ? left.x() : left.y();
    if (std::abs(by) < 1) return;
    const int key =
        sideways ? (by > 0 ? Qt::Key_Right : Qt::Key_Left) : (by > 0 ? Qt::Key_Down : Qt::Key_Up);
    QTest::keyClick(&view, static_cast<Qt::Key>(key),
                    std::abs(by) < 12 ? Qt::ShiftModifier : Qt::NoModifier);
  }
  FAIL() << "the cross does not get there";
}

PrepareDialog& PrepareGuiTest::dialog() {
  auto* found = window().findChild<PrepareDialog*>(QStringLiteral("prepare_dialog"));
  EXPECT_NE(found, nullptr);
  // Xvfb has no window manager that would; keys reach shortcuts only in the active window.
  QApplication::setActiveWindow(found);
  return *found;
}

bool PrepareGuiTest::isShown(PrepareDialog& dialog) {
  return waitFor([&] { return !dialog.isStale() && !dialog.isBusy(); });
}

void PrepareGuiTest::addStep(PrepareDialog& dialog, const char* entry) {
  QMenu* menu = dialog.findChild<QPushButton*>("prepare_add_step")->menu();
  Q_EMIT menu->aboutToShow();
  auto* action = menu->findChild<QAction*>(QString::fromLatin1(entry));
  ASSERT_NE(action, nullptr) << entry;
  action->trigger();
}

void PrepareGuiTest::setNumber(PrepareDialog& dialog, const char* field, double value) {
  auto* box = dialog.findChild<QDoubleSpinBox*>(QString::fromLatin1(field));
  ASSERT_NE(box, nullptr) << field;
  box->setValue(value);
}

void PrepareGuiTest::choose(PrepareDialog& dialog, const char* name, int index) {
  auto* box = dialog.findChild<QComboBox*>(QString::fromLatin1(name));
  ASSERT_NE(box, nullptr) << name;
  box->setFocus();
  while (box->currentIndex() != index) {
    const int before = box->currentIndex();
    QTest::keyClick(box, before < index ? Qt::Key_Down : Qt::Key_Up);
    // A form may be made anew by what is chosen in it.
    box = dialog.findChild<QComboBox*>(QString::fromLatin1(name));
    ASSERT_NE(box->currentIndex(), before) << name;
  }
}

void PrepareGuiTest::click(PrepareDialog& dialog, const char* button) {
  auto* found = dialog.findChild<QPushButton*>(QString::fromLatin1(button));
  ASSERT_NE(found, nullptr) << button;
  ASSERT_TRUE(found->isEnabled() && found->isVisible()) << button;
  QTest::mouseClick(found, Qt::LeftButton);
}

QString PrepareGuiTest::label(PrepareDialog& dialog, const char* name) {
  return dialog.findChild<QLabel*>(QString::fromLatin1(name))->text();
}

QTreeWidget& PrepareGuiTest::tree(PrepareDialog& dialog, const char* name) {
  return *dialog.findChild<QTreeWidget*>(QString::fromLatin1(name));
}

CloudView& PrepareGuiTest::cloudView(PrepareDialog& dialog, const char* name) {
  return *dialog.findChild<CloudView*>(QString::fromLatin1(name));
}

namespace {

constexpr int kBodyPoints = 60'000;

/// Distance of the surface from the middle: an egg with hills of several sizes, no two alike.
double radius(double x, double y, double z) {
  return 40 + 8 * z + 5 * std::sin(3 * x + 1) * std::cos(2 * y) + 3 * std::sin(5 * y + 2 * z) +
         2 * std::cos(7 * z - 3 * x);
}

}  // namespace

std::array<double, 3> PrepareGuiTest::onBody(double azimuth_deg, double z) {
  constexpr double kDeg = std::numbers::pi / 180;
  const double flat = std::sqrt(1 - z * z);
  const double x = flat * std::cos(azimuth_deg * kDeg), y = flat * std::sin(azimuth_deg * kDeg);
  const double r = radius(x, y, z);
  return {r * x, r * y, r * z};
}

FilePoint PrepareGuiTest::laid(const std::array<double, 3>& p, const BodyPlace& place) {
  constexpr double kDeg = std::numbers::pi / 180;
  const double c = std::cos(place.turned_deg * kDeg), s = std::sin(place.turned_deg * kDeg);
  return {c * p[0] - s * p[1] + place.moved[0], s * p[0] + c * p[1] + place.moved[1],
          p[2] + place.moved[2]};
}

QString PrepareGuiTest::writeBody(const QString& name, double azimuth_deg, double open_deg,
                                  const BodyPlace& place) const {
  constexpr double kDeg = std::numbers::pi / 180;
  const double look_x = std::cos(azimuth_deg * kDeg), look_y = std::sin(azimuth_deg * kDeg);
  QByteArray points;
  int count = 0;
  for (int i = 0; i < kBodyPoints; ++i) {
    // Evenly on a sphere (Fibonacci); each scan begins at another place, so that no point is twice.
    const double z = 1 - 2 * (i + 0.5) / kBodyPoints;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0)) + azimuth_deg;
    const double flat = std::sqrt(1 - z * z);
    if (flat * std::cos(angle) * look_x + flat * std::sin(angle) * look_y <
        std::cos(open_deg * kDeg)) {
      continue;
    }
    const FilePoint at = laid(onBody(angle / kDeg, z), place);
    const std::array<float, 3> p{static_cast<float>(at.x), static_cast<float>(at.y),
                                 static_cast<float>(at.z)};
    points.append(reinterpret_cast<const char*>(p.data()), sizeof p);
    ++count;
  }
  return writePoints(name, count, points);
}

QString PrepareGuiTest::writePlate(const QString& name, double from_x) const {
  QByteArray points;
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      const std::array<float, 3> p{static_cast<float>(from_x + 0.5 * col),
                                   static_cast<float>(0.5 * row), 0};
      points.append(reinterpret_cast<const char*>(p.data()), sizeof p);
    }
  }
  return writePoints(name, 80 * 80, points);
}

QString PrepareGuiTest::writePoints(const QString& name, int count,
                                    const QByteArray& floats) const {
  QFile file(path(name));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex " +
             QByteArray::number(count) +
             "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + floats);
  return file.fileName();
}

}  // namespace relievo
