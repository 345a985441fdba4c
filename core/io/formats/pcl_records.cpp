// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees PCL. Never compile it with AVX flags: Debian's PCL aligns to 16 bytes.
#include "core/io/formats/pcl_records.h"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/pcl_config.h>
#include <pcl/PCLPointCloud2.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/bands.h"
#include "core/base/error.h"
#include "core/file/owned_fd.h"
#include "core/io/worker/scan_transport.h"

namespace relievo {
namespace {

/// Of records in the processor's nearer memory, and small enough for PCL's 32-bit sums.
constexpr std::uint64_t kPcdBlock = 16384;
constexpr std::uint64_t kPlyBlock = 65536;

std::uint8_t pclType(ScalarType type) {
  using Field = pcl::PCLPointField;
  constexpr std::array<int, 10> kTypes{Field::INT8,    Field::UINT8,  Field::INT16, Field::UINT16,
                                       Field::INT32,   Field::UINT32, Field::INT64, Field::UINT64,
                                       Field::FLOAT32, Field::FLOAT64};
  return static_cast<std::uint8_t>(kTypes[static_cast<std::size_t>(type)]);
}

pcl::PCLPointField fieldOf(const StoredNumber& number, std::size_t count = 1) {
  pcl::PCLPointField field;
  field.offset = static_cast<pcl::uindex_t>(number.offset);
  field.datatype = pclType(number.type);
  field.count = static_cast<pcl::uindex_t>(count);
  return field;
}

/// PCL walks over all listed fields to see whether points are finite, so only those are listed that
/// are read. A colour is listed as a whole number: as a float many of them are no numbers.
std::vector<pcl::PCLPointField> fieldsOf(const RecordLayout& layout) {
  std::vector<pcl::PCLPointField> fields;
  for (const StoredNumber& number : layout.xyz) fields.push_back(fieldOf(number));
  if (layout.packed_colour) {
    fields.push_back(fieldOf({*layout.packed_colour, ScalarType::u32}));
  }
  if (layout.colour) {
    for (const StoredNumber& number : *layout.colour) fields.push_back(fieldOf(number));
  }
  if (layout.intensity) fields.push_back(fieldOf(*layout.intensity));
  // Names steer PCL; ours mean nothing to it.
  for (std::size_t i = 0; i < fields.size(); ++i) fields[i].name = "f" + std::to_string(i);
  return fields;
}

void shape(pcl::PCLPointCloud2& cloud, std::uint64_t points, std::size_t record_bytes) {
  cloud.width = static_cast<pcl::uindex_t>(points);
  cloud.height = 1;
  cloud.point_step = static_cast<pcl::uindex_t>(record_bytes);
  cloud.row_step = static_cast<pcl::uindex_t>(points * record_bytes);
  cloud.data.resize(points * record_bytes);
}

const unsigned char* bytesOf(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}
const char* charsOf(const pcl::PCLPointCloud2& cloud) {
  return reinterpret_cast<const char*>(cloud.data.data());
}

void readPcdRecords(const PcdHeader& header, std::string_view records, std::uint64_t count,
                    const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  pcl::PCDReader reader;
  pcl::PCLPointCloud2 cloud;
  cloud.fields = fieldsOf(layout);
  // Long records in smaller blocks, so that sums of bytes stay small.
  const std::uint64_t at_once =
      std::clamp<std::uint64_t>((std::uint64_t{64} << 20U) / layout.bytes, 1, kPcdBlock);
  for (std::uint64_t done = 0; done < count; done += at_once) {
    const std::uint64_t block = std::min(at_once, count - done);
    shape(cloud, block, layout.bytes);
    if (reader.readBodyBinary(bytesOf(records.substr(done * layout.bytes)), cloud, 0, false, 0) <
        0) {
      throw FileError("PCL gave up on its points. Give --reader own.");
    }
    take(columnsOf(layout, charsOf(cloud)), block);
  }
}

bool readPcdCompressed(const PcdHeader& header, std::string_view body, const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  pcl::PCDReader reader;
  pcl::PCLPointCloud2 cloud;
  // All fields, because their order says where each column begins.
  for (const PcdField& field : header.fields) {
    cloud.fields.push_back(fieldOf({static_cast<std::size_t>(field.offset), field.type},
                                   static_cast<std::size_t>(field.count)));
    cloud.fields.back().name = "f" + std::to_string(cloud.fields.size());
  }
  shape(cloud, header.points, layout.bytes);
  if (reader.readBodyBinary(bytesOf(body), cloud, 0, true, 0) < 0) return false;
  if (cloud.data.size() != header.points * layout.bytes) return false;
  const PointColumns columns = columnsOf(layout, charsOf(cloud));
  take(columns, header.points);
  return true;
}

const char* plyType(ScalarType type) {
  constexpr std::array<const char*, 10> kNames{"int8",   "uint8", "int16",  "uint16",  "int32",
                                               "uint32", "int64", "uint64", "float32", "float64"};
  return kNames[static_cast<std::size_t>(type)];
}

/// Records as PCL is told of them: every property costs PCL the same, so they are few and wide. In
/// this machine's order they need no turning, and rows of one to eight records are told as eight
/// bytes after eight; else what is read is told as it is and what lies between as wide numbers.
/// Names mean nothing to it.
class PlyForm {
 public:
  explicit PlyForm(const RecordLayout& layout) {
    constexpr std::size_t kWord = 8;
    if (layout.order == ByteOrder::little) {
      row_records_ = kWord / std::gcd(kWord, layout.bytes);
      skipTo(row_records_ * layout.bytes);
      return;
    }
    std::vector<StoredNumber> wanted(layout.xyz.begin(), layout.xyz.end());
    if (layout.colour) wanted.insert(wanted.end(), layout.colour->begin(), layout.colour->end());
    if (layout.intensity) wanted.push_back(*layout.intensity);
    std::sort(wanted.begin(), wanted.end(),
              [](const StoredNumber& a, const StoredNumber& b) { return a.offset < b.offset; });
    for (const StoredNumber& number : wanted) {
      skipTo(number.offset);
      add(number.type);
    }
    skipTo(layout.bytes);
  }

