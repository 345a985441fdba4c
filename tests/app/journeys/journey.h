// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "core/region/probe.h"
#include "tests/ui/gui_fixture.h"

class QComboBox;
class QDialog;
class QDoubleSpinBox;
class QImage;

namespace relievo {

/// A window with its plugins, a home of its own, and a picture of each step in screenshots/ of the
/// build folder.
class Journey : public GuiTest {
 protected:
  /// @param name  what its pictures begin with
  explicit Journey(std::string name);
  ~Journey() override;
  void TearDown() override;

  /// Host, plugins and reader of recordings, as the program has them.
  void attach();
  void detach();

  /// Minutes: what happens is tested here, not how fast.
  static bool eventually(const std::function<bool()>& holds);
  /// So long, then a person tries again.
  static bool soon(const std::function<bool()>& holds);
  /// Nothing is being opened or made.
  bool settled();
  DetailView& detail() { return window().detailView(); }
  ReferenceView& reference() { return window().referenceView(); }
  const std::optional<Probe>& probe() { return detail().sceneState().probe; }
  /// The newest line of the status bar.
  QString said();
  /// Waits until a plug-in has announced it, since this was last asked: another sentence may take
  /// its place in the status bar at once.
  bool hears(const QString& words);
  /// Of the status bar, N; 0 if no force is shown.
  double forceShown();

  /// Point of the untilted detail view over a place.
  QPointF over(double x_mm, double y_mm);
  /// By arrows of the detail view, to within half a cell of a place of the window.
  void carryHand(double x_mm, double y_mm);
  /// A key of the detail view. Without a window manager nobody makes the window active again.
  void key(int key, Qt::KeyboardModifiers with = {});
  /// Chooses an entry, and types a number, as a user does by keys: the field tells of it.
  static void choose(QComboBox& box, int index);
  static void type(QDoubleSpinBox& box, const QString& number);
  /// The dialog of this type that is on show; null: none.
  template <class Dialog>
  Dialog* shown() {
    for (auto* dialog : window().findChildren<Dialog*>()) {
      if (dialog->isVisible()) return dialog;
    }
    return nullptr;
  }
  void drop(const QString& file);

  /// A file in screenshots/, "u1_touch.csv".
  QString kept(const QString& file) const;
  void picture(const QString& step) { picture(window(), step); }
  void picture(QWidget& of, const QString& step) const;
  /// Files that were recorded, the newest last.
  std::vector<std::filesystem::path> recordings() const;

  std::unique_ptr<PluginLoader> plugins_;
  WindowHost& host();

 private:
  class HearingHost;

  std::string name_;
  std::unique_ptr<HearingHost> host_;
};

/// Of any channel of any pixel; 255 where the sizes differ.
int largestDifference(const QImage& a, const QImage& b);

}  // namespace relievo
