// SPDX-License-Identifier: BSD-3-Clause
// The state of the work is one value: a random walk of edits through the real panels.
#include <functional>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <random>
#include <set>

#include "tests/ui/gui_fixture.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"

namespace relievo {
namespace {

constexpr int kEdits = 200;

class StateWalk : public GuiTest {
 protected:
  /// One of `count` numbers from 0.
  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  template <class T>
  const T& oneOf(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(any(static_cast<int>(all.size())))];
  }
  void run(const std::string& command) { window().runCommand(QString::fromStdString(command)); }
  void spin(const char* name, double low, double high) {
    child<QDoubleSpinBox>(name)->setValue(between(low, high));
  }
  void slide(const char* name) {
    auto* slider = child<QSlider>(name);
    slider->setValue(slider->minimum() + any(slider->maximum() - slider->minimum() + 1));
  }
  void toggle(const char* name) { child<QCheckBox>(name)->toggle(); }
  void click(const char* name) { child<QPushButton>(name)->click(); }
  void choose(const char* name) {
    auto* box = child<QComboBox>(name);
    const int index = any(box->count());
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);  // As a click in the list says.
  }
  bool settled() {
    return waitFor([this] { return !document().loader().busy(); });
  }

  void moveTheWindow() {
    const std::vector<std::function<void()>> ways{
        [this] { run("finer"); },
        [this] { run("coarser"); },
        [this] { run("whole"); },
        [this] { spin("region_x", 0, 150); },
        [this] { spin("region_y", 0, 100); },
        [this] { spin("region_side", 10, 150); },
        [this] { choose("region_level"); },
        [this] {
          document().region().zoomTo({between(0, 90), between(0, 90), 40, {any(3)}});
        },
        [this] { spin("gain", 0.3, 3); },
        [this] { slide("gain_slider"); },
        [this] {  // Dragged: many states, one step.
          auto* gain = child<QSlider>("gain_slider");
          gain->setSliderDown(true);
          slide("gain_slider");
          slide("gain_slider");
          gain->setSliderDown(false);
        }};
    oneOf(ways)();
  }

  void lookOtherwise() {
    const std::vector<std::function<void()>> ways{
        [this] { slide("light_azimuth"); },
        [this] { slide("light_elevation"); },
        [this] {
          run("relief_" + std::string(kReliefKindNames[static_cast<std::size_t>(any(8))]));
        },
        [this] { run("relief_natural"); },  // Which this scan does not have.
        [this] {
          run("colours_" + std::string(kColourMapNames[static_cast<std::size_t>(any(4))]));
        },
        [this] { run("show_unmeasured"); },
        [this] { run("turn_left"); },
        [this] { click("straighten"); },
        [this] { run("stereo"); },
        [this] { toggle("stereo_on"); },
        [this] { choose("stereo_kind"); },
        [this] { toggle("stereo_automatic"); },
        [this] { toggle("stereo_comfort"); },
        [this] { toggle("stereo_swap"); },
        [this] { toggle("zero_plane_auto"); },
        [this] { spin("zero_plane", 0, 20); },
        [this] { spin("eye_angle", 0.5, 60); }};
    oneOf(ways)();
  }

  void nameAPlace() {
    auto* list = child<QListWidget>("places_list");
    const int places = list->count();
    const std::vector<std::function<void()>> ways{
        [this] { click("place_add"); },
        [this] { toggle("places_with_view"), click("place_add"); },
        [this] { run("beacon"); },
        [this] { run("next_place"); },
        [&] { list->setCurrentRow(any(places + 1) - 1), click("place_go"); },
        [&] { list->setCurrentRow(any(places + 1) - 1), click("place_delete"); },
        [&] {
          if (places > 0) list->item(any(places))->setText(QString("nose %1").arg(any(1000)));
        }};
    oneOf(ways)();
  }