  std::string header(std::uint64_t points, ByteOrder order) const {
    std::string text = std::string("ply\nformat binary_") +
                       (order == ByteOrder::big ? "big" : "little") +
                       "_endian 1.0\nelement vertex " + std::to_string(rowsOf(points)) + "\n";
    for (std::size_t i = 0; i < types_.size(); ++i) {
      text += std::string("property ") + plyType(types_[i]) + " p" + std::to_string(i) + "\n";
    }
    return text + "end_header\n";
  }
  std::size_t properties() const noexcept { return types_.size(); }
  std::size_t rowBytes() const noexcept { return end_; }
  /// That hold so many records; the last one may be filled up.
  std::uint64_t rowsOf(std::uint64_t records) const noexcept {
    return (records + row_records_ - 1) / row_records_;
  }
  /// Of the property that begins there in the file's record.
  std::size_t propertyAt(std::size_t offset) const {
    return static_cast<std::size_t>(std::find(offsets_.begin(), offsets_.end(), offset) -
                                    offsets_.begin());
  }

 private:
  void add(ScalarType type) {
    offsets_.push_back(end_);
    types_.push_back(type);
    end_ += byteSize(type);
  }
  void skipTo(std::size_t offset) {
    while (end_ + 8 <= offset) add(ScalarType::f64);
    if (end_ + 4 <= offset) add(ScalarType::i32);
    if (end_ + 2 <= offset) add(ScalarType::i16);
    if (end_ < offset) add(ScalarType::u8);
  }
  std::vector<ScalarType> types_;
  std::vector<std::size_t> offsets_;
  std::size_t end_ = 0;
  std::size_t row_records_ = 1;
};

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Reads a block of records at a time through a file in memory, the only way into PCL's reader.
class PlyBlocks {
 public:
  PlyBlocks(const PlyForm& form, const RecordLayout& file_layout)
      : form_(form),
        file_layout_(file_layout),
        memory_(::memfd_create("relievo-ply", MFD_CLOEXEC)),
        path_("/proc/self/fd/" + std::to_string(memory_.get())) {}

