// SPDX-License-Identifier: BSD-3-Clause
// A visitor goes through an exhibit by the device's buttons and by keys; the clock is the test's.
#include "ui/exhibit/exhibit_control.h"

#include <QAction>
#include <QCloseEvent>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include "tests/ui/gui_fixture.h"
#include "ui/language/language.h"

namespace relievo {
namespace {

class ExhibitControlTest : public GuiTest {
 protected:
  ~ExhibitControlTest() override {
    control_.reset();
    applyLanguage(*qApp, QStringLiteral("en"));
  }

  /// @param whole  with the introduction, and a grip that can lead
  void begin(bool whole = false) {
    Exhibit exhibit;
    exhibit.touch.introduction = exhibit.touch.guide = whole;
    if (whole) exhibit.touch.device = "falcon";
    exhibit.languages = {"en", "de"};
    for (const char* name : {"first.ply", "second.ply"}) {
      ExhibitObject object;
      object.id = name;
      object.file = writeRelief(QString::fromLatin1(name)).toStdString();
      object.unit = LengthUnit::mm;
      object.view = "top";
      object.title = {{"en", "Dome"}, {"de", "Kuppel"}};
      object.description = {{"en", "It is round."}, {"de", "Sie ist rund."}};
      exhibit.objects.push_back(object);
    }
    exhibit.pin = staffPinOf("2580", "salt");
    exhibit.records = path(QStringLiteral("records")).toStdString();
    control_ = std::make_unique<ExhibitControl>(
        window(), exhibit,
        ExhibitWays{.say = [this](const std::vector<Message>& words) { said_ = words; },
                    .reset_voice = [this] { ++resets_; },
                    .speaks = {},
                    .now_s = [this] { return now_s_; },
                    .day = [] { return std::string("2026-11-24"); }});
  }
  void press(const char* command) {
    control_->press(QString::fromLatin1(command));
    control_->tick();
  }
  void after(double seconds) {
    now_s_ += seconds;
    control_->tick();
  }
  void key(Qt::Key key, Qt::KeyboardModifiers held = Qt::NoModifier) {
    QTest::keyClick(&window(), key, held);
    control_->tick();
  }
  bool touches() {
    return waitFor([this] {
      control_->tick();
      return control_->visit().state() == Visit::State::touching;
    });
  }
  QString caption() const { return control_->caption().text(); }

  double now_s_ = 1000;
  int resets_ = 0;
  std::vector<Message> said_;
  std::unique_ptr<ExhibitControl> control_;
};

TEST_F(ExhibitControlTest, AVisitorGoesThroughThePlaylistByButtons) {
  begin();
  press("whereAmI");
  EXPECT_TRUE(caption().contains("For English press the middle button."))
      << caption().toStdString();
  press("moveMode");
  EXPECT_TRUE(caption().contains(QString::fromUtf8("Für Deutsch"))) << caption().toStdString();
  press("whereAmI");
  EXPECT_TRUE(caption().contains("Objekt 1 von 2: Kuppel. Sie ist rund."))
      << caption().toStdString();
  press("moveMode");
  EXPECT_TRUE(caption().contains("Objekt 2 von 2")) << caption().toStdString();
  press("whereAmI");
  ASSERT_TRUE(touches());
  EXPECT_TRUE(document().file().endsWith("second.ply"));
  EXPECT_EQ(control_->counts().days().at("2026-11-24").at("second.ply").starts, 1);
  EXPECT_FALSE(control_->press(QStringLiteral("finer"))) << "the window's while touching";
  EXPECT_TRUE(control_->press(QStringLiteral("whole"))) << "and back to the list";
}

TEST_F(ExhibitControlTest, AGripThatIsMovedWakesItBeforeAnythingIsOpen) {
  begin();
  ASSERT_EQ(control_->visit().state(), Visit::State::idle);
  ASSERT_FALSE(document().isOpen());
  control_->noteGrip({0, 0, 0});
  control_->noteGrip({2, 0, 0});
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::idle) << "a grip that lies there trembles";
  control_->noteGrip({2, 0, 7});
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::language);
  ASSERT_TRUE(waitFor([this] {  // Whoever it was has gone.
    after(1);
    control_->noteGrip({2, 0, 7});
    return control_->visit().state() == Visit::State::idle;
  }));
  control_->noteGrip({2, -30, 7});
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::idle) << "nobody holds it any more: it sinks";
  after(5);
  control_->noteGrip({2, -20, 7});
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::language) << "the next one";
}

