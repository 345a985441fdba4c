// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/profile_plot.h"

#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

#include "core/base/failure.h"
#include "ui/figure/figure_plot.h"

namespace relievo {
namespace {

constexpr double kDpi = 96;
constexpr QSizeF kSheetMm(120, 60);
constexpr QRectF kBoxMm(18, 4, 98, 42);

}  // namespace

std::string profileSvg(const std::vector<ProfileRow>& rows) {
  if (rows.empty()) throw failure<MessageId::profile_without_surface>();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(static_cast<int>(kDpi));
  const QSize size = (kSheetMm * kDpi / 25.4).toSize();
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(QStringLiteral("Profile"));
  QPainter painter(&generator);
  FigureInk ink(painter, kDpi, 8, FigureInk::Target::vectors);
  std::vector<std::vector<QPointF>> pieces;
  for (const ProfileRow& row : rows) {
    if (!row.joined) pieces.emplace_back();
    pieces.back().emplace_back(row.along_mm, row.point.at.z);
  }
  drawCurve(ink, pieces, kBoxMm, QStringLiteral("along the line (mm)"),
            QStringLiteral("height (mm)"));
  painter.end();
  return bytes.toStdString();
}

}  // namespace relievo
