// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QWidget>

#include "core/measure/measure.h"
#include "core/measure/touch_marks.h"
#include "ui/panels/measure_readings.h"
#include "ui/views/overlays/view_labels.h"
#include "ui/work/document.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace relievo {

/// The document's measurements with what each reads on the present map; and the one being made,
/// place by place. [GUI thread]
class MeasurePanel : public QWidget {
  Q_OBJECT
 public:
  explicit MeasurePanel(Document& document, QWidget* parent = nullptr);

  const std::vector<Measurement>& measurements() const { return document_.project().measurements; }
  void setMeasurements(std::vector<Measurement> measurements);

  /// Starts one; places are then added until there are enough, or until finish().
  void begin(MeasureKind kind);
  bool measuring() const { return making_.has_value(); }
  void addPlace(double x_mm, double y_mm);
  /// From now on taps of the hand that feels the surface give places, two of them a depth
  /// difference, and strokes profiles; until cancel(). While a section is being made its places can
  /// be tapped, too.
  void beginByTouch();
  bool byTouch() const { return by_touch_; }
  /// Where the proxy is now; does nothing unless taps give places.
  void follow(const TouchSample& sample);
  /// Ends a profile, an area or a section; does nothing for the others.
  void finish();
  void cancel();

  /// Of an area or a section; others have no plane.
  void setPlane(int row, double plane_mm);

  /// The list as core/measure/measure_text writes it, for this file.
  /// @throw ArgumentError  one of them is still being read
  QString csv(const QString& file) const;
  /// Heights along the profile that is selected, or the curves of the section, as CSV or SVG.
  /// @throw ArgumentError, WriteError
  void writeSelected(const QString& file) const;
  /// The same of any profile or section in the list.
  void writeRow(int row, const QString& file) const;
  /// A drawing of one of them, with the state that it was measured on.
  void writeDrawing(const std::string& svg, const QString& file) const;

  /// The profile whose curve is shown: the selected one, else the last; nothing: there is none.
  std::optional<int> shownProfile() const;
  /// Empty while it is being read, or could not be read.
  std::vector<ProfileRow> profileRows(int row) const;

 Q_SIGNALS:
  void changed();  ///< Of what is to be drawn.
  void said(const QString& text);
  void saveAsked();

 public:
  /// Lines through the surface, for the views; the one being made is the last. Sections have none.
  std::vector<std::vector<ViewMm>> lines() const;
  /// The sections' curves, for the views.
  std::vector<std::vector<ViewMm>> curves() const;
  /// What each of them reads, beside it.
  std::vector<ViewLabel> labels() const;

 private:
  using Measurements = std::vector<Measurement>;
  /// Asks for the edit; what is being made goes on.
  void change(const std::function<void(Measurements&)>& change);
  void showOthers();
  void showList();
  void showReadings();
  std::string stateFor(const QString& file) const;
  QString sourceText(const QString& file) const;
  QString readingText(const Measurement& m) const;
  std::shared_ptr<const MeasureReadings::Entry> readEntry(const Measurement& m) const;
  void rename(int row, const QString& name);
  void removeSelected();
  void start(MeasureKind kind, bool by_touch);
  void keep(Measurement done);
  void keepArea();
  void keepSection();
  /// Says why the last place cannot be, and takes it back.
  void takeBack(const QString& why);
  void makePlaneRow();
  void showPlane();
  void tellNext();
  std::optional<int> selected() const;

  Document& document_;
  double shown_gain_ = 1;  ///< Of what lies in the views.
  std::optional<Measurement> making_;
  bool by_touch_ = false;
  bool tell_last_ = false;  ///< What the last one reads is said as soon as it is known.
  MeasureReadings* readings_;
  TouchMarks touched_;
  QLabel* hint_;
  QTableWidget* list_;
  QPushButton *remove_, *save_;
  QWidget* plane_row_;
  QLabel* plane_label_;
  QDoubleSpinBox* plane_;
  bool showing_ = false, asking_ = false, renaming_ = false;
};

}  // namespace relievo
