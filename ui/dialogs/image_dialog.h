// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QSize>

#include "ui/views/picture_file.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace relievo {

struct ImageChoice {
  ImageSource source = ImageSource::detail;
  QSize pixels;
  QString file;
  bool both_eyes = false;  ///< Of the detail: each eye's picture as a file of its own, too.
};

/// Asks which picture to save, how large and where. [GUI thread]
class ImageDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param model  names the file; @param first_size  the size offered
  ImageDialog(const QString& model, const QSize& first_size, QWidget* parent);
  ImageChoice choice() const;

 Q_SIGNALS:
  void chosen(const relievo::ImageChoice& choice);

 private:
  QComboBox* source_;
  QSpinBox *width_, *height_;
  QLineEdit* file_;
  QCheckBox* both_eyes_;
};

}  // namespace relievo
