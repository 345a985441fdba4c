// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "plugins/haptics/touch_settings.h"

class QCheckBox;
class QFormLayout;
class QSpinBox;

namespace relievo {

/// The rows of the panel Touch about its sounds, and about the taps that say the same. [GUI thread]
class SoundRows : public QObject {
  Q_OBJECT
 public:
  explicit SoundRows(QObject* parent);
  void addTo(QFormLayout* form);

  SoundSettings sound() const;
  bool feltPatterns() const;
  void set(const TouchSettings& settings);  ///< Emits nothing.

 Q_SIGNALS:
  void changed();  ///< By the person.

 private:
  QCheckBox* on_;
  QSpinBox* volume_;
  QCheckBox* felt_;
};

}  // namespace relievo
