// SPDX-License-Identifier: BSD-3-Clause
// What the desktop gets when the program is installed: its entry, its icons, its kinds of files,
// pictures of scans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <QGuiApplication>
#include <QImage>
#include <QMimeDatabase>
#include <QPainter>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QSvgRenderer>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int exit_code = -1;
  std::string out;  ///< Both streams.
};

Ran run(const std::string& command) {
  Ran ran;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) ran.out += static_cast<char>(c);
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  return ran;
}

/// "KEY=value" of an entry; empty: not there.
std::string valueIn(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\n" + key + "=");
  if (at == std::string::npos) return {};
  const std::size_t start = at + key.size() + 2;
  return text.substr(start, text.find('\n', start) - start);
}

class Desktop : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    const Ran ran = run(CMAKE_PROGRAM " --install " RELIEVO_BINARY_DIR " --prefix " + path("usr"));
    ASSERT_EQ(ran.exit_code, 0) << ran.out;
    ASSERT_EQ(::setenv("XDG_DATA_DIRS", (share("") + ":/usr/share").c_str(), 1), 0);
  }
  std::string share(const std::string& name) const { return path("usr/share/" + name); }
  std::string entry() const { return test::bytesOf(share("applications/relievo.desktop")); }
  std::string thumbnailer() const {
    return test::bytesOf(share("thumbnailers/relievo.thumbnailer"));
  }
};

TEST_F(Desktop, TheValidatorsHaveNothingToSay) {
  if (run("command -v desktop-file-validate && command -v appstreamcli").exit_code != 0) {
    GTEST_SKIP() << "desktop-file-validate or appstreamcli is not installed";
  }
  const Ran entry = run("desktop-file-validate " + share("applications/relievo.desktop"));
  EXPECT_EQ(entry.exit_code, 0);
  EXPECT_EQ(entry.out, "");
  // The project has no domain that its name could be under.
  const Ran about =
      run("appstreamcli validate --no-net --no-color --override cid-desktopapp-is-not-rdns=info " +
          share("metainfo/relievo.metainfo.xml"));
  EXPECT_EQ(about.exit_code, 0) << about.out;
}

/// There is no place on the web that has them; in the tree there is.
TEST_F(Desktop, ItsPicturesAreThoseOfThePages) {
  const QString about =
      QString::fromStdString(test::bytesOf(share("metainfo/relievo.metainfo.xml")));
  const QRegularExpression image(
      QStringLiteral("<image>https://relievo\\.invalid/(docs/user/[a-z_]+\\.png)</image>"));
  int pictures = 0;
  for (auto found = image.globalMatch(about); found.hasNext(); ++pictures) {
    const QString name = QStringLiteral(RELIEVO_SOURCE_DIR "/") + found.next().captured(1);
    EXPECT_GE(QImage(name).width(), 600) << name.toStdString();
  }
  EXPECT_EQ(pictures, 3);
  EXPECT_EQ(about.count(QLatin1String("<caption>")), pictures);
}

TEST_F(Desktop, EveryKindOfFileIsKnownByNameAndContent) {
  const std::vector<std::array<std::string, 3>> files{
      {"work.relievo.json", "{}", "application/vnd.relievo.project+json"},
      {"site.relievo.tif", "II*", "image/vnd.relievo.map+tiff"},
      {"site.tif", "II*", "image/tiff"},
      {"a.ply", "ply\nformat ascii 1.0\n", "application/vnd.relievo.ply"},
      {"without_ending", "ply\nformat ascii 1.0\n", "application/vnd.relievo.ply"},
      {"a.pcd", "# .PCD v0.7 - Point Cloud Data\n", "application/vnd.relievo.pcd"},
      {"a.las", "LASF", "application/vnd.las"},
      {"a.laz", "LASF", "application/vnd.laszip"},
      {"a.e57", "ASTM-E57", "application/vnd.relievo.e57"},
      {"a.ptx", "1\n", "application/vnd.relievo.ptx"},
      {"a.pts", "1\n", "application/vnd.relievo.pts"},
      {"plain.json", "{}", "application/json"},
  };
  const QMimeDatabase known;
  for (const auto& [name, content, type] : files) {
    const std::string file = write(name, content);
    EXPECT_EQ(known.mimeTypeForFile(QString::fromStdString(file)).name().toStdString(), type)
        << name;
  }
  for (const std::string& text : {entry(), thumbnailer()}) {
    const QStringList types = QString::fromStdString(valueIn(text, "MimeType"))
                                  .split(QLatin1Char(';'), Qt::SkipEmptyParts);
    EXPECT_GE(types.size(), 8);
    EXPECT_EQ(QSet<QString>(types.begin(), types.end()).size(), types.size());
    for (const QString& type : types) {
      EXPECT_TRUE(known.mimeTypeForName(type).isValid()) << type.toStdString();
    }
  }
}

