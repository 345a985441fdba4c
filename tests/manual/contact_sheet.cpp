// SPDX-License-Identifier: BSD-3-Clause
// Puts pictures side by side with a line under each: contact_sheet OUT.png COLUMNS WIDTH
// "TEXT=FILE"...; "TEXT=" alone is a line across the sheet.
#include <cstdlib>
#include <iostream>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <vector>

namespace {

constexpr int kGap = 16;

struct Entry {
  QString text;
  QImage picture;  ///< Null: a line across.
};

QImage read(const QString& file, int width) {
  if (file.endsWith(QLatin1String(".svg"))) {
    QSvgRenderer drawing(file);
    if (!drawing.isValid()) return {};
    const QSize size = drawing.defaultSize().scaled(width, 10 * width, Qt::KeepAspectRatio);
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    drawing.render(&painter);
    return image;
  }
  const QImage image(file);
  return image.isNull() ? image : image.scaledToWidth(width, Qt::SmoothTransformation);
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication app(argc, argv);
  if (argc < 5) {
    std::cerr << "contact_sheet OUT.png COLUMNS WIDTH TEXT=FILE...\n";
    return 1;
  }
  const int columns = std::max(1, std::atoi(argv[2]));
  const int width = std::max(50, std::atoi(argv[3]));
  std::vector<Entry> entries;
  for (int i = 4; i < argc; ++i) {
    const QString argument = QString::fromUtf8(argv[i]);
    const int at = argument.lastIndexOf('=');
    Entry entry{argument.left(at), {}};
    const QString file = argument.mid(at + 1);
    if (!file.isEmpty()) {
      entry.picture = read(file, width);
      if (entry.picture.isNull()) {
        std::cerr << "contact_sheet: cannot read " << file.toStdString() << '\n';
        return 2;
      }
    }
    entries.push_back(entry);
  }
  const auto paint = [&](QPainter* painter) {
    const QFontMetrics metrics(QGuiApplication::font());
    const int line = metrics.height() * 2 + 4;
    int y = kGap;
    std::size_t i = 0;
    while (i < entries.size()) {
      if (entries[i].picture.isNull()) {
        const QRect place(kGap, y, columns * (width + kGap) - kGap, line);
        if (painter != nullptr) {
          painter->drawText(place, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
                            entries[i].text);
        }
        y += line + kGap / 2;
        ++i;
        continue;
      }
      int tallest = 0;
      int column = 0;
      for (; i < entries.size() && column < columns && !entries[i].picture.isNull();
           ++i, ++column) {
        const int x = kGap + column * (width + kGap);
        if (painter != nullptr) {
          painter->drawImage(x, y, entries[i].picture);
          painter->drawText(QRect(x, y + entries[i].picture.height() + 2, width, line),
                            Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, entries[i].text);
        }
        tallest = std::max(tallest, entries[i].picture.height());
      }
      y += tallest + line + kGap;
    }
    return y;
  };
  QImage sheet(columns * (width + kGap) + kGap, paint(nullptr), QImage::Format_RGB32);
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  paint(&painter);
  painter.end();
  if (!sheet.save(QString::fromLocal8Bit(argv[1]))) {
    std::cerr << "contact_sheet: cannot write " << argv[1] << '\n';
    return 3;
  }
  return 0;
}
