// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QWidget>

#include "core/project/project.h"
#include "core/session/surface.h"
#include "ui/figure/figure.h"

class QFormLayout;

namespace relievo {

class FigureFileRows;
class FigureMarkRows;
class FigurePageRows;
class FigureReliefRows;
class FigureStereoRows;

/// The fields of a figure, and the record they stand for: the same as the options of `relievo
/// figure`. [GUI thread]
class FigureForm : public QWidget {
  Q_OBJECT
 public:
  /// @param project  its figure is shown; fields that a request has and the form lacks stay as
  /// there
  /// @param file     that is suggested for the figure
  /// @param dialog   in which the form will stand
  FigureForm(const Surface& surface, const Project& project, const QString& file, QWidget* dialog);
  ~FigureForm() override;

  FigureRequest request() const;
  FigureFiles files() const;
  QString file() const;
  /// Fields that are off show what is drawn without them, and start there when they are turned on.
  void showAutomatic(const FigureFacts& facts);

 Q_SIGNALS:
  void changed();  ///< By the person.

 private:
  void show(const FigureRequest& request);
  void takeChange();
  void limit();

  const FigureRequest first_;  // What was shown.
  std::unique_ptr<FigurePageRows> page_;
  std::unique_ptr<FigureReliefRows> relief_;
  std::unique_ptr<FigureStereoRows> stereo_;
  std::unique_ptr<FigureMarkRows> marks_;
  std::unique_ptr<FigureFileRows> files_;
  bool complete_ = false;  // All fields show something; before, their signals mean nothing.
};

}  // namespace relievo
