// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tile_raster.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/io/file_check.h"
#include "core/io/raster/map_file.h"
#include "core/io/raster/raster_file.h"
#include "core/io/raster/tiff_head.h"
#include "core/tiles/tile_layout.h"

namespace relievo {

struct TileRasterWriter::Impl {
  explicit Impl(const OutputFile& place) : file(place.path), written(place) {}

  std::filesystem::path file;
  AtomicFile written;
  GridFrame frame;
  Layout layout;
  std::unique_ptr<RasterFile> raster;
  std::vector<std::vector<std::byte>> rows;  ///< Per band: the rows of one row of tiles.
  int next_row = 0;                          ///< From the lowest.

  std::size_t lineBytes() const {
    return static_cast<std::size_t>(frame.size.cols) * layout.cell_bytes;
  }

  void requireRoom() const;
  void create();
  void requireGood() const {
    if (!raster->good()) cannotWrite(file, raster->complaint());
  }
  void writeTiles(int file_tile_row, int lines);
  void writeMask(const BitRows& mask);
};

/// Before hours of work: GDAL is not asked (RasterSpec::passes_once).
void TileRasterWriter::Impl::requireRoom() const {
  constexpr std::uintmax_t kLittle = 1'000'000'000;
  const std::uintmax_t bytes =
      frame.size.count() * layout.cell_bytes * static_cast<std::uintmax_t>(layout.bands);
  if (bytes < kLittle) return;
  const std::filesystem::path folder = file.parent_path();
  std::error_code unknown;
  const auto space = std::filesystem::space(folder.empty() ? "." : folder, unknown);
  if (unknown || space.available >= bytes) return;
  cannotWrite(file, "no space left on the disk: it takes " + grouped(bytes / 1'000'000) +
                        " MB, and " + grouped(space.available / 1'000'000) + " MB are free");
}

void TileRasterWriter::Impl::create() {
  requireRoom();
  const GridSize size = frame.size;
  const double s = frame.spacing_mm;
  RasterSpec spec{
      .size = size,
      .bands = layout.bands,
      .is_float = layout.cell_bytes == sizeof(float),
      .options = {"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "INTERLEAVE=BAND",
                  "BIGTIFF=IF_SAFER", "COMPRESS=NONE", "ENDIANNESS=LITTLE"},
      .transform = {frame.first_x_mm - 0.5 * s, s, 0, frame.yMm(size.rows - 1) + 0.5 * s, 0, -s},
      .projection = kViewSystem,
      .nan_is_nodata = layout.nan_is_nodata,
      .passes_once = true};
  if (layout.has_alpha) {
    spec.options.push_back("ALPHA=NON-PREMULTIPLIED");
    spec.options.push_back(layout.bands == 4 ? "PHOTOMETRIC=RGB" : "PHOTOMETRIC=MINISBLACK");
  }
  raster = createRasterFile(written.path(), spec);
  requireGood();
  rows.resize(static_cast<std::size_t>(layout.bands));
  for (auto& band : rows) band.resize(kTileSide * lineBytes());
}

/// @param lines  of the file's row of tiles that are in `rows`, the rest is beyond the raster
void TileRasterWriter::Impl::writeTiles(int file_tile_row, int lines) {
  const std::size_t tile_line = kTileSide * layout.cell_bytes;
  std::vector<std::byte> tile(kTileSide * tile_line);
  for (int band = 0; band < layout.bands; ++band) {
    const std::vector<std::byte>& from = rows[static_cast<std::size_t>(band)];
    for (std::size_t start = 0, x = 0; start < lineBytes(); start += tile_line, ++x) {
      const std::size_t bytes = std::min(tile_line, lineBytes() - start);
      std::fill(tile.begin(), tile.end(), std::byte{0});
      for (std::size_t line = 0; line < static_cast<std::size_t>(lines); ++line) {
        std::copy_n(from.data() + line * lineBytes() + start, bytes,
                    tile.data() + line * tile_line);
      }
      raster->writeTile(band + 1, static_cast<int>(x), file_tile_row, tile.data());
      requireGood();
    }
  }
}

void TileRasterWriter::Impl::writeMask(const BitRows& mask) {
  raster->addMask();
  requireGood();
  const GridSize size = frame.size;
  for (int top = 0; top < size.rows; top += kTileSide) {
    const int lines = std::min(kTileSide, size.rows - top);
    // In the file the highest row comes first.
    std::vector<std::uint8_t> cells = mask.bytes(size.rows - top - lines, lines);
    for (std::uint8_t& cell : cells) cell = cell != 0 ? 255 : 0;
    const std::uint8_t* highest = cells.data() + size.index({.col = 0, .row = lines - 1});
    raster->writeRows(RasterFile::kMask, top, lines, highest, -std::ptrdiff_t{size.cols});
    requireGood();
  }
}

TileRasterWriter::TileRasterWriter(const OutputFile& file, const GridFrame& frame,
                                   const Layout& layout)
    : impl_(std::make_unique<Impl>(file)) {
  impl_->frame = frame;
  impl_->layout = layout;
  impl_->create();
}

TileRasterWriter::~TileRasterWriter() = default;

void TileRasterWriter::add(std::span<const void* const> bands) {
  const int file_row = impl_->frame.size.rows - 1 - impl_->next_row;
  const std::size_t line = static_cast<std::size_t>(file_row % kTileSide) * impl_->lineBytes();
  for (std::size_t band = 0; band < bands.size(); ++band) {
    std::memcpy(impl_->rows[band].data() + line, bands[band], impl_->lineBytes());
  }
  ++impl_->next_row;
  if (file_row % kTileSide != 0) return;
  const int lines = std::min(kTileSide, impl_->frame.size.rows - file_row);
  impl_->writeTiles(file_row / kTileSide, lines);
}

void TileRasterWriter::close(const RasterFacts& facts, const BitRows* mask) {
  if (mask != nullptr) impl_->writeMask(*mask);
  impl_->raster->setEntries({facts.begin(), facts.end()});
  impl_->raster->close();
  impl_->requireGood();
}

void TileRasterWriter::commit() {
  impl_->written.commit();
}

namespace {

template <MessageId why, class... Given>
[[noreturn]] void refuse(const std::filesystem::path& file, Given&&... given) {
  throw failure<MessageId::tiled_map_unreadable>(shownName(file),
                                                 said<why>(std::forward<Given>(given)...));
}

void checkLayout(const TiffHead& head, const std::filesystem::path& file, std::size_t cell_bytes,
                 int bands) {
  if (head.bands != static_cast<std::uint32_t>(bands)) refuse<MessageId::tiles_other_bands>(file);
  if (head.compression != 1) refuse<MessageId::tiles_compressed>(file);
  if (bands > 1 && head.planes != 2) refuse<MessageId::tiles_bands_mixed>(file);
  if (head.tile_cols != kTileSide || head.tile_rows != kTileSide) {
    refuse<MessageId::tiles_other_size>(file);
  }
  if (head.bits != 8 * cell_bytes || head.sample_format != (cell_bytes == 4 ? 3U : 1U)) {
    refuse<MessageId::tiles_other_cells>(file);
  }
  if (!head.little_endian) refuse<MessageId::tiles_other_byte_order>(file);
}

}  // namespace

TileRaster::TileRaster(const std::filesystem::path& file, const std::optional<TiffHead>& head,
                       std::size_t cell_bytes, int bands)
    : file_(file), cell_bytes_(cell_bytes) {
  const std::uint64_t bytes = checkedFileSize(file);
  if (!head) refuse<MessageId::tiles_no_geotiff>(file);
  checkLayout(*head, file, cell_bytes, bands);
  size_ = {.cols = static_cast<int>(head->cols), .rows = static_cast<int>(head->rows)};
  facts_ = head->facts;
  offsets_ = head->tile_offsets;
  const auto tiles = static_cast<std::uint64_t>(TileLayout{size_}.count());
  const bool all_there = bytes >= tileBytes() &&
                         offsets_.size() == tiles * static_cast<std::uint64_t>(bands) &&
                         std::all_of(offsets_.begin(), offsets_.end(), [&](std::uint64_t offset) {
                           return offset != 0 && offset <= bytes - tileBytes();
                         });
  if (!all_there) refuse<MessageId::tile_missing>(file);
  fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd_ < 0) refuse<MessageId::quoted>(file, std::strerror(errno));
}

TileRaster::~TileRaster() {
  if (fd_ >= 0) ::close(fd_);
}

std::size_t TileRaster::tileBytes() const noexcept {
  return static_cast<std::size_t>(kTileSide) * kTileSide * cell_bytes_;
}

int TileRaster::tilesAcross() const noexcept {
  return TileLayout{size_}.across();
}

void TileRaster::read(int band, int tile, std::span<std::byte> out) const {
  const auto tiles = static_cast<std::size_t>(TileLayout{size_}.count());
  std::uint64_t at =
      offsets_[static_cast<std::size_t>(band) * tiles + static_cast<std::size_t>(tile)];
  while (!out.empty()) {
    const ssize_t got = ::pread(fd_, out.data(), out.size(), static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) refuse<MessageId::tiles_became_shorter>(file_);
    at += static_cast<std::uint64_t>(got);
    out = out.subspan(static_cast<std::size_t>(got));
  }
}

RasterFacts rasterFacts(const std::filesystem::path& file) {
  try {
    auto head = importTiffHead(file);
    return head ? std::move(head->facts) : RasterFacts{};
  } catch (const FileError&) {  // Whoever reads it says so.
    return {};
  }
}

}  // namespace relievo