TEST_F(ExhibitControlTest, TheSameGoesByKeys) {
  begin();
  key(Qt::Key_Return);
  EXPECT_EQ(control_->visit().state(), Visit::State::language);
  key(Qt::Key_Return);
  EXPECT_EQ(control_->visit().state(), Visit::State::list);
  key(Qt::Key_Right);
  EXPECT_EQ(control_->visit().object(), 1U);
  key(Qt::Key_Return);
  ASSERT_TRUE(touches());
  ASSERT_EQ(document().detail(), 1);
  key(Qt::Key_Plus);
  EXPECT_EQ(document().detail(), 2);
  key(Qt::Key_Home);
  EXPECT_EQ(document().detail(), 1);
  key(Qt::Key_Home);
  EXPECT_EQ(control_->visit().state(), Visit::State::list);
}

TEST_F(ExhibitControlTest, HowMuchIsUnderTheHandIsSaidInAVisitorsWords) {
  begin();
  press("whereAmI");
  press("whereAmI");
  press("whereAmI");
  ASSERT_TRUE(touches());
  key(Qt::Key_Plus);
  ASSERT_EQ(document().detail(), 2);
  EXPECT_EQ(caption().toStdString(), "Closer. 20 centimetres wide.");
  key(Qt::Key_Plus);
  ASSERT_EQ(document().detail(), 3);
  key(Qt::Key_Minus);
  EXPECT_EQ(caption().toStdString(), "Wider. 20 centimetres wide.");
  key(Qt::Key_Minus);
  ASSERT_EQ(document().detail(), 1);
  EXPECT_EQ(caption(), "The whole relief.");
  key(Qt::Key_Plus);
  key(Qt::Key_Home);
  ASSERT_EQ(document().detail(), 1);
  EXPECT_EQ(caption(), "The whole relief.");
}

TEST_F(ExhibitControlTest, NothingOfTheMenusCanBeReached) {
  begin();
  openRelief();  // Commands that need an open map would be enabled now.
  EXPECT_FALSE(window().menuBar()->isVisible());
  int locked = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>()) {
    for (const QAction* command : menu->actions()) {
      if (ExhibitLock::isAllowed(command->objectName())) continue;
      if (command->objectName().isEmpty()) {  // A list of files in a menu that nobody sees.
        EXPECT_TRUE(command->shortcut().isEmpty()) << command->text().toStdString();
        continue;
      }
      EXPECT_FALSE(command->isEnabled()) << command->objectName().toStdString();
      ++locked;
    }
  }
  EXPECT_GT(locked, 80);
  for (const char* name : {"open", "save_project", "preferences", "quit", "figure"}) {
    EXPECT_FALSE(window().runCommand(QString::fromLatin1(name))) << name;
    EXPECT_FALSE(control_->allows(QString::fromLatin1(name))) << name;
  }
  key(Qt::Key_O, Qt::ControlModifier);
  key(Qt::Key_Comma, Qt::ControlModifier);
  key(Qt::Key_F, Qt::AltModifier);
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_TRUE(window().findChildren<QDialog*>().isEmpty());
}

