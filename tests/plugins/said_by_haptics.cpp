// SPDX-License-Identifier: BSD-3-Clause
#include "tests/plugins/said_by_haptics.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <QTemporaryDir>
#include <system_error>

#include "core/base/error.h"
#include "core/base/origin.h"
#include "haptics/commands/button_commands.h"
#include "haptics/device/falcon/calibration.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/presence.h"
#include "haptics/device/falcon/self_test.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device_catalog.h"
#include "tests/emulator/ordinary_account.h"
#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;
using falcon::Calibration;
using falcon::LinkState;
using falcon::SelfTest;

/// @return why
template <class Work>
std::string refused(SaidByHaptics& said, const Work& work) {
  try {
    work();
    ADD_FAILURE() << "nothing was refused";
    return {};
  } catch (const Error& error) {
    return *said.sentences.insert(error.what()).first;
  }
}

void sayCommandsFaultsAndOrigins(SaidByHaptics& said) {
  for (int i = 1; i <= static_cast<int>(ButtonCommand::restart_introduction); ++i) {
    said.sentences.emplace(commandWords(static_cast<ButtonCommand>(i)));
  }
  for (const bool one_button : {false, true}) {
    ButtonCommands commands({.one_button = one_button});
    said.sentences.emplace(commands.help());
    commands.toggleMoving();
    said.sentences.emplace(commands.help());
  }
  for (int i = 1; i <= static_cast<int>(DeviceFault::not_ready); ++i) {
    said.sentences.emplace(describe(static_cast<DeviceFault>(i)));
  }
  for (const std::string_view origin : kOriginNames) {
    if (origin != name(Origin::measured)) said.sentences.emplace(origin);
  }
}

void say(SaidByHaptics& said, const falcon::LinkStatus& status) {
  const falcon::LinkMessage message = falcon::describe(status);
  said.sentences.insert(message.spoken);
  // The states that say nothing but a detail are brought about below, with theirs.
  if (!message.screen.empty()) said.sentences.insert(message.screen);
}

void sayStates(SaidByHaptics& said) {
  for (int i = 0; i <= static_cast<int>(LinkState::silent); ++i) {
    falcon::LinkStatus status;
    status.state = static_cast<LinkState>(i);
    status.attempts = 10;
    constexpr std::string_view kOthers = "B2 (USB 1-3)";
    kOthers.copy(status.others.data(), status.others.size() - 1);
    said.names.emplace(kOthers);
    say(said, status);
    status.failed_openings = 3;
    say(said, status);
    status.failed_openings = 0;
    status.attempt = 4;
    status.unplugged = 1;
    status.homed = 0b010;
    say(said, status);
    status.homing_is_long = true;
    status.others.fill('\0');
    if (status.state != LinkState::several) say(said, status);  // Never without their names.
  }
  falcon::Opening opening;
  for (const std::string others : {"", "B2 (USB 1-3)"}) {
    opening.wanted = "Falcon A1";
    said.names.insert(opening.wanted);
    opening.others = others;
    say(said, falcon::statusOf(opening));
  }
  opening.presence = falcon::Presence::broken;
  opening.detail = "Input/Output Error";  // libusb's.
  said.names.insert(opening.detail);
  said.sentences.insert(falcon::describe(opening).screen);
}