  void measureSomething() {
    auto* list = child<QTableWidget>("measure_list");
    const int rows = list->rowCount();
    const auto make = [this](const std::string& kind, int places) {
      run("measure_" + kind);
      for (int i = 0; i < places; ++i) {
        Q_EMIT window().detailView().picked(between(20, 180), between(20, 180));
      }
      Q_EMIT window().detailView().pickingEnded();
    };
    const std::vector<std::function<void()>> ways{
        [&] { make("point", 1); },
        [&] { make("depth", 2); },
        [&] { make("profile", 3); },
        [&] { make("area", 3); },
        [&] { make("section", 1 + any(3)); },
        [&] { list->setCurrentCell(any(rows + 1) - 1, 0), click("measure_delete"); },
        [&] { list->setCurrentCell(any(rows + 1) - 1, 0), spin("measure_plane", 0, 20); },
        [&] {
          if (rows > 0) list->item(any(rows), 0)->setText(QString("step %1").arg(any(1000)));
        }};
    oneOf(ways)();
  }

  void makeItAnew() {
    if (any(2) == 0) {
      choose("unit");
    } else {
      click(oneOf(std::vector<const char*>{"view_top", "view_bottom", "view_left"}));
    }
  }

  void step() {
    const int what = any(100);
    if (what < 30) return moveTheWindow();
    if (what < 52) return lookOtherwise();
    if (what < 57) return window().detailView().turnBy(between(-40, 40), between(-30, 30));
    if (what < 70) return nameAPlace();
    if (what < 82) return measureSomething();
    if (what < 85) return makeItAnew();
    if (what < 88) return run(any(3) > 0 ? "key_view" : "path_clear");
    return run(any(3) > 0 ? "undo" : "redo");
  }

  /// What the value says stands in panels and views.
  void expectItIsShown() {
    const Project& p = document().project();
    const SceneState& scene = window().detailView().sceneState();
    ReliefLook look = scene.look;
    look.light = scene.light;
    EXPECT_EQ(look, p.look);
    EXPECT_EQ(scene.stereo, p.stereo);
    EXPECT_EQ(scene.camera.azimuth_deg, p.azimuth_deg);
    EXPECT_EQ(scene.camera.elevation_deg, p.elevation_deg);
    EXPECT_EQ(scene.camera.rect.x_mm, p.region.x_mm);
    EXPECT_EQ(document().window()->region, p.region);
    EXPECT_EQ(document().window()->gain, p.gain);
    EXPECT_EQ(child<QSlider>("light_azimuth")->value(), std::lround(p.look.light.azimuth_deg));
    EXPECT_EQ(child<QCheckBox>("stereo_on")->isChecked(), p.stereo.mode != StereoMode::off);
    EXPECT_EQ(child<QCheckBox>("stereo_swap")->isChecked(), p.stereo.swap_eyes);
    EXPECT_EQ(child<QComboBox>("region_level")->currentData().toInt(), p.region.level.value);
    auto* places = child<QListWidget>("places_list");
    ASSERT_EQ(places->count(), static_cast<int>(p.places.size()));
    for (int i = 0; i < places->count(); ++i) {
      EXPECT_EQ(places->item(i)->text().toStdString(), p.places[static_cast<std::size_t>(i)].name);
    }
    auto* measured = child<QTableWidget>("measure_list");
    ASSERT_EQ(measured->rowCount(), static_cast<int>(p.measurements.size()));
    for (int i = 0; i < measured->rowCount(); ++i) {
      EXPECT_EQ(measured->item(i, 0)->text().toStdString(),
                p.measurements[static_cast<std::size_t>(i)].name);
    }
  }

