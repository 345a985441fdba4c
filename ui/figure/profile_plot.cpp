// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/profile_plot.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

#include "core/base/error.h"
#include "ui/figure/figure_plot.h"

namespace relievo {
namespace {

constexpr double kDpi = 96;
constexpr QSizeF kSheetMm(120, 60);
constexpr QRectF kBoxMm(18, 4, 98, 42);

std::string number(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), error == std::errc{} ? end : text.data()};
}

}  // namespace

std::string profileSvg(const std::vector<ProfileRow>& rows) {
  if (rows.empty()) throw ArgumentError("There is no surface along this line.");
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
  std::vector<QPointF> curve;
  for (const ProfileRow& row : rows) curve.emplace_back(row.along_mm, row.point.at.z);
  drawCurve(ink, curve, kBoxMm, QStringLiteral("along the line (mm)"),
            QStringLiteral("height (mm)"));
  painter.end();
  return bytes.toStdString();
}

std::string profileCsv(const std::vector<ProfileRow>& rows, const std::string& input,
                       const std::string& sha256) {
  std::string text = "# relievo " + std::string(RELIEVO_VERSION_STRING) + ", input " +
                     std::filesystem::path(input).filename().string() + ", sha256 " + sha256 +
                     "\nalong_mm,x_mm,y_mm,z_mm,uncertainty_mm,origin\n";
  for (const ProfileRow& row : rows) {
    const ViewMm p = row.point.at;
    text += number(row.along_mm) + ',' + number(p.x) + ',' + number(p.y) + ',' + number(p.z) + ',' +
            number(row.point.height_uncertainty_mm) + ',' +
            std::to_string(static_cast<int>(row.point.origin)) + '\n';
  }
  return text;
}

}  // namespace relievo
