// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "core/prepare/recipe.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace relievo {

/// The fields of one step, of whichever kind. [GUI thread]
class StepForm : public QWidget {
  Q_OBJECT
 public:
  explicit StepForm(QWidget* parent = nullptr);

  /// @param step  nothing: none is chosen
  void show(const Step* step);

 Q_SIGNALS:
  void changed(const relievo::Step& step);
  void outlineAsked();  ///< To be drawn on the view.

 private:
  void clear();
  void fill(const CropBox& step);
  void fill(const CropOutline& step);
  void fill(const Classes& step);
  void fill(const Returns& step);
  void fill(const Intensities& step);
  void fill(const Duplicates& step);
  void fill(const Outliers& step);
  void fill(const Lonely& step);
  void fill(const Sparse& step);
  void fill(const Thin& step);
  void fill(const Base& step);
  void fill(const Normals& step);
  void fill(const Align& step);

  template <class Widget>
  Widget* field(const QString& title, const char* name, const QString& tip);
  QSpinBox* whole(const QString& title, const char* name, const QString& tip, int least, int most,
                  int value);
  QDoubleSpinBox* real(const QString& title, const char* name, const QString& tip, double least,
                       double most, double value, const QString& suffix);
  void note(const QString& text);
  /// Tells of the step with what `set` puts into it.
  template <class Kind, class Set>
  void put(const Set& set);

  Step step_;
  bool filling_ = false;
  QFormLayout* form_ = nullptr;
};

}  // namespace relievo
