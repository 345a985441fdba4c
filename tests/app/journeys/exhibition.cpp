// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/journeys/exhibition.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <QApplication>
#include <QFile>
#include <QPluginLoader>
#include <QtTest/QTest>
#include <thread>

#include "core/describe/sayable.h"
#include "core/exhibit/staff_pin.h"
#include "core/project/project.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/protocol.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/urgent.h"
#include "ui/language/language.h"

namespace relievo {

namespace fs = std::filesystem;
using emulator::FalconEmulator;
using emulator::SharedFalcon;
using emulator::Triple;

namespace {

constexpr Triple kFarOut{0, 0, 172}, kFarIn{0, 0, 90};
constexpr double kDomeX = 90, kDomeY = 100;  // Of relief F, mm.

QStringList linesOf(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
}

/// What a busy computer makes the program say at any moment, and rightly.
bool isOfAStall(const QString& sentence) {
  for (const char* begin : {"Surface made softer", "Forces went off, because", "Softened to",
                            "The connection to the Falcon", "Forces off: "}) {
    if (sentence.startsWith(QLatin1String(begin))) return true;
  }
  return false;
}

}  // namespace

Exhibition::Exhibition(std::string name) : Journey(std::move(name)) {
  // Its folder is that of the test before, unless ctest gives one for all.
  if (!qEnvironmentVariableIsSet("MESA_SHADER_CACHE_DIR")) {
    qputenv("MESA_SHADER_CACHE_DISABLE", "true");
  }
  constexpr int kTremorMs = 250;
  constexpr double kTremorMm = 0.3;
  tremor_.setInterval(kTremorMs);
  QObject::connect(&tremor_, &QTimer::timeout, &tremor_, [this] {
    trembles_ = !trembles_;
    const double aside_mm = trembles_ ? kTremorMm : -kTremorMm;
    falcon_->with([&](FalconEmulator& f) {
      f.body.pullToward({grip_.x + aside_mm, grip_.y, depth_});
    });
  });
}

Exhibition::~Exhibition() = default;

void Exhibition::SetUp() {
  if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
  RELIEVO_NEEDS_PROGRAM("pulseaudio");
  RELIEVO_NEEDS_PROGRAM("pactl");
  speech_ = std::make_unique<test::SpeechDispatcher>();
  ASSERT_TRUE(eventually([this] { return speech_->isListening(); }))
      << speech_->log().toStdString();
  qputenv("SPEECHD_ADDRESS", "unix_socket:" + speech_->socket().toUtf8());
  sound_ = std::make_unique<test::SoundServer>();
  ASSERT_TRUE(eventually([this] { return sound_->isReady(); })) << sound_->log().toStdString();
  sound_->sendTo("ears");
  sound_->record("ears");
  qputenv("PULSE_SERVER", sound_->address());
  writePrograms();
  const fs::path image = path("image.bin").toStdString();
  const std::vector<std::uint8_t> bytes = test::madeImage();
  std::ofstream(image, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  falcon::installFirmware(falcon::readFirmware(image), falcon::firmwarePlaces());
  writeObject();
  writeExhibit();
  // The loader of the program finds the same instance.
  QPluginLoader voice(QStringLiteral(RELIEVO_BINARY_DIR "/plugins/voice_plugin.so"));
  ASSERT_NE(voice.instance(), nullptr) << voice.errorString().toStdString();
  voice.instance()->setProperty("answerMs", 200'000);  // However busy the computer is.
  voice.instance()->setProperty("speakingProgram", QStringList{"sh", path("bin/espeak-ng")});
  falcon_ = std::make_shared<SharedFalcon>(emulator::EmulatorOptions{});
  forces_ = std::make_unique<ForceWatch>(falcon_);
  usb_.plugIn(falcon_);
  attach();
  ASSERT_TRUE(plugins_->has("voice_plugin")) << plugins_->problems().join(' ').toStdString();
  exhibit_ = std::make_unique<ExhibitWindow>(
      window(), host(), *plugins_,
      readExhibit(path("exhibit.json").toStdString(), exhibitLanguages()));
  // A screen's worth of pixels is much for a computer that draws them itself.
  window().showNormal();
  window().resize(480, 360);
}

void Exhibition::TearDown() {
  if (HasFailure()) {
    ADD_FAILURE() << where() << "\nheard:\n" << heard().join('\n').toStdString();
  }
  exhibit_.reset();
  applyLanguage(*qApp, QStringLiteral("en"));
  Journey::TearDown();
}

/// In the places of espeak-ng and of what plays a chime: both write down what they are given.
void Exhibition::writePrograms() {
  QDir(path(QString())).mkdir("bin");
  const auto write = [this](const char* name, const QString& lines) {
    QFile file(path(QLatin1String("bin/") + QLatin1String(name)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("#!/bin/sh\n" + lines.toUtf8());
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  };
  write("espeak-ng", QStringLiteral("text=$(cat)\n[ -e %1 ] && exit 1\n"
                                    "[ -n \"$text\" ] && echo \"$text\" >>%2\nexit 0\n")
                         .arg(path("mute"), path("espeak_said")));
  write("pw-play",
        QStringLiteral("echo chime >>%1\ncp \"$1\" %2\n").arg(path("chimes"), path("chime.wav")));
  qputenv("PATH", path("bin").toUtf8() + ":" + qgetenv("PATH"));
}

/// A project of relief F, in which the dome has a name.
void Exhibition::writeObject() {
  ASSERT_TRUE(QFile::copy(QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply"),
                          path("relief_f.ply")));
  OpenRequest request;
  request.file = path("relief_f.ply");
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  window().open(request);
  ASSERT_TRUE(settled()) << window().message().toStdString();
  Project project = window().project();
  constexpr double kSideMm = 20;
  project.places.push_back(
      {.name = "Dome",
       .region = {kDomeX - kSideMm / 2, kDomeY - kSideMm / 2, kSideMm, project.region.level}});
  writeProject(path("relief.relievo.json").toStdString(), project);
  document().close();
}

void Exhibition::writeExhibit() {
  QFile file(path("exhibit.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"relievo_exhibit": 1, "languages": ["en", "de"], "records": "records",
  "objects": [{"file": "relief.relievo.json", "title": {"en": "A relief", "de": "Ein Relief"}}],
  "idle": {"still_there_s": 30, "goodbye_s": 5, "chime_s": 10},
  "speech": {"volume_percent": 60, "loudest_percent": 80, "room_loudest_percent": 50,
    "words_per_minute": 160},
  "touch": {"device": "falcon", "strength_percent": 40, "limit_n": 4, "introduction": true,
            "guide": true, "sounds_percent": 50},
  "staff_pin": {"salt": "salt", "sha256": ")" +
             QByteArray(64, '0') + "\"}}\n");
}

bool Exhibition::reaches(Visit::State state) {
  return eventually([&] { return visit().state() == state; });
}

QStringList Exhibition::heard() const {
  QStringList all;
  for (const QString& line : speech_->said()) {
    const QString sentence = line.section('|', 3).trimmed();
    if (!isOfAStall(sentence)) all << line.section('|', 0, 0) + '|' + sentence;
  }
  return all + linesOf(path("espeak_said"));
}

QString Exhibition::next(const QString& wanted) {
  for (;;) {
    if (!eventually([&] { return heard().size() > read_; })) return {};
    const QString got = heard().at(read_++);
    if (got == wanted || !got.contains(QStringLiteral("|Bookmark: "))) return got;
  }
}

bool Exhibition::hears(const QString& language, const QStringList& sentences) {
  for (const QString& sentence : sentences) {
    const QString wanted = language.isEmpty() ? sentence : language + '|' + sentence;
    const QString got = next(wanted);
    if (got == wanted) continue;
    ADD_FAILURE() << (got.isEmpty() ? "nothing more" : "heard: " + got.toStdString())
                  << "\ninstead of: " << wanted.toStdString();
    return false;
  }
  return true;
}

bool Exhibition::hearsLength(double mm, double within_mm, const QString& rest) {
  const QString got = next({});
  constexpr double kStepMm = 0.1;  // Finer than the steps of what is said.
  for (double off_mm = -within_mm; off_mm <= within_mm; off_mm += kStepMm) {
    const std::string length = englishText(sayableLength(mm + off_mm));
    if (got == language_ + '|' + QString::fromStdString(length) + rest) return true;
  }
  ADD_FAILURE() << "heard: " << got.toStdString() << "\ninstead of about " << mm << " mm"
                << rest.toStdString();
  return false;
}

bool Exhibition::mayHear(const QString& sentence) {
  const QString wanted = language_ + '|' + sentence;
  const QString got = next(wanted);
  if (got.isEmpty() || got == wanted) return got == wanted;
  --read_;
  return false;
}

double Exhibition::volume() const {
  return speech_->said().isEmpty() ? 0 : speech_->said().last().section('|', 2, 2).toDouble();
}

void Exhibition::forgetHeard() {
  read_ = heard().size();
}

void Exhibition::setButton(std::uint8_t button, bool down) {
  falcon_->with([&](FalconEmulator& f) { f.buttons = down ? 1 << button : 0; });
}

// In a thread of its own: while the window draws, a finger goes up all the same.
void Exhibition::press(std::uint8_t button, int held_ms) {
  std::atomic<bool> is_done = false;
  const std::jthread finger([&] {
    emulator::beUrgentAsADevice();
    setButton(button, true);
    std::this_thread::sleep_for(std::chrono::milliseconds(held_ms));
    setButton(button, false);
    constexpr std::chrono::milliseconds kApart{150};  // A bounce is shorter.
    std::this_thread::sleep_for(kApart);
    is_done = true;
  });
  EXPECT_TRUE(eventually([&] { return is_done.load(); }));
}

bool Exhibition::press(std::uint8_t button, const std::function<bool()>& done, int held_ms) {
  return stalls_.repeatAfterStalls(5, [&] {
    press(button, held_ms);
    return QTest::qWaitFor(done, kPatienceMs);
  });
}

void Exhibition::gripTo(const DeviceMm& at, double z) {
  grip_ = at;
  depth_ = z;
  tremor_.start();
  falcon_->with([&](FalconEmulator& f) { f.body.pullToward({at.x, at.y, z}); });
}

void Exhibition::letGripLie() {
  tremor_.stop();
  falcon_->with([](FalconEmulator& f) { f.body.hold(f.body.grip()); });
}

void Exhibition::handTo(double x_mm, double y_mm, double z) {
  const HandMapping map = handMapping(*document().window());
  const DeviceMm at = map.device_from_view({x_mm, y_mm, 0});
  gripTo({at.x + aside_.x, at.y + aside_.y, 0}, z);
}

bool Exhibition::proxyNear(double x_mm, double y_mm, double within_mm) {
  constexpr int kRestMs = 1500;  // The hand's spring has settled long before.
  constexpr int kStaysMs = 600;
  for (int tries = 0; tries < 20; ++tries) {
    const auto is_near = [&] {
      return probe() && std::hypot(x_mm - probe()->proxy.x, y_mm - probe()->proxy.y) < within_mm;
    };
    if (QTest::qWaitFor(is_near, kRestMs)) {
      QTest::qWait(kStaysMs);  // It does not only pass.
      if (is_near()) return true;
    }
    if (!probe() || probe()->window_id != document().window()->id) continue;
    const double scale = handMapping(*document().window()).device_per_view;
    aside_.x += scale * (x_mm - probe()->proxy.x);
    aside_.y += scale * (y_mm - probe()->proxy.y);
    handTo(x_mm, y_mm, depth_);
  }
  return false;
}

bool Exhibition::lit(int lights) {
  return eventually([&] {
    const auto command = forces_->last();
    return command && command->lights == lights;
  });
}

bool Exhibition::homeGrip() {
  if (!lit(falcon::red)) return false;
  for (const Triple& place : {kFarOut, kFarIn}) {
    falcon_->with([&](FalconEmulator& f) { f.body.hold(place); });
  }
  const bool is_homed = lit(falcon::blue);
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarOut); });
  return is_homed;
}

bool Exhibition::waitsForGrip() {
  return lit(falcon::red) && eventually([this] {
           return health().rfind("device: Please pull") != std::string::npos ||
                  health().rfind("device: Straight out") != std::string::npos;
         });
}

void Exhibition::begin() {
  ASSERT_TRUE(waitsForGrip());
  press(kForward);
  ASSERT_TRUE(reaches(Visit::State::language));
  press(kCentre);
  ASSERT_TRUE(reaches(Visit::State::homing));
  ASSERT_TRUE(homeGrip());
  gripTo({}, kAboveZ);
  ASSERT_TRUE(reaches(Visit::State::introduction));
}

void Exhibition::passOverToTouch() {
  for (int shape = 0; shape < 2; ++shape) press(kForward);
  ASSERT_TRUE(reaches(Visit::State::buttons));
  constexpr int kHeldMs = 1000;
  press(kForward, kHeldMs);
  ASSERT_TRUE(reaches(Visit::State::object));
  press(kForward);
  ASSERT_TRUE(reaches(Visit::State::offer));
  press(kMinus);
  ASSERT_TRUE(reaches(Visit::State::touching));
  ASSERT_TRUE(eventually([this] { return action("forces")->isChecked(); }));
}

bool Exhibition::touch(double x_mm, double y_mm, double z) {
  const auto pushed = [this] {
    return falcon_->with([](FalconEmulator& f) { return f.body.force()[2] > 0.2; }) && probe() &&
           probe()->touching;
  };
  constexpr double kStepMm = 1;
  constexpr int kStepMs = 100;
  return stalls_.repeatAfterStalls(5, [&] {
    handTo(x_mm, y_mm, kAboveZ);
    if (!action("forces")->isChecked()) press(kCentre, 1800);
    if (!QTest::qWaitFor([this] { return probe() && probe()->forces_on; }, kPatienceMs)) {
      return false;
    }
    if (!proxyNear(x_mm, y_mm, kNearMm)) return false;  // Over it ...
    // ... and down only until it is felt: who presses hard slides off a hill.
    for (double depth = kAboveZ; depth >= z && !pushed(); depth -= kStepMm) {
      handTo(x_mm, y_mm, depth);
      QTest::qWait(kStepMs);
    }
    return QTest::qWaitFor(pushed, kPatienceMs) && proxyNear(x_mm, y_mm, kNearMm);
  });
}

std::string Exhibition::health() const {
  std::ifstream in(path("records/health.log").toStdString());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string Exhibition::where() {
  std::string text = "state " + std::to_string(static_cast<int>(visit().state())) + ", caption " +
                     exhibit_->control().caption().text().toStdString();
  if (probe()) {
    text += ", proxy " + std::to_string(probe()->proxy.x) + ", " + std::to_string(probe()->proxy.y);
    text += probe()->touching ? " touching" : "";
  }
  return text + "\nhealth: " + health();
}

}  // namespace relievo
