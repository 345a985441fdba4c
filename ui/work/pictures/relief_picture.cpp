// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/pictures/relief_picture.h"

#include <algorithm>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/relief/relief_image.h"
#include "core/session/large/crop_level.h"
#include "core/session/open_input.h"
#include "core/tiles/published/published_tiles.h"
#include "ui/work/file_names.h"
#include "ui/work/surface_work.h"

namespace relievo {
namespace {

constexpr int kCells = 200;

/// Of a file as it is now: another path, size or date is another picture.
QString pathFor(const QString& file) {
  // Of an address, what was kept of it when it was opened.
  const auto map = isAddress(file) ? keptMap(bytesOfPath(file)) : std::nullopt;
  const QFileInfo info(map ? pathFromBytes(map->native()) : file);
  const QByteArray about = info.canonicalFilePath().toUtf8() + '\n' +
                           QByteArray::number(info.size()) + '\n' +
                           info.lastModified().toString(Qt::ISODateWithMs).toUtf8();
  QString root = QString::fromLocal8Bit(qgetenv("XDG_CACHE_HOME"));
  if (!QDir::isAbsolutePath(root)) root = QDir::homePath() + QLatin1String("/.cache");
  const QByteArray hash = QCryptographicHash::hash(about, QCryptographicHash::Sha256).toHex();
  return root + QLatin1String("/relievo/pictures/") + QString::fromLatin1(hash.left(32)) +
         QLatin1String(".png");
}

}  // namespace

QImage reliefPicture(const Surface& surface, int longest_px) {
  // The coarsest level that is fine enough.
  Level from{surface.ladder.levels() - 1};
  const auto longest = [&] {
    const GridSize size = levelFrame(surface, from).size;
    return std::max(size.cols, size.rows);
  };
  while (from.value > 0 && longest() < longest_px) --from.value;
  DepthMap map = cropLevel(surface, from);
  std::fill(map.origins.begin(), map.origins.end(), CellStatus::measured);
  ReliefLook look;
  look.kind = ReliefKind::multi_hillshade;
  const std::vector<std::uint8_t> colours = reliefColours(reliefValues(map, look), look);
  const GridSize size = map.frame.size;
  return QImage(colours.data(), size.cols, size.rows, 3 * size.cols, QImage::Format_RGB888)
      .mirrored()  // Row 0 of a map is its lowest.
      .scaled(longest_px, longest_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

ReliefPictures::ReliefPictures(QObject* parent) : QObject(parent) {}

QImage ReliefPictures::kept(const QString& file) {
  return QImage(pathFor(file));
}

void ReliefPictures::keep(const QString& file, const QImage& picture) {
  if (picture.isNull()) return;
  const QString path = pathFor(file);
  QDir().mkpath(QFileInfo(path).absolutePath());
  picture.save(path);  // A cache: what cannot be kept is made again.
}

void ReliefPictures::make(const QStringList& files) {
  QStringList missing;
  for (const QString& file : files) {
    if (!QFileInfo::exists(pathFor(file))) missing << file;
  }
  if (missing.isEmpty()) return;
  const auto picture = std::make_shared<QImage>();
  const QString file = missing.front();
  worker_.start(
      [file, picture](const Task& task) {
        try {
          SurfaceOptions options;
          options.cells = kCells;
          const std::filesystem::path path = QFile::encodeName(file).toStdString();
          OpenedInput input = openInput(path, {}, task);
          const auto surface =
              makeSurface({std::move(input.scan), std::move(input.raster), std::move(input.tiled)},
                          options, rasterize, task);
          *picture = reliefPicture(*surface, kPicturePx);
        } catch (const std::exception&) {
          return;  // Opening it will say what is wrong; here it only has no picture.
        }
      },
      [this, file, picture, missing] {
        if (!picture->isNull()) {
          keep(file, *picture);
          Q_EMIT made(file, *picture);
        }
        make(missing.mid(1));
      });
}

}  // namespace relievo
