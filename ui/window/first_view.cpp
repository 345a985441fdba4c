// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/first_view.h"

#include <algorithm>
#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>

#include "ui/style/palette.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kMargin = 16;  ///< Of the card from its place's corner, and around the text.
constexpr int kLeastWidth = 260;
constexpr int kLeastHeight = 220;

QString grouped(quint64 number) {
  return QLocale().toString(static_cast<qulonglong>(number));
}

}  // namespace

FirstViewCard::FirstViewCard(Document& document, QWidget* place)
    : QWidget(place), document_(document) {
  setObjectName(QStringLiteral("first_view"));
  setAccessibleName(tr("First view of the file that is being read"));
  place->installEventFilter(this);
  connect(&document_.loader(), &SurfaceLoader::firstView, this, &FirstViewCard::show);
  connect(&document_.loader(), &SurfaceLoader::workStarted, this, &QWidget::hide);
  connect(&document_.loader(), &SurfaceLoader::busyChanged, this, &QWidget::hide);
  QWidget::hide();
}

void FirstViewCard::show(const QString& file, const QImage& picture, quint64 used, quint64 all) {
  picture_ = picture;
  text_ = tr("%1: first view from %2 of %3 points. The whole is being read.")
              .arg(shownName(file), grouped(used), grouped(all));
  text_ += QLatin1Char(' ');
  text_ += document_.isOpen() ? tr("Until then the views and the hand stay with the object before.")
                              : tr("It can be touched then.");
  setAccessibleDescription(text_);
  fit();
  raise();
  QWidget::show();
  update();
  Q_EMIT said(text_);
}

void FirstViewCard::fit() {
  const QRect place = parentWidget()->rect();
  if (!document_.isOpen()) {
    setGeometry(place);
    return;
  }
  const QSize size(std::min(place.width(), std::max(kLeastWidth, place.width() / 3)),
                   std::min(place.height(), std::max(kLeastHeight, place.height() / 3)));
  setGeometry(kMargin, place.height() - size.height() - kMargin, size.width(), size.height());
}

bool FirstViewCard::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) fit();
  return QWidget::eventFilter(watched, event);
}

void FirstViewCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColours& c = currentColours();
  painter.fillRect(rect(), c.viewport);
  const QRect within = rect().adjusted(kMargin, kMargin, -kMargin, -kMargin);
  constexpr int kWords = Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap;
  const QRect words = painter.boundingRect(within, kWords, text_);
  const QRect room = within.adjusted(0, 0, 0, -words.height() - kMargin);
  const QSize fitted = picture_.size().scaled(room.size(), Qt::KeepAspectRatio);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRect(room.center() - QPoint(fitted.width() / 2, fitted.height() / 2), fitted),
                    picture_);
  painter.fillRect(QRect(0, words.top() - kMargin / 2, width(), height()), c.strip);
  painter.setPen(c.text);
  painter.drawText(within, kWords, text_);
  painter.setPen(c.quiet_text);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace relievo
