// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QStringList>
#include <QTimer>
#include <string>

#include "app/exhibit/exhibit_window.h"
#include "core/region/hand.h"
#include "haptics/commands/button_commands.h"
#include "tests/app/journeys/force_watch.h"
#include "tests/app/journeys/journey.h"
#include "tests/emulator/mock_usb.h"
#include "tests/emulator/stall_watch.h"
#include "tests/plugins/voice/sound_server.h"
#include "tests/plugins/voice/speech_server.h"

namespace relievo {

/// A visitor who sees nothing at an exhibit of one relief: the program's window with its plugins, a
/// Falcon emulated behind the real libusb, Debian's speech-dispatcher on a socket of its own with a
/// module that writes down what it would say, a program in espeak-ng's place that does the same,
/// and Debian's PulseAudio, of which what sounds is written into a file. What is heard is read
/// sentence by sentence, in order, and nothing may come between.
class Exhibition : public Journey {
 protected:
  static constexpr std::uint8_t kPlus = ButtonCommands::kPlus, kForward = ButtonCommands::kForward,
                                kCentre = ButtonCommands::kCentre, kMinus = ButtonCommands::kMinus;
  // Of the grip: over the relief, on a hill, in its ground.
  static constexpr double kAboveZ = 150, kOnZ = 124, kInZ = 116;
  static constexpr double kLimitN = 4;        // Of the exhibit.
  static constexpr double kMotorStepN = 0.2;  // Rounded counts, and how late the pose is.
  static constexpr double kNearMm = 5;        // Of where a hand was to touch.
  static constexpr int kPatienceMs = 20'000;  // Then a person tries again.

  /// @param name  what its pictures begin with
  explicit Exhibition(std::string name);
  ~Exhibition() override;
  void SetUp() override;
  void TearDown() override;

  const Visit& visit() const { return exhibit_->control().visit(); }
  bool reaches(Visit::State state);

  // What is heard.
  /// Sentences so far, "en|Welcome.", of either way of speaking.
  QStringList heard() const;
  /// Are these the next ones that are heard? One that cannot be heard any more fails the test.
  bool hears(const QString& language, const QStringList& sentences);
  bool hears(const QStringList& sentences) { return hears(language_, sentences); }
  /// Is the next one a length, as one says it, and `rest`? The hand lives, and a number jumps from
  /// "nearly 9" to "9": every length within `within_mm` of `mm` is right.
  bool hearsLength(double mm, double within_mm, const QString& rest);
  /// The next one, if it is this one.
  bool mayHear(const QString& sentence);
  /// What is said from now on lasts until a press cuts it, or until it is quick again.
  void speakSlowly(bool slowly) { speech_->speakSlowly(slowly); }
  /// In percent, of what was heard last.
  double volume() const;
  /// Everything up to now was heard.
  void forgetHeard();

  // Buttons and hand.
  void setButton(std::uint8_t button, bool down);
  /// Pressed shortly, or held so long; not again.
  void press(std::uint8_t button, int held_ms = 120);
  /// Pressed; once more, where a busy computer took it for another press and nothing came of it.
  bool press(std::uint8_t button, const std::function<bool()>& done, int held_ms = 120);
  /// The hand over a place of the object, as deep as `z` says; the window that is shown lies in
  /// its space.
  void handTo(double x_mm, double y_mm, double z);
  /// In the device's own millimetres: over a shape of the introduction.
  void gripTo(const DeviceMm& at, double z);
  /// Nobody holds it, where it is.
  void letGripLie();
  bool proxyNear(double x_mm, double y_mm, double within_mm);
  bool lit(int lights);
  /// The Falcon waits for its arms, and the exhibit knows that.
  bool waitsForGrip();
  /// Out, in and out: each arm finds its zero.
  bool homeGrip();

  // From one state to the next.
  /// Any button, the middle one for the language, and the grip: the forces are on.
  void begin();
  /// The introduction, the buttons, the object and the offer are passed over.
  void passOverToTouch();
  /// Down on a place while touching. A busy computer may stop the forces for safety; then a person
  /// lifts the hand and holds the middle button.
  bool touch(double x_mm, double y_mm, double z = kOnZ);

  /// Lines of the exhibit's log of its health.
  std::string health() const;
  /// For a failure's message.
  std::string where();

  emulator::MockUsb usb_;
  std::shared_ptr<emulator::SharedFalcon> falcon_;
  std::unique_ptr<ForceWatch> forces_;
  emulator::StallWatch stalls_;
  std::unique_ptr<test::SpeechDispatcher> speech_;
  std::unique_ptr<test::SoundServer> sound_;
  std::unique_ptr<ExhibitWindow> exhibit_;
  QString language_ = QStringLiteral("en");

 private:
  /// The next sentence, "en|Welcome."; empty: none came. The name of a place, which is said
  /// wherever a hand comes to rest, is passed over where another sentence is wanted.
  QString next(const QString& wanted);
  void writePrograms();
  void writeObject();
  void writeExhibit();

  int read_ = 0;      ///< Of heard(), by hears().
  DeviceMm grip_;     ///< Where the hand wants it ...
  double depth_ = 0;  ///< ... and how deep.
  DeviceMm aside_;    ///< Of the hand, from where the window alone would have it.
  QTimer tremor_;     ///< Of a living hand; one that lies still holds nothing.
  bool trembles_ = false;
};

}  // namespace relievo
