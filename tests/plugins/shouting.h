// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QTranslator>

#include "core/message/catalogue.h"

namespace relievo::test {

/// A language in which messages are shouted: a word in small letters was not translated, or is a
/// part that is carried over.
class Shouting : public QTranslator {
 public:
  Shouting() { QCoreApplication::installTranslator(this); }
  ~Shouting() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    if (QString::fromUtf8(context) != QLatin1String(kMessageContext)) return {};
    return QString::fromUtf8(source).toUpper();
  }
};

}  // namespace relievo::test
