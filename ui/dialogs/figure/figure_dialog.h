// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <QDialog>

#include "core/project/project.h"
#include "core/session/surface.h"
#include "ui/figure/figure.h"
#include "ui/work/latest_worker.h"

class QHBoxLayout;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace relievo {

class FigureForm;
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
  void refused(const QString& why);  ///< Nothing was saved, or not all.

 private:
  QWidget* formColumn();
  QVBoxLayout* previewColumn();
  QHBoxLayout* buttonRow();
  void changed();
  void preview();
  void previewLarger();
  void showFacts(const FigureFacts& facts);
  void showProblem(const QString& problem);
  /// Of saving: it stays until something is changed, whatever is drawn meanwhile. Empty: none.
  void showRefusal(const QString& why);
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
  FigureForm* form_;
  FigurePreview* picture_ = nullptr;
  QLabel *facts_ = nullptr, *problem_ = nullptr;
  QString refusal_;
  QPlainTextEdit* caption_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *save_ = nullptr, *stop_ = nullptr;
  QTimer* delay_;
  int preview_px_ = 0;    ///< That the last preview was drawn for.
  bool writing_ = false;  ///< No preview may stop it.
  QStringList targets_;   ///< That are written now, in this order ...
  /// ... and how many of them are there. [any thread]
  std::shared_ptr<std::atomic<std::size_t>> there_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
