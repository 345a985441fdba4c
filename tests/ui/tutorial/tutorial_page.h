// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>

namespace relievo {

/// A page of the guide, read sentence by sentence. Keys stand in **bold**, menus and controls in
/// *italics*; none of them is passed over. A fault is a failure of the running test.
class TutorialPage {
 public:
  explicit TutorialPage(const QString& file);

  /// Goes on to a sentence, as it stands on the page with its marks. What is between it and the one
  /// before names no key and no control, and those of the one before were used.
  void says(const QString& sentence);
  /// It is in bold in the sentence said last.
  void usesKey(const QString& key) { use(QStringLiteral("**%1**").arg(key)); }
  /// It is in italics in the sentence said last.
  void usesControl(const QString& control) { use(QStringLiteral("*%1*").arg(control)); }
  /// The rest of the page names nothing, and all was used.
  void ends();

 private:
  static QStringList marksIn(const QString& text);
  void use(const QString& mark);
  void expectAllUsed();

  QString rest_;  ///< White space is single blanks.
  QString sentence_;
  QStringList unused_;
};

}  // namespace relievo
