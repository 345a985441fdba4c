// SPDX-License-Identifier: BSD-3-Clause
// A file's name is bytes: the window opens, shows, saves and remembers any that a file system
// allows.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <QAction>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QTextCodec>
#include <QtTest/QTest>
#include <QUrl>
#include <random>

#include "core/project/embedded_state.h"
#include "core/project/project.h"
#include "tests/ui/gui_fixture.h"
#include "ui/frame/message_strip.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// Without its ending; what the window shows of it.
struct Name {
  std::string bytes, shown;
};

class FileNames : public GuiTest, public testing::WithParamInterface<Name> {
 protected:
  fs::path named(const std::string& ending) const {
    return fs::path(bytesOfPath(path("."))).lexically_normal() / (GetParam().bytes + ending);
  }
  QString text(const std::string& ending) const { return pathFromBytes(named(ending).native()); }
  void openNamed() {
    fs::rename(bytesOfPath(writeRelief()), named(".ply"));
    OpenRequest request;
    request.file = text(".ply");
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    ASSERT_TRUE(opens()) << window().message().toStdString();
  }
  bool opens() {
    return waitFor([this] { return document().isOpen() && !document().loader().busy(); });
  }
  /// Qt takes the first "[*]" of a title for a star of its own, unless it stands twice.
  bool titleStartsWith(const char* ending) {
    const QString shown = QString::fromStdString(GetParam().shown).replace("[*]", "[*][*]");
    return window().windowTitle().startsWith(shown + ending);
  }
};

TEST_P(FileNames, AreOpenedShownSavedAndRemembered) {
  openNamed();
  const QString shown = QString::fromStdString(GetParam().shown + ".ply");
  EXPECT_TRUE(titleStartsWith(".ply")) << window().windowTitle().toStdString();
  EXPECT_EQ(child<QLabel>("surface_file")->text(), shown);
  EXPECT_EQ(bytesOfPath(window().settings().recentFiles().front()), named(".ply").native());
  EXPECT_EQ(window().project().file, named(".ply").native());

  window().saveProject(text(".json"));
  EXPECT_EQ(window().message(), QString());
  ASSERT_TRUE(fs::exists(named(".json")));
  EXPECT_EQ(readProject(named(".json")).file, named(".ply").native());

  restart();
  window().open(window().settings().recentFiles().front());
  ASSERT_TRUE(opens()) << window().message().toStdString();
  EXPECT_EQ(bytesOfPath(document().file()), named(".ply").native());
  EXPECT_EQ(window().message(), QString());
  EXPECT_TRUE(titleStartsWith(".json")) << window().windowTitle().toStdString();
}

TEST_P(FileNames, AreDroppedAsFileManagersSendThem) {
  fs::rename(bytesOfPath(writeRelief()), named(".ply"));
  QMimeData data;
  const QByteArray raw = QByteArray::fromStdString(named(".ply").native());
  data.setData("text/uri-list", "file://" + raw.toPercentEncoding("/") + "\r\n");
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &event);
  ASSERT_TRUE(opens()) << window().message().toStdString();
  EXPECT_EQ(bytesOfPath(document().file()), named(".ply").native());
}

TEST_P(FileNames, AddNoLinesToHeaders) {
  openNamed();
  const QString header = recordingHeader(window().document(), text(".csv"));
  for (const QString& line : header.split('\n')) {
    EXPECT_TRUE(line.startsWith(QLatin1String("# "))) << line.toStdString();
  }
  EXPECT_EQ(header.count('\n'), 10) << header.toStdString();
  EXPECT_TRUE(header.contains(QString::fromStdString("\n# input: " + GetParam().shown + ".ply\n")));
  EXPECT_FALSE(header.contains(QChar(0xFFFD)));
}