TEST_F(ExhibitControlTest, ADeviceThatWasLostIsTakenBackForTheNextVisitor) {
  const auto add = [this](const char* name) {
    auto* made = new QAction(QString::fromLatin1(name));
    made->setObjectName(QString::fromLatin1(name));
    window().addToMenu(QStringLiteral("Touch"), made);
    return made;
  };
  QAction* const forces = add("forces");
  forces->setCheckable(true);
  QAction* const take_back = add("takeForcesBack");
  begin();
  EXPECT_TRUE(control_->allows(QStringLiteral("takeForcesBack")));
  const auto visit = [this] {
    control_->press(QStringLiteral("whole"));  // To the list, if somebody touches.
    control_->tick();
    for (int i = 0; i < 4 && control_->visit().state() != Visit::State::opening &&
                    control_->visit().state() != Visit::State::touching;
         ++i) {
      press("whereAmI");
    }
    return touches();
  };
  int times = 0;
  bool opens = true;
  QObject::connect(take_back, &QAction::triggered, take_back, [&] {
    ++times;
    take_back->setEnabled(!opens);
  });
  ASSERT_TRUE(visit());
  EXPECT_EQ(times, 1);
  EXPECT_FALSE(forces->isChecked()) << "they come when it is open";
  ASSERT_TRUE(visit());
  EXPECT_EQ(times, 1) << "there was nothing to take back";
  EXPECT_TRUE(forces->isChecked());
  forces->setChecked(false);
  take_back->setEnabled(true);
  opens = false;  // It is not there: the mouse stays the hand.
  ASSERT_TRUE(visit());
  EXPECT_EQ(times, 2);
  EXPECT_TRUE(forces->isChecked());
}

TEST_F(ExhibitControlTest, AWindowThatStoodStillHasNotWaitedForAnObjectInVain) {
  begin();
  press("whereAmI");
  press("whereAmI");
  press("whereAmI");
  ASSERT_EQ(control_->visit().state(), Visit::State::opening);
  document().loader().cancel();  // As where nobody answers what is asked: nothing comes.
  ASSERT_TRUE(waitFor([this] { return !document().loader().busy(); }));
  after(30);
  EXPECT_EQ(control_->visit().state(), Visit::State::opening) << "in one look";
  for (int i = 0; i < 6; ++i) after(1);
  EXPECT_EQ(control_->visit().state(), Visit::State::list) << "in six";
}

/// Loudest of each 50 ms of a WAV file, of full scale.
std::vector<double> loudness(const QByteArray& wav) {
  constexpr int kHeader = 44, kRateHz = 44100, kBlock = kRateHz / 20;
  std::vector<double> loudest;
  for (int i = 0; kHeader + 2 * i + 1 < wav.size(); ++i) {
    if (i % kBlock == 0) loudest.push_back(0);
    const auto low = static_cast<unsigned char>(wav[kHeader + 2 * i]);
    const auto sample = static_cast<qint16>(low | (wav[kHeader + 2 * i + 1] << 8));
    loudest.back() = std::max(loudest.back(), std::abs(sample) / 32767.0);
  }
  return loudest;
}

TEST_F(ExhibitControlTest, ThreeLowTonesSayThatNoVoiceSpeaks) {
  begin();
  // What plays is handed a file; this one keeps it.
  const QString played = path(QStringLiteral("played.wav"));
  control_->lowTones().setPlayer({"/bin/sh", "-c", "cp \"$0\" '" + played + "'"});
  control_->noteError(QStringLiteral("E303"));
  QTest::qWait(100);
  EXPECT_FALSE(QFile::exists(played)) << "of no other error";
  control_->noteError(QStringLiteral("E402"));
  const QByteArray expected = lowTonesWav(ExhibitSpeech{}.volume_percent);
  QByteArray wav;
  EXPECT_TRUE(waitFor([&] {
    QFile file(played);
    wav = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    return wav == expected;
  }));
  const double peak = Chime::kPeak * ExhibitSpeech{}.volume_percent / 100;
  const std::vector<double> heard = loudness(wav);
  ASSERT_EQ(heard.size(), 18U) << "0.9 s";
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_NEAR(heard[i], i % 6 < 4 ? peak : 0, 0.01) << "at " << 50 * i << " ms";
  }
}

