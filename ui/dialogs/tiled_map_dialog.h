// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QDialog>
#include <QStringList>

#include "core/base/unit.h"
#include "ui/work/pictures/depth_map_picture.h"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace relievo {

class DepthMapPreview;

/// What a map by tiles is made of, and how: the choices of `relievo depthmap --memory`.
struct TiledMapOrder {
  QStringList names;  ///< Files and folders of one scan.
  QString file;       ///< Of the finest level.
  std::optional<LengthUnit> unit;
  QString view;             ///< One of kViewNames; empty: as depthmap chooses.
  int memory_mb = 2000;     ///< For all but the program itself.
  int threads = 0;          ///< 0: one for each core.
  bool keeps_parts = true;  ///< What is finished is kept, in a folder beside the map.
  bool opens = true;        ///< The map is opened once it is made.
};

/// "Map by tiles...": asks what a map larger than the memory is made of, and shows what is ready of
/// it while it is made. It may be closed meanwhile; the work goes on. [GUI thread]
class TiledMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param begun  what is shown at first; without the name of a file one is proposed
  explicit TiledMapDialog(const TiledMapOrder& begun, QWidget* parent = nullptr);

  TiledMapOrder order() const;
  /// What of the map can be seen already. @param words  how fine it is
  void showReady(const DepthMapPicture& picture, const QString& words);
  void showProgress(const QString& step, double fraction, const QString& left);
  void showBusy(bool busy);
  /// In words; empty: none.
  void showProblem(const QString& text);

 Q_SIGNALS:
  void makeAsked();
  void stopAsked();

 private:
  QFormLayout* form();
  QBoxLayout* scanRow();
  QBoxLayout* fileRow();
  QBoxLayout* readyColumn();
  QBoxLayout* bottomRow();
  void fillChoices();
  void fill(const TiledMapOrder& order);
  void addNames(const QStringList& names);
  void browse();
  void follow();

  QListWidget* names_;
  QPushButton *files_, *folder_, *remove_, *browse_;
  QLineEdit* file_;
  bool is_proposed_ = true;  ///< Nobody chose the map's name.
  QComboBox *unit_, *view_;
  QSpinBox *memory_, *threads_;
  QCheckBox *keeps_, *opens_;
  DepthMapPreview* preview_;
  QLabel *ready_, *step_, *problem_;
  QProgressBar* bar_;
  QPushButton *stop_, *make_ = nullptr;
};

}  // namespace relievo