  /// What the walk has come by: edits that do nothing would keep every promise below.
  struct Seen {
    std::set<ReliefKind> kinds;
    std::set<StereoMode> modes;
    std::set<std::string> units;
    std::size_t places = 0, views = 0, measurements = 0, keys = 0;
    bool turned = false, limited = false, gain = false;
  };
  void note() {
    const Project& p = document().project();
    seen_.kinds.insert(p.look.kind);
    seen_.modes.insert(p.stereo.mode);
    seen_.units.insert(std::string(name(document().surface()->unit)));
    seen_.places = std::max(seen_.places, p.places.size());
    for (const NamedRegion& place : p.places) seen_.views += place.view ? 1 : 0;
    seen_.measurements = std::max(seen_.measurements, p.measurements.size());
    if (!p.paths.empty()) seen_.keys = std::max(seen_.keys, p.paths.front().keys.size());
    seen_.turned = seen_.turned || p.azimuth_deg != 0;
    seen_.limited = seen_.limited || p.chosen_eye_angle_deg.has_value();
    seen_.gain = seen_.gain || p.gain != 1;
  }
  void expectTheWalkWentFar() const {
    EXPECT_GE(seen_.kinds.size(), 3U);
    EXPECT_GE(seen_.modes.size(), 2U);
    EXPECT_GE(seen_.units.size(), 2U);
    EXPECT_GE(seen_.places, 2U);
    EXPECT_GE(seen_.views, 1U);
    EXPECT_GE(seen_.measurements, 2U);
    EXPECT_GE(seen_.keys, 1U);
    EXPECT_TRUE(seen_.turned);
    EXPECT_TRUE(seen_.limited);
    EXPECT_TRUE(seen_.gain);
  }

  void expectItIsOneValue() {
    const Project& p = document().project();
    const std::string json = projectJson(p);
    const Project back = projectFromJson(json, "walk");
    EXPECT_TRUE(back == p) << json << "\n" << projectJson(back);
    expectItIsShown();
  }

  Seen seen_;
  std::mt19937 random_{20261123};  // NOLINT(cert-msc51-cpp): the same walk in every run.
};

/// Without what belongs to no step.
Project ofSteps(Project p) {
  p.azimuth_deg = p.elevation_deg = 0;
  p.paths.clear();
  return p;
}

TEST_F(StateWalk, AfterEveryEditTheStateIsOneValueAndUndoAndRedoBringItBack) {
  openRelief();
  const Project start = document().project();
  for (int i = 0; i < kEdits; ++i) {
    step();
    ASSERT_TRUE(settled());
    expectItIsOneValue();
    note();
    ASSERT_FALSE(HasFailure()) << "edit " << i << ": "
                               << document().history().undoText().toStdString();
  }
  QUndoStack& history = document().history();
  while (history.canRedo()) history.redo();
  expectTheWalkWentFar();
  ASSERT_LT(history.count(), 250) << "nothing has left the history";
  QApplication::processEvents();
  const Project end = document().project();
  while (history.canUndo()) history.undo();
  EXPECT_EQ(projectJson(ofSteps(document().project())), projectJson(ofSteps(start)));
  EXPECT_TRUE(ofSteps(document().project()) == ofSteps(start));
  expectItIsOneValue();
  while (history.canRedo()) history.redo();
  EXPECT_EQ(projectJson(document().project()), projectJson(end));
  EXPECT_TRUE(document().project() == end);
  expectItIsOneValue();
}

TEST_F(StateWalk, WhatIsSavedIsTheValueAndComesBack) {
  openRelief();
  for (int i = 0; i < kEdits / 4; ++i) {
    step();
    ASSERT_TRUE(settled());
  }
  const QString file = path("walk.relievo.json");
  window().saveProject(file);
  EXPECT_FALSE(window().hasUnsavedWork());
  Project saved = document().stored();
  EXPECT_TRUE(readProject(file.toStdString()) == saved);
  restart();
  window().open(file);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  Project back = document().project();
  EXPECT_FALSE(window().hasUnsavedWork());
  // What a view draws of the depth that was chosen is its own, by its size.
  for (Project* p : {&back, &saved}) p->stereo = chosenStereo(*p), p->chosen_eye_angle_deg.reset();
  EXPECT_EQ(ofSteps(back).places, ofSteps(saved).places);
  // Names of steps without a window of their own come before the others.
  back.history.clear();
  saved.history.clear();
  EXPECT_EQ(projectJson(back), projectJson(saved));
}

}  // namespace
}  // namespace relievo
