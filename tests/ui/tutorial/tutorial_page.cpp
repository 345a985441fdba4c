// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/tutorial/tutorial_page.h"

#include <gtest/gtest.h>
#include <QFile>
#include <QRegularExpression>

namespace relievo {

TutorialPage::TutorialPage(const QString& file) {
  QFile page(file);
  EXPECT_TRUE(page.open(QIODevice::ReadOnly)) << file.toStdString();
  // What the page says of itself is above its first step.
  rest_ = QString::fromUtf8(page.readAll()).section(QStringLiteral("\n## "), 1).simplified();
  EXPECT_FALSE(rest_.isEmpty());
}

QStringList TutorialPage::marksIn(const QString& text) {
  static const QRegularExpression mark(QStringLiteral(R"(\*\*[^*]+\*\*|\*[^*]+\*)"));
  QStringList marks;
  for (auto found = mark.globalMatch(text); found.hasNext();) marks << found.next().captured();
  return marks;
}

void TutorialPage::expectAllUsed() {
  EXPECT_TRUE(unused_.isEmpty()) << "not done: " << unused_.join(", ").toStdString() << " of \""
                                 << sentence_.toStdString() << '"';
}

void TutorialPage::says(const QString& sentence) {
  expectAllUsed();
  const QString wanted = sentence.simplified();
  const auto at = rest_.indexOf(wanted);
  ASSERT_GE(at, 0) << "the page does not say, after \"" << sentence_.toStdString() << "\": \""
                   << wanted.toStdString() << '"';
  const QStringList passed = marksIn(rest_.left(at));
  EXPECT_TRUE(passed.isEmpty()) << "passed over: " << passed.join(", ").toStdString();
  sentence_ = wanted;
  unused_ = marksIn(wanted);
  rest_ = rest_.mid(at + wanted.size());
}

void TutorialPage::use(const QString& mark) {
  EXPECT_TRUE(marksIn(sentence_).contains(mark))
      << mark.toStdString() << " is not named in \"" << sentence_.toStdString() << '"';
  unused_.removeAll(mark);
}

void TutorialPage::ends() {
  expectAllUsed();
  const QStringList passed = marksIn(rest_);
  EXPECT_TRUE(passed.isEmpty()) << "passed over: " << passed.join(", ").toStdString();
}

}  // namespace relievo