TEST_F(ExhibitControlTest, ItIsLeftByThePinAlone) {
  begin();
  EXPECT_FALSE(window().close()) << "as the window manager asks";
  EXPECT_TRUE(control_->caption().asks());
  key(Qt::Key_Escape);
  EXPECT_FALSE(control_->caption().asks());
  for (const auto& [pressed, held] :
       {std::pair(Qt::Key_Q, Qt::ControlModifier), std::pair(Qt::Key_F4, Qt::AltModifier)}) {
    key(pressed, held);
    EXPECT_TRUE(window().isVisible());
    EXPECT_TRUE(control_->caption().asks());
    said_.clear();
    for (const Qt::Key digit : {Qt::Key_1, Qt::Key_1, Qt::Key_1, Qt::Key_1, Qt::Key_Return}) {
      key(digit);
    }
    EXPECT_TRUE(window().isVisible()) << "a wrong number";
    EXPECT_TRUE(said_.empty()) << "it is not spoken";
    after(21);
    EXPECT_FALSE(control_->caption().asks()) << "nobody types";
  }
  key(Qt::Key_Q, Qt::ControlModifier);
  for (const Qt::Key digit : {Qt::Key_2, Qt::Key_5, Qt::Key_8, Qt::Key_0, Qt::Key_Return}) {
    key(digit);
  }
  EXPECT_FALSE(window().isVisible());
}

TEST_F(ExhibitControlTest, WhoDoesNothingIsAskedAndThenTheNextOneFindsTheBeginning) {
  begin();
  const int resets = resets_;
  press("whereAmI");
  press("moveMode");
  press("whereAmI");
  press("whereAmI");
  ASSERT_TRUE(touches());
  ASSERT_TRUE(window().runCommand(QStringLiteral("finer")));
  after(61);
  EXPECT_EQ(control_->visit().state(), Visit::State::still);
  EXPECT_TRUE(caption().contains("Sind Sie noch da?")) << caption().toStdString();
  after(16);
  EXPECT_EQ(control_->visit().state(), Visit::State::idle);
  EXPECT_EQ(document().detail(), 1);
  EXPECT_GT(resets_, resets) << "the volume, too";
  press("whereAmI");
  EXPECT_TRUE(caption().contains("For English")) << "and the language";
}

/// No plugin is here: shapes and guide end at once, and what the window does is seen.
TEST_F(ExhibitControlTest, AVisitorIsToldOfButtonsObjectAndGuideAndThenTouches) {
  begin(true);
  press("whereAmI");
  press("whereAmI");
  press("whereAmI");
  ASSERT_TRUE(waitFor([this] {
    after(1);
    return control_->visit().state() == Visit::State::buttons;
  }));
  ASSERT_TRUE(waitFor([this] {
    after(0.5);
    return caption().contains("Now the buttons. Press any of them to go on.");
  }));
  EXPECT_TRUE(caption().contains("Middle button: where am I.")) << caption().toStdString();
  press("finer");
  EXPECT_EQ(caption(), "Plus: closer. Plus held: help.") << "once, though it was pressed";
  press("whereAmI");
  EXPECT_EQ(caption(), "Middle button: where am I. Minus: wider. Minus held: the whole relief.");
  press("moveMode");
  press("moveMode");
  press("moveMode");
  ASSERT_EQ(control_->visit().state(), Visit::State::object);
  ASSERT_TRUE(waitFor([this] {
    control_->tick();
    return caption().contains("You feel all of it now.");
  })) << caption().toStdString();
  EXPECT_TRUE(caption().startsWith("Relief, ")) << caption().toStdString();
  EXPECT_TRUE(caption().contains("hand is")) << "the scale: " << caption().toStdString();
  const QString object = caption();
  press("moveMode");
  EXPECT_EQ(caption(),
            "Shall I guide your hand along the outline once? Plus for yes, Minus for no.");
  press("repeatSpeech");
  EXPECT_TRUE(caption().startsWith("Shall I guide"));
  press("coarser");
  EXPECT_EQ(control_->visit().state(), Visit::State::touching);
  EXPECT_TRUE(caption().startsWith("Now touch as you like.")) << caption().toStdString();
  EXPECT_TRUE(control_->press(QStringLiteral("sayDetail"))) << "Plus held: help";
  control_->tick();
  EXPECT_TRUE(caption().contains("Now Plus is louder and Minus is softer."));
}

