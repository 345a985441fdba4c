// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>

#include "tests/ui/gui_fixture.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/views/cloud_view.h"

class QTreeWidget;

namespace relievo {

/// The dialog Prepare over the window of GuiTest.
class PrepareGuiTest : public GuiTest {
 protected:
  /// Of what is open; waits until the scan is shown.
  PrepareDialog& openDialog();
  /// Of several files; waits until all are shown.
  PrepareDialog& openTogether(const QStringList& files);
  /// Brings the cross of a view with a tool to a pixel by arrow keys.
  static void carryCross(CloudView& view, const QPointF& to);
  /// The dialog there is, which becomes the active window.
  PrepareDialog& dialog();

  /// Chooses an entry of "Add step" by its name.
  static void addStep(PrepareDialog& dialog, const char* entry);
  static void setNumber(PrepareDialog& dialog, const char* field, double value);
  static void choose(PrepareDialog& dialog, const char* box, int index);
  static void click(PrepareDialog& dialog, const char* button);
  static void accept(PrepareDialog& dialog) { click(dialog, "prepare_ok"); }
  static QString label(PrepareDialog& dialog, const char* name);
  static QTreeWidget& tree(PrepareDialog& dialog, const char* name);
  static CloudView& cloudView(PrepareDialog& dialog, const char* name = "prepare_cloud");
  static bool isShown(PrepareDialog& dialog);  ///< Waits until all work is done.

  /// How a scanner's coordinates lie: turned about z, then moved.
  struct BodyPlace {
    double turned_deg = 0;
    std::array<double, 3> moved{};
  };
  /// A place on a closed body without symmetry, about 80 mm large.
  /// @param z  of the direction from its middle, [-1, 1]
  static std::array<double, 3> onBody(double azimuth_deg, double z);
  static FilePoint laid(const std::array<double, 3>& p, const BodyPlace& place);
  /// Points of it with directions up to `open_deg` from `azimuth_deg`; in mm.
  QString writeBody(const QString& name, double azimuth_deg, double open_deg,
                    const BodyPlace& place) const;
  /// 80 x 80 points on z = 0, 0.5 mm apart, from this x: it slides on itself.
  QString writePlate(const QString& name, double from_x) const;

 private:
  QString writePoints(const QString& name, int count, const QByteArray& floats) const;
};

}  // namespace relievo