/// The driver and the emulated Falcon outside of a test of their own.
class StartingFalcon : public falcon::test::FalconTest {
 public:
  explicit StartingFalcon(emulator::EmulatorOptions options) : FalconTest(options) {}
  void TestBody() override {}
  std::string failure(emulator::Troubles troubles) {
    falcon([&](auto& f) { f.troubles = troubles; });
    begin();
    EXPECT_TRUE(becomes(LinkState::not_started, 200'000));
    return falcon::describe(device_->status()).screen;
  }
};

void sayFailuresToStart(SaidByHaptics& said) {
  constexpr std::int64_t kNeverNs = 1'000'000'000'000'000;
  const auto failure = [&](emulator::EmulatorOptions options, emulator::Troubles troubles) {
    said.sentences.insert(StartingFalcon(options).failure(troubles));
  };
  failure({}, {.deaf_hellos = 1'000'000});
  failure({.clear_to_send_delay_ns = kNeverNs}, {});
  failure({}, {.wrong_echoes = 1000});
  failure({.start_delay_ns = kNeverNs}, {});
}

class ReadyFalcon : public falcon::test::RunningFalconTest {
 public:
  explicit ReadyFalcon(SaidByHaptics& said) : said_(said) {
    loop_runs_ = false;
    hold(0, 0, 125);
    begin();
    EXPECT_TRUE(becomes(LinkState::ready, 100));
  }
  void TestBody() override {}

  template <class EachMs>
  void test(const EachMs& each_ms) {
    SelfTest test(*device_, {.wait_for_person_s = 2});
    for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
      said_.sentences.insert(test.prompt());
      falcon([&](auto& f) { each_ms(f, test.phase(), ms); });
      step();
    }
    ASSERT_EQ(test.phase(), SelfTest::Phase::done);
    said_.sentences.insert(test.prompt());
    for (const falcon::SelfTestLine& line : test.lines()) said_.sentences.insert(line.text);
  }

  template <class EachMs>
  void calibrate(double weight_g, const EachMs& each_ms) {
    constexpr double kTrueGain = 6, kGripN = 0.3, kNPerGram = 9.80665e-3;
    falcon([](auto& f) {
      f.body.counts_per_n_mm = kTrueGain;
      f.body.letGo(kGripN);
    });
    Calibration calibration(*device_, kTrueGain, 100);
    for (int ms = 0; ms < 90'000 && calibration.step(clock_->now()); ++ms) {
      said_.sentences.insert(calibration.prompt());
      falcon([&](auto& f) { each_ms(f, ms); });
      step();
      if (calibration.phase() != Calibration::Phase::hang_weight) continue;
      said_.sentences.insert(calibration.prompt());
      falcon([&](auto& f) { f.body.letGo(kGripN + kNPerGram * weight_g); });
      calibration.weightHangs();
    }
    ASSERT_GE(calibration.phase(), Calibration::Phase::done);
    said_.sentences.insert(calibration.prompt());
  }
  void calibrateWithTooLittle() {
    constexpr double kWeightG = 5;
    refused(said_, [this] { Calibration(*device_, falcon::kNominalCountsPerNmm, kWeightG); });
  }

 private:
  SaidByHaptics& said_;
};

void saySelfTest(SaidByHaptics& said) {
  using Phase = SelfTest::Phase;
  ReadyFalcon(said).test([](auto& f, Phase phase, int ms) {  // All is well, and somebody helps.
    if (ms == 0) f.body.pullToward({0, 0, 125});
    if (phase != Phase::person) return;
    f.buttons = 1 << (ms / 50 % 4);
    f.body.carry({0, 0, 110.0 + ms % 40});
  });
  ReadyFalcon(said).test([](auto& /*falcon*/, Phase, int) {});  // A hand that holds still.
  ReadyFalcon(said).test([](auto& f, Phase phase, int) {        // It only presses.
    if (phase == Phase::person) f.buttons = 0b1111;
  });
  ReadyFalcon(said).test([](auto& f, Phase, int ms) {
    if (ms == 100) f.unplug();
  });
}

void sayCalibration(SaidByHaptics& said) {
  ReadyFalcon(said).calibrate(100, [](auto& /*falcon*/, int) {});
  ReadyFalcon(said).calibrate(0, [](auto& /*falcon*/, int) {});
  ReadyFalcon(said).calibrate(100, [](auto& f, int ms) {
    if (ms % 40 == 0) f.troubles.lose_answer_bytes = 1;
  });
  ReadyFalcon(said).calibrate(100, [](auto& f, int ms) {  // A hand that swings it.
    f.body.carry({0, ms / 400 % 2 == 0 ? 6.0 : -6.0, 125});
  });
  ReadyFalcon(said).calibrate(100, [](auto& f, int ms) {
    if (ms == 100) f.unplug();
  });
  ReadyFalcon(said).calibrateWithTooLittle();
}

/// Files of a folder of its own; their names are names.
class FirmwareMistakes {
 public:
  explicit FirmwareMistakes(SaidByHaptics& said) : said_(said) {
    places_.data_home = file("home");
    places_.system = {file("local"), file("share")};
    fs::create_directory(places_.data_home);
  }

