// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;
class QString;

namespace relievo {

/// "Gentle, 30 %"; empty: no preset has this strength.
QString strengthPresetText(int percent);

/// What the panel Touch has to say how strong all forces are: a row for any strength, and the
/// presets. [GUI thread]
class StrengthRow : public QObject {
  Q_OBJECT
 public:
  explicit StrengthRow(QObject* parent);
  void addTo(QFormLayout* form);
  /// For a place beside other controls: the panel is as high as it may be.
  QComboBox* presets() const;

  int percent() const;
  void set(int percent);  ///< Emits nothing.

 Q_SIGNALS:
  void changed();  ///< By the person.

 private:
  void takePreset(int index);
  void show();

  QSlider* strength_;
  QLabel* value_;
  QComboBox* preset_;
};

}  // namespace relievo
