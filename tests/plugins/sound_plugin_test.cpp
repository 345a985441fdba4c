// SPDX-License-Identifier: BSD-3-Clause
// The sounds of touch in the window: switched on by menu, key or panel, as loud as asked, kept for
// the next start; without a sound server one sentence says so, and forces go on.
#include <QAction>
#include <QCheckBox>
#include <QSpinBox>

#include "core/region/hand.h"
#include "plugins/haptics/sound/sound_control.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using test::eventually;

std::shared_ptr<RegionWindow> plate() {
  return std::make_shared<RegionWindow>(test::windowOf(
      80, [](double x, double) { return 5.0 + 0.1 * x; }, 7));
}

class SoundPluginTest : public test::PluginTest {
 protected:
  void SetUp() override {
    qputenv("PULSE_SERVER", "unix:" + home_.file("no_such_server").toUtf8());
    test::PluginTest::SetUp();
    host_.window = plate();
    attach();
  }
  bool hasSaid(const QString& beginning) {
    return eventually([&] {
      for (const QString& text : host_.announcements) {
        if (text.startsWith(beginning)) return true;
      }
      return false;
    });
  }
};

TEST_F(SoundPluginTest, IsOffAtFirstAndSaysOnceThatThereIsNoServer) {
  QAction* const sound = host_.actions.at("touchSounds");
  EXPECT_FALSE(sound->isChecked());
  Q_EMIT host_.handMoved({handOver(*host_.window, 40, 40, false, 2), true});
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 7 && !p.touching; }));
  host_.actions.at("forces")->trigger();
  sound->trigger();
  EXPECT_TRUE(said("Sounds of touch on."));
  EXPECT_TRUE(hasSaid("There is no sound: "));
  Q_EMIT host_.handMoved({handOver(*host_.window, 40, 40, true, 2), true});
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.touching; })) << "touch goes on";
  const auto times = host_.announcements.filter("There is no sound").size();
  EXPECT_EQ(times, 1);
  sound->trigger();
  EXPECT_TRUE(said("Sounds of touch off."));
}

TEST_F(SoundPluginTest, MenuAndPanelHaveOneSwitchThatIsRemembered) {
  auto* const box = inPanel<QCheckBox>("touchSoundsBox");
  auto* const volume = inPanel<QSpinBox>("touchSoundsVolume");
  QAction* const sound = host_.actions.at("touchSounds");
  box->click();
  EXPECT_TRUE(sound->isChecked());
  EXPECT_TRUE(plugin_->saveState().contains(R"("sound":true)"));
  sound->trigger();
  EXPECT_FALSE(box->isChecked());
  host_.actions.at("soundsLouder")->trigger();
  EXPECT_TRUE(said("Sounds of touch at 60 percent."));
  EXPECT_EQ(volume->value(), 60);
  for (int i = 0; i < 8; ++i) host_.actions.at("soundsQuieter")->trigger();
  EXPECT_TRUE(said("Sounds of touch at 0 percent."));
  EXPECT_EQ(volume->value(), 0);
  host_.announcements.clear();
  plugin_->restoreState(R"({"sound": true, "sound_volume_percent": 250})");
  EXPECT_TRUE(box->isChecked());
  EXPECT_TRUE(sound->isChecked());
  EXPECT_EQ(volume->value(), 100);
  EXPECT_FALSE(host_.announcements.contains("Sounds of touch on.")) << "nobody asked";
}

/// Stands for a sound server: the test asks for frames.
struct StandIn : sound::SoundOut {
  explicit StandIn(sound::RenderFrames frames) : render(std::move(frames)) {}
  State state() const override { return now; }
  std::string problem() const override { return "the cable was pulled"; }
  sound::RenderFrames render;
  State now = State::playing;
};

class SoundControlTest : public ::testing::Test {
 protected:
  SoundControlTest() {
    parts_.actions = addTouchActions(host_);
    device_.open();
    control();
  }
  /// Whose server comes up in that state.
  void control(qint64 retry_ms = SoundControl::kRetryMs) {
    sound_ = std::make_unique<SoundControl>(
        parts_, device_,
        [this](sound::RenderFrames frames) {
          auto out = std::make_unique<StandIn>(std::move(frames));
          out->now = comes_up_;
          out_ = out.get();
          ++opened_;
          return out;
        },
        retry_ms);
  }
  /// Peak of what is heard in that many blocks.
  float heard(int blocks) {
    float peak = 0;
    std::array<sound::Frame, 256> frames{};
    for (int i = 0; i < blocks; ++i) {
      out_->render(frames);
      for (const sound::Frame& f : frames) peak = std::max({peak, std::abs(f.left)});
      QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
      device_.session()->update();
    }
    return peak;
  }
  void hand(const RegionWindow& window, bool presses) {
    device_.session()->moveHand(handOver(window, 40, 40, presses, 2));
  }

