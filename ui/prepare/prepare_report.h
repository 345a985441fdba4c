// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>

#include "ui/prepare/prepare_work.h"

class QLabel;

namespace relievo {

class ReadScans;

/// What the dialog Prepare says of a result: how many points stay, what was done, where the scans
/// lie; or why there is no result. [GUI thread]
class PrepareReport : public QScrollArea {
  Q_OBJECT
 public:
  PrepareReport();

  void showProblem(const QString& sentence);  ///< Empty: there is none.
  void showAdvice(const QString& text);       ///< In place of what was done.
  void clear();
  /// @param found  what was said when the scans were found to lie as they do; null: nothing
  void showResult(const PrepareResult& result, const AlignAnswer* found, CloudColour colour,
                  const ReadScans& reads);
  QString total() const;

 private:
  QStringList alignTexts(const PrepareResult& result, const AlignAnswer* found,
                         const ReadScans& reads) const;

  QLabel *total_, *details_, *problem_;
};

}  // namespace relievo
