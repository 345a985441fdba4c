// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QTranslator>
#include <set>
#include <string>

namespace relievo::test {

/// A language in which what haptics says is shouted: a word in small letters was not translated, or
/// is a part that is carried over.
class Shouting : public QTranslator {
 public:
  Shouting() { QCoreApplication::installTranslator(this); }
  ~Shouting() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    if (QString::fromUtf8(context) != QLatin1String("relievo::SpokenWords")) return {};
    asked.insert(source);
    return QString::fromUtf8(source).toUpper();
  }

  mutable std::set<std::string> asked;
};

}  // namespace relievo::test