  void read() {
    std::vector<std::uint8_t> image = madeImage({1200, 7, 900});
    reading(file("missing"));
    reading(folder_);
    reading(written("big", std::vector<std::uint8_t>(70'000)));
    reading(written("small", {1, 2, 3}));
    image.push_back(0);
    reading(written("odd", image));
    image.push_back(0);
    reading(written("long", image));
    image.resize(image.size() - 4);
    reading(written("cut", image));
    image[0] = 0;
    reading(written("foreign", image));
    reading(named("/proc/self/mem"));  // Nothing is at address 0.
    const fs::path secret = written("secret", madeImage());
    fs::permissions(secret, fs::perms::none);
    said_.names.insert(std::generic_category().message(EACCES));
    asOrdinaryAccount([&] { reading(secret); });
  }

  void find() {
    finding();
    places_.environment = file("nowhere");
    finding();
    places_.environment = file("home");
    finding();
    places_.environment = written("wrong", {1, 2, 3});
    finding();
    places_.setting = file("small");
    finding();
    places_.setting = written("unknown", madeImage());
    said_.names.insert(falcon::readFirmware(places_.setting).sha256);
    finding();
  }

  void keep() {
    const falcon::Firmware firmware = falcon::readFirmware(file("unknown"));
    const fs::path place = named(places_.data_home / "nvent_firmware.bin");
    const auto refusedAsItIs = [&] {
      refused(said_, [&] { falcon::installFirmware(firmware, places_); });
      fs::remove(place);
    };
    fs::create_directory(place);
    refusedAsItIs();
    fs::create_symlink(place.filename(), place);
    refusedAsItIs();
    fs::copy_file(file("unknown"), place);
    fs::permissions(place, fs::perms::owner_read);
    refusedAsItIs();
    refused(said_, [&] { falcon::writeSettings({}, named("/dev/null/falcon.conf")); });
  }

 private:
  fs::path named(const fs::path& path) {
    said_.names.insert(path.string());
    return path;
  }
  fs::path file(const std::string& name) { return named(folder_ / name); }
  fs::path written(const std::string& name, const std::vector<std::uint8_t>& bytes) {
    std::ofstream stream(folder_ / name, std::ios::binary);
    for (const std::uint8_t byte : bytes) stream.put(static_cast<char>(byte));
    return file(name);
  }
  void reading(const fs::path& path) {
    refused(said_, [&] { falcon::readFirmware(path); });
  }
  void finding() {
    refused(said_, [this] { falcon::findFirmware(places_); });
  }

  SaidByHaptics& said_;
  const QTemporaryDir temporary_;
  const fs::path folder_ = named(temporary_.path().toStdString());
  falcon::FirmwarePlaces places_;
};

/// Neither a file nor a thread can be had while it lives.
class Scarcity {
 public:
  Scarcity() {
    getrlimit(RLIMIT_NOFILE, &files_);
    const rlimit none{.rlim_cur = 0, .rlim_max = files_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    pthread_getattr_default_np(&threads_);
    pthread_attr_t huge = threads_;
    pthread_attr_setstacksize(&huge, std::size_t{1} << 50U);
    EXPECT_EQ(pthread_setattr_default_np(&huge), 0);
  }
  ~Scarcity() {
    setrlimit(RLIMIT_NOFILE, &files_);
    pthread_setattr_default_np(&threads_);
  }
  Scarcity(const Scarcity&) = delete;
  Scarcity& operator=(const Scarcity&) = delete;

 private:
  rlimit files_{};
  pthread_attr_t threads_{};
};

void sayDevicesThatCannotBeHad(SaidByHaptics& said) {
  refused(said, [] { makeDevice("falcon:A9@"); });
  said.names.insert("falcon:A9@");
  auto bus = std::make_unique<emulator::InProcessBus>(std::make_shared<emulator::SharedFalcon>(),
                                                      std::make_shared<emulator::TestClock>());
  falcon::FalconDevice device(std::move(bus), [] { return madeImage(); });
  const Scarcity scarcity;
  refused(said, [&] { device.openWhenPlugged(); });
  said.names.insert(std::generic_category().message(EAGAIN));
  const std::string usb = refused(said, [] { falcon::UsbBus(); });
  const std::size_t reason = usb.find(": ") + 2;  // libusb's.
  said.names.insert(usb.substr(reason, usb.size() - 1 - reason));
}

}  // namespace

SaidByHaptics saidByHaptics() {
  SaidByHaptics said;
  sayCommandsFaultsAndOrigins(said);
  sayStates(said);
  sayFailuresToStart(said);
  saySelfTest(said);
  sayCalibration(said);
  FirmwareMistakes firmware(said);
  firmware.read();
  firmware.find();
  firmware.keep();
  sayDevicesThatCannotBeHad(said);
  return said;
}

}  // namespace relievo::test