  test::PrivateHome home_;
  test::TestHost host_;
  TouchSettings settings_;
  std::string requested_ = kMouseDevice;
  TouchParts parts_{host_, settings_, requested_};
  HandDevice device_{parts_};
  StandIn* out_ = nullptr;
  int opened_ = 0;
  sound::SoundOut::State comes_up_ = sound::SoundOut::State::playing;
  std::unique_ptr<SoundControl> sound_;
};

TEST_F(SoundControlTest, AHandThatTouchesIsHeardAndOneInTheAirIsNot) {
  parts_.actions.sound->trigger();
  ASSERT_EQ(opened_, 1);
  const auto window = plate();
  device_.session()->show(*window, SurfaceKind::crease_aware);
  sound_->takeWindow(*window);
  ASSERT_TRUE(eventually([&] {
    hand(*window, false);
    return device_.session()->update().window_id == 7 && !device_.session()->update().contact;
  }));
  heard(40);  // What was struck on the way here has ended.
  EXPECT_LT(heard(20), 1e-3F);
  EXPECT_TRUE(eventually([&] {
    hand(*window, true);
    return heard(4) > 0.01F;
  }));
  settings_.sound.volume_percent = 0;
  sound_->applySettings(SoundControl::Tell::no);
  heard(40);
  EXPECT_LT(heard(20), 1e-4F);
}

TEST_F(SoundControlTest, AServerThatGoesIsSaidOnceAndTriedAgainWhenSwitchedOn) {
  parts_.actions.sound->trigger();
  EXPECT_TRUE(sound_->isPlaying());
  sound_->watch();
  out_->now = sound::SoundOut::State::gone;
  sound_->watch();
  sound_->watch();
  EXPECT_EQ(host_.announcements.filter("the cable was pulled").size(), 1);
  EXPECT_FALSE(sound_->isPlaying());
  EXPECT_TRUE(parts_.actions.sound->isChecked()) << "the setting stays on";
  parts_.actions.sound->trigger();
  parts_.actions.sound->trigger();
  EXPECT_EQ(opened_, 2);
  EXPECT_TRUE(sound_->isPlaying());
}

TEST_F(SoundControlTest, AServerThatGoesIsTriedAgainWithoutAWordUntilItIsBack) {
  control(0);  // At once.
  parts_.actions.sound->trigger();
  const auto times_on = [this] { return host_.announcements.filter("Sounds of touch on.").size(); };
  EXPECT_EQ(times_on(), 1);
  out_->now = comes_up_ = sound::SoundOut::State::gone;
  for (int i = 0; i < 5; ++i) sound_->watch();
  EXPECT_EQ(opened_, 5) << "the first, and one with each look after it had gone";
  EXPECT_EQ(host_.announcements.filter("There is no sound").size(), 1);
  comes_up_ = sound::SoundOut::State::opening;
  sound_->watch();
  EXPECT_EQ(times_on(), 1) << "it is not back yet";
  out_->now = sound::SoundOut::State::playing;
  sound_->watch();
  sound_->watch();
  EXPECT_TRUE(sound_->isPlaying());
  EXPECT_EQ(times_on(), 2);
  EXPECT_EQ(opened_, 6);
  // It goes once more, and that is said once more; switched off, it is not tried.
  out_->now = comes_up_ = sound::SoundOut::State::gone;
  sound_->watch();
  EXPECT_EQ(host_.announcements.filter("There is no sound").size(), 2);
  parts_.actions.sound->trigger();
  sound_->watch();
  EXPECT_EQ(opened_, 6);
}

TEST_F(SoundControlTest, AServerThatGoesIsLeftAloneForAWhile) {
  parts_.actions.sound->trigger();
  out_->now = comes_up_ = sound::SoundOut::State::gone;
  sound_->watch();
  sound_->watch();
  device_.change();
  EXPECT_EQ(opened_, 1) << "five seconds are not over";
}

TEST_F(SoundControlTest, AnotherDeviceIsHeardAsWell) {
  parts_.actions.sound->trigger();
  device_.change();
  EXPECT_EQ(opened_, 2);
  EXPECT_TRUE(sound_->isPlaying());
  const std::uint64_t before = device_.session()->update().tick;
  EXPECT_TRUE(eventually([&] {
    heard(1);
    return device_.session()->update().tick > before;
  }));
}

}  // namespace
}  // namespace relievo
