// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDateTime>
#include <QString>

namespace relievo {

/// The list of recent files that the programs of a desktop share: recently-used.xbel, as the
/// Desktop Bookmark Specification of freedesktop.org has it. What other programs wrote stays as it
/// is; a list that cannot be read, that is none, or whose place is no file is not touched: so
/// people say that they want none. [GUI thread]
class DesktopRecent {
 public:
  /// @param list  its file; where the desktop looks, without one
  explicit DesktopRecent(QString list = {});

  /// Puts a file there, or says that it was opened once more.
  void add(const QString& file, const QDateTime& now = QDateTime::currentDateTimeUtc()) const;
  /// Takes out what this program put there; what others opened, too, stays as theirs.
  void clear() const;

 private:
  QString list_;
};

}  // namespace relievo