TEST_P(FileNames, OfWorkThatWasKeptComeBack) {
  openNamed();
  Project work = window().project();
  work.places = {{.name = "nose", .region = work.region}};
  work.saved_as = named(".json").native();
  fs::create_directories(bytesOfPath(path("state/relievo/autosave")));
  writeProject(bytesOfPath(path("state/relievo/autosave/autosave-dead01.json")), work);
  std::ofstream(bytesOfPath(path("state/relievo/autosave/autosave-dead01.lock")));
  restart();
  const QString asked = window().message();
  EXPECT_TRUE(asked.contains(QString::fromStdString(GetParam().shown + ".json")))
      << asked.toStdString();
  ASSERT_TRUE(window().runCommand("answer"));
  ASSERT_TRUE(opens()) << window().message().toStdString();
  EXPECT_EQ(bytesOfPath(document().file()), named(".ply").native());
  ASSERT_TRUE(window().runCommand("save_project"));
  EXPECT_EQ(readProject(named(".json")).places.size(), 1U);
}

TEST_P(FileNames, OfFiguresAndPicturesAreFoundAgain) {
  openNamed();
  window().saveImage(ImageSource::detail, {320, 240}, text(".png"));
  ASSERT_TRUE(waitFor([this] { return !window().savingImage(); }));
  EXPECT_EQ(window().message(), QString());
  const auto state = embeddedProject(named(".png"));
  ASSERT_TRUE(state.has_value());
  EXPECT_EQ(state->file, named(".ply").native());
  EXPECT_EQ(window().project().figures, std::vector<std::string>{named(".png").native()});
}

INSTANTIATE_TEST_SUITE_P(Any, FileNames,
                         testing::Values(Name{"b\xFCste", "b%FCste"},
                                         Name{"two\nlines", "two%0Alines"},
                                         Name{"-quote\"'%41\\&", "-quote\"'%41\\&"},
                                         Name{"<b>bold<br>", "<b>bold<br>"},
                                         Name{"\xEE\xBE\x80[*]%1", "\xEE\xBE\x80[*]%1"}));

TEST_F(GuiTest, ANameOf255BytesOpensAndItsProjectGetsAShorterOne) {
  const std::string stem = "\xE9" + std::string(250, 'x');
  const fs::path scan = fs::path(bytesOfPath(path("."))).lexically_normal() / (stem + ".ply");
  fs::rename(bytesOfPath(writeRelief()), scan);
  OpenRequest request;
  request.file = pathFromBytes(scan.native());
  request.unit = LengthUnit::mm;
  window().open(request);
  const int width = window().minimumSizeHint().width();
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_LT(child<QLabel>("surface_file")->minimumSizeHint().width(), 300) << "of the side panel";
  window().showMessage(shownName(document().file()) + ' ' + shownPath(document().file()));
  EXPECT_LE(window().minimumSizeHint().width(), std::max(width, 860))
      << "the window keeps its size";
  window().findChild<MessageStrip*>()->close();
  ASSERT_TRUE(window().runCommand("save_project_as"));
  auto* dialog = window().findChild<QFileDialog*>("project_dialog");
  ASSERT_NE(dialog, nullptr);
  ASSERT_EQ(dialog->selectedFiles().size(), 1);
  const QString proposed = dialog->selectedFiles().front();
  EXPECT_LE(QFile::encodeName(QFileInfo(proposed).fileName()).size(), 255);
  EXPECT_TRUE(proposed.endsWith(".relievo.json"));
  dialog->close();
  window().saveProject(proposed);
  EXPECT_EQ(window().message(), QString());
  EXPECT_EQ(readProject(bytesOfPath(proposed)).file, scan.native());
}

TEST(FileNameCodec, KeepsEveryByteAlsoInPieces) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  const std::string bytes = "a/\x80\xBE\xC3\xBC\xE0\xA0\xED\xEE\xBE\xBF\xF0\x9F\x8F\xBA\xFF";
  for (int i = 0; i < 5'000; ++i) {
    std::string name;
    for (std::size_t length = random() % 12; length > 0; --length) {
      name += bytes[random() % bytes.size()];
    }
    ASSERT_EQ(bytesOfPath(pathFromBytes(name)), name) << "seed " << kSeed << ", number " << i;
  }
  const QByteArray whole("M\xC3\xBCnze \xE0\xA4\xB8 \xF0\x9F\x8F\xBA");
  QTextCodec::ConverterState state;
  QString text;
  for (int i = 0; i < whole.size(); ++i) {
    text += QTextCodec::codecForLocale()->toUnicode(whole.constData() + i, 1, &state);
  }
  EXPECT_EQ(text, QString::fromUtf8(whole));
}

}  // namespace
}  // namespace relievo
