// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/journeys/journey.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QtTest/QTest>

namespace relievo {

class Journey::HearingHost : public WindowHost {
 public:
  using WindowHost::WindowHost;
  void announce(const QString& text, SaidBecause why) override {
    heard.append(text);
    WindowHost::announce(text, why);
  }

  QStringList heard;
};

Journey::Journey(std::string name) : name_(std::move(name)) {
  qputenv("HOME", path("home").toLocal8Bit());
  qputenv("XDG_DATA_HOME", path("data").toLocal8Bit());
  QDir().mkpath(path("home/Documents"));
}

Journey::~Journey() = default;

void Journey::TearDown() {
  detach();
}

void Journey::attach() {
  host_ = std::make_unique<HearingHost>(window());
  plugins_ = std::make_unique<PluginLoader>(*host_, window().settings());
  plugins_->load();
  ASSERT_TRUE(plugins_->has("haptics_plugin")) << plugins_->problems().join(' ').toStdString();
}

WindowHost& Journey::host() {
  return *host_;
}

void Journey::detach() {
  if (plugins_) plugins_->detachAll();
  plugins_.reset();
  host_.reset();
}

bool Journey::eventually(const std::function<bool()>& holds) {
  return QTest::qWaitFor(holds, 240'000);
}

bool Journey::soon(const std::function<bool()>& holds) {
  return QTest::qWaitFor(holds, 20'000);
}

bool Journey::settled() {
  return eventually([this] { return document().isOpen() && !document().loader().busy(); });
}

QString Journey::said() {
  return child<QLabel>("status_message")->text();
}

bool Journey::hears(const QString& words) {
  const bool heard = eventually([&] { return !host_->heard.filter(words).isEmpty(); });
  if (!heard) ADD_FAILURE() << "heard only: " << host_->heard.join(" | ").toStdString();
  host_->heard.clear();
  return heard;
}

double Journey::forceShown() {
  const QString text = child<QLabel>("status_force")->text();
  return text.endsWith("N") ? text.section('/', 0, 0).toDouble() : 0;
}

QPointF Journey::over(double x_mm, double y_mm) {
  const Region& r = document().project().region;
  const double mm = r.side_mm / std::min(detail().width() - 4, detail().height() - 4);
  return {0.5 * detail().width() + (x_mm - r.centreX()) / mm,
          0.5 * detail().height() - (y_mm - r.centreY()) / mm};
}

void Journey::carryHand(double x_mm, double y_mm) {
  const auto keys = [this](Qt::Key key, Qt::KeyboardModifiers with, int times) {
    for (int i = 0; i < times; ++i) QTest::keyClick(&detail(), key, with);
  };
  const double cell = document().window()->spacingMm();
  keys(Qt::Key_Right, {}, 1);  // A hand that was elsewhere comes into this window.
  for (const bool along_x : {true, false}) {
    const auto from = detail().hand();
    ASSERT_TRUE(from);
    const int cells =
        static_cast<int>(std::lround((along_x ? x_mm - from->x : y_mm - from->y) / cell));
    const Qt::Key key = along_x ? (cells > 0 ? Qt::Key_Right : Qt::Key_Left)
                                : (cells > 0 ? Qt::Key_Up : Qt::Key_Down);
    keys(key, Qt::ShiftModifier, std::abs(cells) / 10);
    keys(key, {}, std::abs(cells) % 10);
  }
  EXPECT_NEAR(detail().hand()->x, x_mm, cell);
  EXPECT_NEAR(detail().hand()->y, y_mm, cell);
}

void Journey::key(int key, Qt::KeyboardModifiers with) {
  QApplication::setActiveWindow(&window());
  QTest::keyClick(&detail(), static_cast<Qt::Key>(key), with);
}

void Journey::choose(QComboBox& box, int index) {
  QApplication::setActiveWindow(box.window());
  box.setFocus();
  for (int tries = box.count(); box.currentIndex() != index && tries > 0; --tries) {
    QTest::keyClick(&box, box.currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
  }
  EXPECT_EQ(box.currentIndex(), index) << box.objectName().toStdString();
}

void Journey::type(QDoubleSpinBox& box, const QString& number) {
  QApplication::setActiveWindow(box.window());
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, number);
  QTest::keyClick(&box, Qt::Key_Tab);
}

void Journey::drop(const QString& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &event);
}

QString Journey::kept(const QString& file) const {
  QDir().mkpath(RELIEVO_BINARY_DIR "/screenshots");
  return QStringLiteral(RELIEVO_BINARY_DIR "/screenshots/%1_%2")
      .arg(QString::fromStdString(name_), file);
}

void Journey::picture(QWidget& of, const QString& step) const {
  QTest::qWait(300);  // For whoever looks at it.
  EXPECT_TRUE(of.grab().save(kept(step + QLatin1String(".png"))));
}

std::vector<std::filesystem::path> Journey::recordings() const {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry :
       std::filesystem::directory_iterator(path("home/Documents/relievo").toStdString(), none)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

int largestDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 255;
  int largest = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      largest = std::max({largest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                          std::abs(qBlue(p) - qBlue(q))});
    }
  }
  return largest;
}

}  // namespace relievo
