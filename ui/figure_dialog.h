// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QDialog>

#include "core/project/project.h"
#include "core/session/surface.h"
#include "ui/figure/figure.h"
#include "ui/latest_worker.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;

namespace relievo {

/// "Figure...": everything about a figure for print, with a preview of exactly what will be
/// written. Edits the same record as `relievo figure`. [GUI thread]
class FigureDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param project  the present state; its figure is where the dialog starts
  FigureDialog(std::shared_ptr<const Surface> surface, Project project, const QString& file,
               QWidget* parent = nullptr);
  ~FigureDialog() override;

  FigureRequest request() const;
  QString file() const;
  void done(int result) override;

 Q_SIGNALS:
  void written(const QString& file);
  void requestChanged(const relievo::FigureRequest& request);

 private:
  QWidget* makeForm();
  void addPage(QFormLayout* layout);
  void addRelief(QFormLayout* layout);
  void addStereo(QFormLayout* layout);
  void addMarks(QFormLayout* layout);
  void showRequest(const FigureRequest& request);
  void limit();
  void changed();
  void preview();
  void save();
  void write();
  void stop();
  void showBusy(bool busy);
  void showFacts(const FigureFacts& facts);
  Project wanted() const;
  template <class Widget>
  Widget* field(QFormLayout* layout, const QString& title, const char* name, const QString& tip);

  const std::shared_ptr<const Surface> surface_;
  const Project project_;
  const QString own_folder_;  ///< Of the suggested file; made if need be, unlike others.
  QComboBox *layout_ = nullptr, *relief_ = nullptr, *colours_ = nullptr, *stereo_ = nullptr;
  QDoubleSpinBox *width_ = nullptr, *dpi_ = nullptr, *scale_ = nullptr, *text_ = nullptr;
  QDoubleSpinBox *azimuth_ = nullptr, *elevation_ = nullptr, *radius_ = nullptr, *eye_ = nullptr;
  QCheckBox *to_scale_ = nullptr, *transparent_ = nullptr, *swap_ = nullptr, *comfort_ = nullptr;
  std::array<QCheckBox*, 8> marks_{};
  QLineEdit *recording_ = nullptr, *file_ = nullptr;
  QLabel *picture_ = nullptr, *facts_ = nullptr, *problem_ = nullptr;
  QPlainTextEdit* caption_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *save_ = nullptr, *stop_ = nullptr;
  QTimer* delay_;
  bool complete_ = false;  ///< All fields are there; before, their signals mean nothing.
  bool writing_ = false;   ///< No preview may stop it.
  LatestWorker worker_;    ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
