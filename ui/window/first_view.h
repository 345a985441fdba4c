// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QWidget>

#include "ui/work/document.h"

namespace relievo {

/// A picture of a large file while it is read, over `place`: all of it while nothing is open, else
/// in a corner, so that what is shown stays what the hand feels. It can only be looked at; the
/// document does not change before the whole is there. [GUI thread]
class FirstViewCard : public QWidget {
  Q_OBJECT
 public:
  FirstViewCard(Document& document, QWidget* place);

  QString text() const { return text_; }  ///< What is written under the picture.

 Q_SIGNALS:
  void said(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show(const QString& file, const QImage& picture, quint64 used, quint64 all);
  void fit();

  Document& document_;
  QImage picture_;
  QString text_;
};

}  // namespace relievo
