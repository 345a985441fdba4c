// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <QDialog>

#include "core/project/project.h"
#include "core/session/surface.h"
#include "ui/figure/figure.h"
#include "ui/work/latest_worker.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace relievo {

class FigureNumber;
class FigurePreview;

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
  FigureFiles files() const;
  QString file() const;
  void done(int result) override;

 Q_SIGNALS:
  void written(const QString& file);
  void requestChanged(const relievo::FigureRequest& request);

 private:
  struct Place;  ///< Where a file is chosen.

  // figure_dialog_form.cpp
  QWidget* makeForm();
  void addPage(QFormLayout* layout);
  void addRelief(QFormLayout* layout);
  void addRange(QFormLayout* layout);
  void addStereo(QFormLayout* layout);
  void addMarks(QFormLayout* layout);
  void addFiles(QFormLayout* layout);
  template <class Widget>
  Widget* field(QFormLayout* layout, const QString& title, const char* name, const QString& tip);
  QLineEdit* place(QFormLayout* layout, const QString& title, const char* name, const QString& tip,
                   const Place& chosen_in);
  void browse(QLineEdit* field, const Place& chosen_in);

  // figure_dialog_record.cpp
  void showRequest(const FigureRequest& request);
  void limit();
  void limitRelief();
  void limitStereo();
  void suggestNames();
  void showAutomatic(const FigureFacts& facts);

  // figure_dialog.cpp
  QWidget* formColumn();
  QVBoxLayout* previewColumn();
  QHBoxLayout* buttonRow();
  void changed();
  void preview();
  void previewLarger();
  void showFacts(const FigureFacts& facts);
  void showProblem(const QString& problem);
  void showBusy(bool busy);
  Project wanted() const;

  // figure_dialog_files.cpp
  void save();
  void askToReplace(const QStringList& there);
  void write();
  void stop();

  const std::shared_ptr<const Surface> surface_;
  const Project project_;
  const QString own_folder_;  ///< Of the suggested file; made if need be, unlike others.
  QComboBox *layout_ = nullptr, *relief_ = nullptr, *colours_ = nullptr, *stereo_ = nullptr;
  FigureNumber *width_ = nullptr, *dpi_ = nullptr, *scale_ = nullptr, *text_ = nullptr;
  FigureNumber *azimuth_ = nullptr, *elevation_ = nullptr, *radius_ = nullptr, *eye_ = nullptr;
  FigureNumber* shading_ = nullptr;
  FigureNumber *range_low_ = nullptr, *range_high_ = nullptr, *zero_plane_ = nullptr;
  QCheckBox *to_scale_ = nullptr, *transparent_ = nullptr, *swap_ = nullptr, *comfort_ = nullptr;
  QCheckBox *own_range_ = nullptr, *own_zero_plane_ = nullptr;
  QCheckBox *both_eyes_ = nullptr, *heights_too_ = nullptr, *caption_too_ = nullptr;
  std::array<QCheckBox*, 8> marks_{};
  QLineEdit *recording_ = nullptr, *file_ = nullptr;
  QLineEdit *heights_file_ = nullptr, *caption_file_ = nullptr;
  FigurePreview* picture_ = nullptr;
  QLabel *facts_ = nullptr, *problem_ = nullptr;
  QPlainTextEdit* caption_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *save_ = nullptr, *stop_ = nullptr;
  QTimer* delay_;
  int shown_relief_ = 0;   ///< Kind that the colours' ends are values of.
  int preview_px_ = 0;     ///< That the last preview was drawn for.
  bool complete_ = false;  ///< All fields are there; before, their signals mean nothing.
  bool writing_ = false;   ///< No preview may stop it.
  QStringList targets_;    ///< That are written now, in this order ...
  /// ... and how many of them are there. [any thread]
  std::shared_ptr<std::atomic<std::size_t>> there_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