/// In the plugin's place: shapes and a guide that last until somebody ends them.
TEST_F(ExhibitControlTest, ShapesAndGuideAreOverWhenTheyEndAndNotBeforeTheyBegan) {
  const auto add = [this](const char* name) {
    auto* made = new QAction(QString::fromLatin1(name));
    made->setObjectName(QString::fromLatin1(name));
    made->setCheckable(true);
    window().addToMenu(QStringLiteral("Touch"), made);
    return made;
  };
  QAction* const shapes = add("touchIntroduction");
  QAction* const guide = add("guide");
  begin(true);
  press("whereAmI");
  press("whereAmI");
  press("whereAmI");
  ASSERT_TRUE(waitFor([this] {
    after(0.5);
    return control_->visit().state() == Visit::State::introduction;
  }));
  for (int i = 0; i < 20; ++i) after(0.5);
  EXPECT_EQ(control_->visit().state(), Visit::State::introduction) << "there are shapes";
  EXPECT_TRUE(shapes->isChecked());
  shapes->setChecked(false);
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::buttons);
  press("beacon");
  press("moveMode");
  ASSERT_EQ(control_->visit().state(), Visit::State::offer);
  press("finer");
  for (int i = 0; i < 20; ++i) after(0.5);
  EXPECT_EQ(control_->visit().state(), Visit::State::guiding) << "the hand is led";
  EXPECT_TRUE(guide->isChecked());
  guide->setChecked(false);
  after(0.1);
  EXPECT_EQ(control_->visit().state(), Visit::State::touching);
  EXPECT_FALSE(caption().startsWith("Now touch as you like.")) << "first the guide says why";
  ASSERT_TRUE(waitFor([this] {
    after(0.5);
    return caption().startsWith("Now touch as you like.");
  }));
}

TEST_F(ExhibitControlTest, WhereAHandRestsOnWhatNobodyMeasuredIsSaidOnceAndAGripThatLiesIsFree) {
  begin(true);
  press("whereAmI");
  press("whereAmI");
  press("whereAmI");
  ASSERT_TRUE(waitFor([this] {
    after(1);
    if (control_->visit().state() == Visit::State::offer) press("coarser");
    if (control_->visit().state() == Visit::State::buttons) press("moveMode");
    return control_->visit().state() == Visit::State::touching;
  }));
  Probe probe;
  probe.window_id = document().window()->id;
  probe.touching = true;
  probe.origin = CellStatus::base_plane;
  const auto feel = [&](double by_mm) {
    probe.hip.x = probe.proxy.x = document().window()->region.x_mm + by_mm;
    control_->feel(probe);
  };
  const double side_mm = document().window()->region.side_mm;
  feel(side_mm / 2);
  after(30);  // Nobody holds the grip, which is said ...
  after(5);   // ... and read.
  said_.clear();
  feel(side_mm / 3);
  after(0.7);
  EXPECT_TRUE(said_.empty()) << "no pause yet";
  after(0.2);
  EXPECT_EQ(caption(), "Not measured here. The real surface is missing in the scan.");
  feel(side_mm / 2);
  said_.clear();
  after(30);
  feel(side_mm / 3);
  said_.clear();
  after(1);
  EXPECT_TRUE(said_.empty()) << "once for a visitor and a place: " << caption().toStdString();
  after(1.5);
  EXPECT_EQ(control_->visit().state(), Visit::State::let_go);
  EXPECT_EQ(caption(), "Take the grip again to go on.");
  feel(side_mm / 2);
  EXPECT_EQ(control_->visit().state(), Visit::State::touching);
}

}  // namespace
}  // namespace relievo