  /// Reads `count` records, on any thread. @throw FileError  PCL cannot
  void read(std::string_view records, std::uint64_t count) {
    count_ = count;
    const std::uint64_t rows = form_.rowsOf(count);
    const std::string header = form_.header(count, file_layout_.order);
    const std::string_view own = records.substr(0, count * file_layout_.bytes);
    const std::string filling(rows * form_.rowBytes() - own.size(), '\0');
    const std::size_t all = header.size() + own.size() + filling.size();
    pcl::PLYReader reader;
    // Cut to its length when it is written: what the block before left need not be made again.
    errno = 0;
    const bool written = memory_.get() >= 0 && ::lseek(memory_.get(), 0, SEEK_SET) == 0 &&
                         writeAll(memory_.get(), header) && writeAll(memory_.get(), own) &&
                         writeAll(memory_.get(), filling) &&
                         ::ftruncate(memory_.get(), static_cast<off_t>(all)) == 0;
    if (!written && errno == EFBIG) refuseLength();
    const bool read = written && reader.read(path_, cloud_) >= 0;
    if (!read || cloud_.fields.size() != form_.properties() ||
        cloud_.point_step != form_.rowBytes() ||
        std::uint64_t{cloud_.width} * cloud_.height != rows ||
        cloud_.data.size() < rows * form_.rowBytes()) {
      throw FileError("PCL gave up on its points. Give --reader own.");
    }
  }
  /// What was read last.
  void give(const TakeColumns& take) const {
    if (file_layout_.order == ByteOrder::little) {
      return take(columnsOf(file_layout_, charsOf(cloud_)), count_);
    }
    const auto moved = [&](const StoredNumber& number) {
      return StoredNumber{cloud_.fields[form_.propertyAt(number.offset)].offset, number.type};
    };
    RecordLayout layout;  // PCL has turned all numbers to this machine's order.
    layout.bytes = cloud_.point_step;
    for (std::size_t k = 0; k < 3; ++k) layout.xyz[k] = moved(file_layout_.xyz[k]);
    if (file_layout_.colour) {
      layout.colour = std::array{moved((*file_layout_.colour)[0]), moved((*file_layout_.colour)[1]),
                                 moved((*file_layout_.colour)[2])};
    }
    if (file_layout_.intensity) layout.intensity = moved(*file_layout_.intensity);
    take(columnsOf(layout, charsOf(cloud_)), count_);
  }

 private:
  const PlyForm& form_;
  const RecordLayout& file_layout_;
  OwnedFd memory_;
  std::string path_;
  pcl::PCLPointCloud2 cloud_;
  std::uint64_t count_ = 0;
};

/// PCL asks a stream for every number, which takes longer than all else: blocks are read side by
/// side, and given in their order.
void readPlyRecords(const PlyHeader& header, std::string_view records, std::uint64_t count,
                    const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  const PlyForm form(layout);
  const auto blocks = static_cast<int>((count + kPlyBlock - 1) / kPlyBlock);
  const int readers = std::min(threadsFor(static_cast<std::size_t>(count), 0), std::max(blocks, 1));
  std::vector<std::unique_ptr<PlyBlocks>> own;
  own.reserve(static_cast<std::size_t>(readers));
  for (int i = 0; i < readers; ++i) own.push_back(std::make_unique<PlyBlocks>(form, layout));
  for (int first = 0; first < blocks; first += readers) {
    const int now = std::min(readers, blocks - first);
    inBands(now, now, [&](int reader, int) {
      const std::uint64_t done = kPlyBlock * static_cast<std::uint64_t>(first + reader);
      own[static_cast<std::size_t>(reader)]->read(records.substr(done * layout.bytes),
                                                  std::min(kPlyBlock, count - done));
    });
    for (int i = 0; i < now; ++i) own[static_cast<std::size_t>(i)]->give(take);
  }
}

}  // namespace

const PclLibrary& pclLibrary() {
  // What PCL prints would become the last words of the import program.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  static constexpr PclLibrary kLibrary{"PCL " PCL_VERSION_PRETTY, readPcdRecords, readPcdCompressed,
                                       readPlyRecords};
  return kLibrary;
}

}  // namespace relievo
