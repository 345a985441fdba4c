// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/exhibit/exhibit.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QGroupBox;
class QLineEdit;
class QSpinBox;

namespace relievo {

/// What an exhibit says of every visit: languages, waiting, voice, touch, the staff's PIN and where
/// counts go. [GUI thread]
class ExhibitVisitPage : public QWidget {
  Q_OBJECT
 public:
  explicit ExhibitVisitPage(QWidget* parent = nullptr);

  void setExhibit(const Exhibit& exhibit);
  /// Takes what is chosen into all but the objects. The PIN is a new one if digits were typed.
  void fill(Exhibit& exhibit) const;
  const std::vector<std::string>& languages() const { return languages_; }
  /// What shows a place of the file, "speech.loudest_percent"; null: nothing here.
  QWidget* fieldOf(const QString& place) const;

 Q_SIGNALS:
  void changed();

 private:
  QGroupBox* languageBox();
  QGroupBox* waitingBox();
  QGroupBox* voiceBox();
  QGroupBox* touchBox();
  QGroupBox* staffBox();
  QSpinBox* whole(const char* name, const QString& title, const QString& tip, int least, int most,
                  const QString& unit);
  QDoubleSpinBox* number(const char* name, const QString& title, const QString& tip, double least,
                         double most, const QString& unit);
  QCheckBox* truth(const char* name, const QString& title, const QString& tip);
  void takeLanguages();
  void listLanguages();
  void browse();
  void showPin();
  void changePin();

  std::vector<std::string> languages_;
  StaffPin pin_;  ///< Of the file, or of the digits that were typed.
  bool is_showing_ = false;
  std::vector<QCheckBox*> spoken_;
  QComboBox* first_;
  QDoubleSpinBox *still_there_, *goodbye_, *chime_;
  QSpinBox *volume_, *loudest_, *room_loudest_, *words_;
  QComboBox* device_;
  QSpinBox *strength_, *sounds_;
  QDoubleSpinBox* limit_;
  QCheckBox *introduction_, *guide_, *patterns_, *one_button_;
  QLineEdit *digits_, *records_;
};

}  // namespace relievo
