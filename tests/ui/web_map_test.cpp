// SPDX-License-Identifier: BSD-3-Clause
// The window opens maps from the web by their addresses, keeps the addresses, and waits for no
// server: the test's own server holds and lets go what it answers.
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QtTest/QTest>
#include <QUrl>

#include "core/project/project.h"
#include "core/tiles/published/publish.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/small_map.h"
#include "tests/core/tiles/tile_fixtures.h"
#include "tests/ui/gui_fixture.h"
#include "ui/control/replay_controller.h"
#include "ui/dialogs/address_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

class WebMapTest : public GuiTest {
 protected:
  void SetUp() override {
    test::writeSmallMap(map_ / "map.tif", {.cols = 3000, .rows = 3000});
    publish(TiledMap(map_ / "map.tif"), map_ / "web", {});
    server_ = std::make_unique<test::SlowWebServer>(map_ / "web", test::SlowWebServer::Options{});
  }
  // What is asked for ahead must not wait for a server that the test holds.
  void TearDown() override { server_->letGo(); }

  QString address() const { return QString::fromStdString(server_->address()); }
  void open(const QString& address) {
    window().open(address);
    ASSERT_TRUE(settled());
  }
  bool settled() {
    return waitFor([this] { return !document().loader().busy(); });
  }
  bool isShown() {
    return waitFor([this] { return document().isOpen() && document().surface()->tiles; });
  }
  bool waitForLevel(int level) {
    return waitFor([&] { return document().window()->region.level.value == level; });
  }
  /// A place of the finest level that no step before came near.
  void goTo(double x_mm, double y_mm) {
    ASSERT_TRUE(document().region().goTo({.x_mm = x_mm, .y_mm = y_mm, .side_mm = 20, .level = {0}},
                                         1, QStringLiteral("There")));
  }
  QPushButton* stripButton(const QString& text) const {
    for (QPushButton* button : child<MessageStrip>("message_strip")->findChildren<QPushButton*>()) {
      if (button->text() == text && !button->isHidden()) return button;
    }
    return nullptr;
  }
  bool hears(const QString& words) {
    return waitFor([&] { return window().message().contains(words); });
  }

  const test::TileFolder map_;
  std::unique_ptr<test::SlowWebServer> server_;
};

TEST_F(WebMapTest, ItsCommandAsksForAnAddressAndOpensIt) {
  ASSERT_TRUE(window().runCommand(QStringLiteral("open_address")));
  auto* dialog = window().findChild<AddressDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* line = dialog->findChild<QLineEdit*>(QStringLiteral("address_line"));
  EXPECT_EQ(line->accessibleName(), "Address of a published map");
  auto* button = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
  QTest::keyClicks(line, QStringLiteral("relief.ply"));
  EXPECT_FALSE(button->isEnabled());
  EXPECT_TRUE(line->accessibleDescription().contains("https://")) << "and it says what one is";
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral(" %1/ ").arg(address()));
  EXPECT_TRUE(button->isEnabled());
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_TRUE(isShown());
  EXPECT_TRUE(document().surface()->tiles->isRemote());
  const QString host = address().section("://", 1);
  EXPECT_TRUE(window().windowTitle().contains(host)) << window().windowTitle().toStdString();
  EXPECT_EQ(window().settings().recentFiles(), QStringList{address()});
  restart();
  EXPECT_EQ(window().settings().recentFiles(), QStringList{address()});
}

TEST_F(WebMapTest, ALinkThatIsDroppedOpens) {
  QMimeData data;
  data.setUrls({QUrl(address() + "/map.json")});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &event);
  EXPECT_TRUE(isShown());
}

TEST_F(WebMapTest, AProjectKeepsTheAddressAndOpensItAgain) {
  open(address());
  goTo(100, 120);
  ASSERT_TRUE(waitForLevel(0));
  const QString file = path(QStringLiteral("p.relievo.json"));
  window().saveProject(file);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  const Project saved = readProject(bytesOfPath(file));
  EXPECT_EQ(saved.file, server_->address());
  const std::uint64_t id = document().window()->id;
  document().close();
  open(file);
  ASSERT_TRUE(isShown()) << window().message().toStdString();
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_EQ(document().project().region, saved.region);
  ASSERT_TRUE(waitForLevel(0));
  EXPECT_EQ(document().window()->id, id);
  // And once more, from what was read.
  window().saveProject(file);
  EXPECT_EQ(readProject(bytesOfPath(file)).file, server_->address());
  EXPECT_EQ(document().provenanceIn(file).input.file, server_->address());
}

TEST_F(WebMapTest, ARecordingOfItIsReplayedOnItAndFindsItAgain) {
  open(address());
  goTo(100, 120);
  ASSERT_TRUE(waitForLevel(0));
  EXPECT_TRUE(recordingHeader(document(), path(QStringLiteral("touch.csv"))).contains(address()))
      << "what a recording is found by";
  TouchRecording recording;
  recording.name = "touch.csv";
  for (int i = 0; i <= 100; ++i) {
    TouchRow row;
    row.t_s = 0.01 * i;
    row.hip = row.proxy = {100 + 0.01 * i, 120, 2};
    row.window_id = document().window()->id;
    recording.rows.push_back(row);
  }
  recording.windows = {{document().window()->id, document().window()->region, 1, true}};
  recording.input = server_->address();
  recording.input_sha256 = document().fileSha256().toStdString();
  recording.state = projectJson(document().project());
  window().controllers().replays.setReader(
      [&recording](const std::filesystem::path&, const Task&) { return recording; });
  ReplayControl& control = window().controllers().replays.control();
  const auto replay = [&] { window().replay(path(QStringLiteral("touch.csv"))); };
  replay();
  ASSERT_TRUE(waitFor([&] { return control.showing(); })) << window().message().toStdString();
  EXPECT_DOUBLE_EQ(window().detailView().sceneState().probe->proxy.x, 100);
  control.close();
  // From another object, while its server says nothing.
  openRelief();
  server_->stop();
  replay();
  QPushButton* open_input = nullptr;
  ASSERT_TRUE(waitFor([&] {
    for (auto* button : window().findChildren<QPushButton*>()) {
      if (button->text().contains("input") && button->isVisible()) open_input = button;
    }
    return open_input != nullptr;
  })) << window().message().toStdString();
  EXPECT_FALSE(control.showing());
  QTest::mouseClick(open_input, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return control.showing(); })) << window().message().toStdString();
  EXPECT_TRUE(document().surface()->tiles->isRemote());
  EXPECT_DOUBLE_EQ(document().project().region.x_mm, 100);
}

