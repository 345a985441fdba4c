// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QDialog>
#include <QString>
#include <vector>

#include "core/session/export_map.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace relievo {

struct ExportOrder {
  MapExport choice;
  QString file;
};

/// Something else that can be written than the map: a picture, a profile, a section.
struct OtherExport {
  QString text;    ///< In the list of formats: "Profile 2, numbers (.csv)".
  QString ending;  ///< ".csv"
  QString size;    ///< In words; empty: not known before.
  std::function<void(const QString& file)> write;
};

/// Asks what goes to another program, in which format and where; says how large it will be.
/// [GUI thread]
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param model   names the file
  /// @param region  the window, with its level
  /// @param others  offered after the formats of maps and meshes
  ExportDialog(std::shared_ptr<const Surface> surface, const Region& region, const QString& model,
               std::vector<OtherExport> others, QWidget* parent);
  ExportOrder order() const;

 Q_SIGNALS:
  void chosen(const relievo::ExportOrder& order);  ///< Of a map or mesh; others write themselves.

 private:
  void fillFormats();
  void fillParts();
  void fillCoordinates();
  void browse();
  QString ending() const;
  const OtherExport* other() const;  ///< The chosen one; null: it is a map or mesh.
  QString chosenFile() const;        ///< With the format's ending.
  /// The file's ending follows the format, and the estimate all of them.
  void follow();

  std::shared_ptr<const Surface> surface_;
  Region region_;
  std::vector<OtherExport> others_;
  QString model_;            ///< After which files are named.
  bool is_proposed_ = true;  ///< Nobody chose the name.
  QComboBox *format_, *part_, *coordinates_;
  QLineEdit* file_;
  QLabel* size_;
};

}  // namespace relievo