TEST_F(Desktop, TheIconIsDrawnAtEverySize) {
  for (const auto& [name, colours] : {std::pair{"scalable/apps/relievo.svg", 40},
                                      std::pair{"symbolic/apps/relievo-symbolic.svg", 2}}) {
    QSvgRenderer icon(QString::fromStdString(share("icons/hicolor/") + name));
    ASSERT_TRUE(icon.isValid()) << name;
    for (const int size : {16, 22, 32, 48, 64, 128, 256, 512}) {
      QImage image(size, size, QImage::Format_ARGB32);
      image.fill(Qt::transparent);
      QPainter painter(&image);
      icon.render(&painter);
      painter.end();
      QSet<QRgb> seen;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) seen.insert(image.pixel(x, y));
      }
      EXPECT_GE(seen.size(), colours) << name << " at " << size;
      EXPECT_EQ(qAlpha(image.pixel(0, 0)), 0) << "the corner";
    }
  }
}

/// Some file managers give a name that ends in .png, others one that ends in nothing known.
TEST_F(Desktop, FileManagersGetAPictureOfAScan) {
  const std::string scan = RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply";
  ASSERT_EQ(::setenv("PATH", (path("usr/bin") + ":" + std::getenv("PATH")).c_str(), 1), 0);
  for (const char* name : {"thumb.png", ".desktop_thumbnail.ABCDEF"}) {
    std::string command = valueIn(thumbnailer(), "Exec");
    for (const auto& [field, value] : {std::pair{"%s", std::string("128")},
                                       std::pair{"%o", path(name)}, std::pair{"%i", scan}}) {
      const std::size_t at = command.find(field);
      ASSERT_NE(at, std::string::npos) << field;
      command.replace(at, 2, value);
    }
    const Ran ran = run(command);
    ASSERT_EQ(ran.exit_code, 0) << ran.out;
    const QImage image(QString::fromStdString(path(name)), "PNG");
    EXPECT_EQ(image.size(), QSize(128, 128));
    QSet<QRgb> seen;
    for (int x = 0; x < image.width(); ++x) seen.insert(image.pixel(x, 64));
    EXPECT_GE(seen.size(), 10) << "a relief, not one colour";
  }
}

/// What is no scan leaves nothing behind, and is told by the exit code as file managers ask it.
TEST_F(Desktop, ADamagedScanHasNoPicture) {
  ASSERT_EQ(::setenv("PATH", (path("usr/bin") + ":" + std::getenv("PATH")).c_str(), 1), 0);
  const std::string cut = write("cut.ply",
                                "ply\nformat ascii 1.0\nelement vertex 900\nproperty float x\n"
                                "property float y\nproperty float z\nend_header\n1 2 3\n");
  const std::string promised =
      write("promised.ply",
            "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
            "property float y\nproperty float z\nend_header\n");
  for (const std::string& scan : {cut, promised, path("gone.ply")}) {
    std::string command = valueIn(thumbnailer(), "Exec");
    const std::string picture = path("damaged.png");
    for (const auto& [field, value] :
         {std::pair{"%s", std::string("128")}, std::pair{"%o", picture}, std::pair{"%i", scan}}) {
      command.replace(command.find(field), 2, value);
    }
    EXPECT_NE(run(command).exit_code, 0) << scan;
    EXPECT_FALSE(fs::exists(picture)) << scan;
    EXPECT_FALSE(fs::exists(picture + ".png")) << scan;
  }
}

/// As a double click does: the entry's command with the file in the place of %F.
TEST_F(Desktop, TheEntryOpensAScanInAWindowWithTheIcon) {
  ASSERT_EQ(valueIn(entry(), "Exec"), "relievo %F");
  test::ProgramWindow window({RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply"},
                             path("usr/bin/relievo"));
  ASSERT_TRUE(test::eventually([&] { return window.title().starts_with("relief_f.ply"); }));
  EXPECT_TRUE(window.hasIcon());
  const std::string recent = path("XDG_DATA_HOME/recently-used.xbel");
  EXPECT_TRUE(test::eventually([&] {
    return test::bytesOf(recent).find("/data/samples/relief_f.ply\"") != std::string::npos;
  })) << "the desktop knows that it was opened";
}

/// With the program and its page where they were installed, since systemd looks for both.
TEST_F(Desktop, TheExhibitsUnitIsOneThatSystemdTakes) {
  if (run("command -v systemd-analyze").exit_code != 0) {
    GTEST_SKIP() << "systemd-analyze is not installed";
  }
  std::string unit = test::bytesOf(path("usr/lib/systemd/user/relievo-exhibit.service"));
  const std::string started = "ExecStart=relievo ";
  const std::size_t at = unit.find(started);
  ASSERT_NE(at, std::string::npos) << unit;
  unit.replace(at, started.size(), "ExecStart=" + path("usr/bin/relievo") + " ");
  const auto verify = [&](const std::string& text) {
    std::ofstream(path("relievo-exhibit.service")) << text;
    return run("XDG_RUNTIME_DIR=" + path("") + " MANPATH=" + share("man") +
               " systemd-analyze --user verify " + path("relievo-exhibit.service"));
  };
  const Ran good = verify(unit);
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_EQ(good.out, "") << "no warning either";
  unit.replace(unit.find("WatchdogSec="), 12, "WatchDogSec=");
  EXPECT_NE(verify(unit).out, "") << "it looks at every key";
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QGuiApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