TEST_F(WebMapTest, AProjectOfAnAddressThatIsNewHereAsksFirst) {
  Project project;
  project.file = server_->address();
  project.region = {.x_mm = 100, .y_mm = 120, .side_mm = 20, .level = {0}};
  const QString file = path(QStringLiteral("p.relievo.json"));
  writeProject(bytesOfPath(file), project);
  open(file);
  ASSERT_TRUE(hears(address())) << window().message().toStdString();
  EXPECT_EQ(server_->requests(), 0) << "who wrote the project does not choose the server";
  EXPECT_FALSE(document().isOpen());
  QPushButton* yes = stripButton(QStringLiteral("&Open the map"));
  ASSERT_NE(yes, nullptr);
  QTest::mouseClick(yes, Qt::LeftButton);
  ASSERT_TRUE(isShown());
  EXPECT_EQ(document().project().region, project.region);
}

TEST_F(WebMapTest, WhatIsWrongIsOneSentenceAndNothingIsLost) {
  openRelief();
  const DocumentState before = document().state();
  open(QStringLiteral("http://127.0.0.1:9/map"));
  ASSERT_TRUE(hears(QStringLiteral("cannot be fetched now"))) << window().message().toStdString();
  EXPECT_NE(stripButton(QStringLiteral("&Try again")), nullptr);
  open(address() + "/nothing");
  ASSERT_TRUE(hears(QStringLiteral("has no file map.json"))) << window().message().toStdString();
  server_->damage("packs.bin");
  open(address());
  ASSERT_TRUE(hears(QStringLiteral("packs.bin"))) << window().message().toStdString();
  EXPECT_TRUE(hears(QStringLiteral("is damaged")));
  EXPECT_EQ(document().state(), before);
  EXPECT_TRUE(window().windowTitle().contains("relief.ply"));
  server_->damage("");
  QPushButton* again = stripButton(QStringLiteral("&Try again"));
  ASSERT_NE(again, nullptr);
  QTest::mouseClick(again, Qt::LeftButton);
  EXPECT_TRUE(isShown());
}

TEST_F(WebMapTest, WhatIsOnItsWayIsShownCoarserAndThenTheFinerOne) {
  open(address());
  goTo(100, 120);
  ASSERT_TRUE(waitForLevel(0));
  server_->hold();
  goTo(240, 20);  // It comes back at once, although no server answers.
  EXPECT_GT(document().window()->region.level.value, 0);
  EXPECT_EQ(document().project().region.level.value, 0);
  EXPECT_EQ(document().window()->region.x_mm, 240);
  const auto* field = child<QLabel>("status_detail");
  EXPECT_TRUE(field->text().contains("on its way")) << field->text().toStdString();
  EXPECT_FALSE(recordingHeader(document(), path(QStringLiteral("a.csv"))).contains("# level: 0"))
      << "a recording says what is felt";
  server_->letGo();
  ASSERT_TRUE(waitForLevel(0));
  EXPECT_TRUE(recordingHeader(document(), path(QStringLiteral("a.csv"))).contains("# level: 0"));
  EXPECT_FALSE(field->text().contains("on its way")) << field->text().toStdString();
  EXPECT_EQ(document().window()->id,
            document().surface()->tiles->window(document().project().region).id);
}

TEST_F(WebMapTest, AServerThatGoesIsSaidAndWhatIsHereStays) {
  open(address());
  goTo(100, 120);
  ASSERT_TRUE(waitForLevel(0));
  server_->stop();
  goTo(240, 20);
  EXPECT_GT(document().window()->region.level.value, 0);
  ASSERT_TRUE(hears(QStringLiteral("gives no answer"))) << window().message().toStdString();
  document().history().undo();
  EXPECT_EQ(document().window()->region.level.value, 0) << "what was here can be seen";
  goTo(240, 20);
  server_->start();
  ASSERT_TRUE(waitForLevel(0));
  EXPECT_TRUE(waitFor([this] { return window().message().isEmpty(); }))
      << window().message().toStdString();
}

TEST_F(WebMapTest, WithoutItsServerAMapOpensAsItWasKept) {
  open(address());
  document().close();
  server_->stop();
  open(address());
  EXPECT_TRUE(isShown()) << window().message().toStdString();
}

TEST_F(WebMapTest, ADamagedTileIsRefusedAndTheCoarserLevelStays) {
  open(address());
  goTo(100, 120);
  ASSERT_TRUE(waitForLevel(0));
  server_->damage("L0.p");
  goTo(240, 20);
  ASSERT_TRUE(hears(QStringLiteral("is damaged"))) << window().message().toStdString();
  EXPECT_GT(document().window()->region.level.value, 0);
  EXPECT_TRUE(document().isOpen());
}

}  // namespace
}  // namespace relievo
