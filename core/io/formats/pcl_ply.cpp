// SPDX-License-Identifier: BSD-3-Clause
// PLY by PCL's own parser, pcl::io::ply::ply_parser: the library of it needs none of those
// that PLYReader brings, so that relievo-import has it (docs/adr/0168-sooner-from-file-to-map.md).
#include "core/io/formats/pcl_records.h"

#include <pcl/io/ply/ply_parser.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/bands.h"
#include "core/file/owned_fd.h"
#include "core/io/worker/scan_transport.h"

namespace relievo {
namespace {

constexpr std::uint64_t kBlock = 65536;  ///< Records in the processor's nearer memory.

const char* plyType(ScalarType type) {
  constexpr std::array<const char*, 10> kNames{"int8",   "uint8", "int16",  "uint16",  "int32",
                                               "uint32", "int64", "uint64", "float32", "float64"};
  return kNames[static_cast<std::size_t>(type)];
}

/// Records as PCL is told of them: every property costs PCL the same, so they are few and wide. In
/// this machine's order they need no turning, and rows of one to eight records are told as eight
/// bytes after eight; else what is read is told as it is and what lies between as wide numbers.
/// Names mean nothing to it. Every number keeps its place.
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
  std::size_t rowBytes() const noexcept { return end_; }
  /// That hold so many records; the last one may be filled up.
  std::uint64_t rowsOf(std::uint64_t records) const noexcept {
    return (records + row_records_ - 1) / row_records_;
  }

 private:
  void add(ScalarType type) {
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
  std::size_t end_ = 0;
  std::size_t row_records_ = 1;
};

/// Where numbers go one after the other, in this machine's order.
class Numbers {
 public:
  void expect(std::size_t bytes) {
    bytes_.resize(bytes);
    at_ = 0;
    has_more_ = false;
  }
  template <class Scalar>
  void take(Scalar number) {
    if (sizeof(number) > bytes_.size() - at_) {
      has_more_ = true;
      return;
    }
    std::memcpy(bytes_.data() + at_, &number, sizeof(number));
    at_ += sizeof(number);
  }
  bool isFull() const noexcept { return at_ == bytes_.size() && !has_more_; }
  const char* data() const noexcept { return bytes_.data(); }

 private:
  std::vector<char> bytes_;
  std::size_t at_ = 0;
  bool has_more_ = false;  ///< Than PCL was told of.
};

/// All properties of one type go to `numbers`.
template <class Scalar>
void takeAll(pcl::io::ply::ply_parser::scalar_property_definition_callbacks_type& callbacks,
             Numbers& numbers) {
  callbacks.get<Scalar>() = [&numbers](const std::string&, const std::string&) {
    return [&numbers](Scalar number) { numbers.take(number); };
  };
}

bool parseWith(const std::string& path, Numbers& numbers) {
  namespace ply = pcl::io::ply;
  ply::ply_parser parser;
  ply::ply_parser::scalar_property_definition_callbacks_type callbacks;
  takeAll<ply::int8>(callbacks, numbers);
  takeAll<ply::uint8>(callbacks, numbers);
  takeAll<ply::int16>(callbacks, numbers);
  takeAll<ply::uint16>(callbacks, numbers);
  takeAll<ply::int32>(callbacks, numbers);
  takeAll<ply::uint32>(callbacks, numbers);
  takeAll<ply::float32>(callbacks, numbers);
  takeAll<ply::float64>(callbacks, numbers);
  parser.scalar_property_definition_callbacks(callbacks);
  // Nothing is to be done where rows begin and end.
  parser.element_definition_callback(
      [](const std::string&, std::size_t) { return ply::ply_parser::element_callbacks_type{}; });
  return parser.parse(path);
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Reads a block of records at a time through a file in memory, the only way into PCL's parser.
class PlyBlocks {
 public:
  PlyBlocks(const PlyForm& form, const RecordLayout& file_layout)
      : form_(form),
        layout_(file_layout),
        file_order_(file_layout.order),
        memory_(::memfd_create("relievo-ply", MFD_CLOEXEC)),
        path_("/proc/self/fd/" + std::to_string(memory_.get())) {
    layout_.order = ByteOrder::little;  // PCL turns all numbers to this machine's order.
  }

  /// Reads `count` records, on any thread. @return  false if PCL cannot
  bool read(std::string_view records, std::uint64_t count) {
    count_ = count;
    const std::uint64_t rows = form_.rowsOf(count);
    const std::string header = form_.header(count, file_order_);
    const std::string_view own = records.substr(0, count * layout_.bytes);
    const std::string filling(rows * form_.rowBytes() - own.size(), '\0');
    const std::size_t all = header.size() + own.size() + filling.size();
    // Cut to its length when it is written: what the block before left need not be made again.
    errno = 0;
    const bool written = memory_.get() >= 0 && ::lseek(memory_.get(), 0, SEEK_SET) == 0 &&
                         writeAll(memory_.get(), header) && writeAll(memory_.get(), own) &&
                         writeAll(memory_.get(), filling) &&
                         ::ftruncate(memory_.get(), static_cast<off_t>(all)) == 0;
    if (!written && errno == EFBIG) refuseLength();
    numbers_.expect(rows * form_.rowBytes());
    return written && parseWith(path_, numbers_) && numbers_.isFull();
  }
  /// What was read last.
  void give(const TakeColumns& take) const { take(columnsOf(layout_, numbers_.data()), count_); }

 private:
  const PlyForm& form_;
  RecordLayout layout_;
  ByteOrder file_order_;
  OwnedFd memory_;
  std::string path_;
  Numbers numbers_;
  std::uint64_t count_ = 0;
};

/// One after the other, whoever they are. [any thread]
class Turns {
 public:
  /// work() when all before `number` had theirs. @return  false: one of them failed, nothing is
  /// done; whatever `work` throws fails all after it
  template <class Work>
  bool take(int number, const Work& work) {
    for (int now = next_.load(); now != number; now = next_.load()) {
      if (now == kFailed) return false;
      next_.wait(now);
    }
    try {
      work();
    } catch (...) {
      fail();
      throw;
    }
    int own = number;
    next_.compare_exchange_strong(own, number + 1);  // Unless a later one failed meanwhile.
    next_.notify_all();
    return true;
  }
  void fail() {
    next_.store(kFailed);
    next_.notify_all();
  }

 private:
  static constexpr int kFailed = -1;
  std::atomic<int> next_{0};
};

/// PCL asks a stream for every number, which takes longer than all else: blocks are read side by
/// side, and given in their order.
bool readPlyRecords(const PlyHeader& header, std::string_view records, std::uint64_t count,
                    const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  const PlyForm form(layout);
  const auto blocks = static_cast<int>((count + kBlock - 1) / kBlock);
  const int readers = std::min(threadsFor(static_cast<std::size_t>(count), 0), std::max(blocks, 1));
  std::vector<std::unique_ptr<PlyBlocks>> own;
  own.reserve(static_cast<std::size_t>(readers));
  for (int i = 0; i < readers; ++i) own.push_back(std::make_unique<PlyBlocks>(form, layout));
  Turns turns;
  std::atomic<bool> gave_up{false};
  parallelFor(readers, readers, [&](int reader, int) {
    PlyBlocks& mine = *own[static_cast<std::size_t>(reader)];
    for (int block = reader; block < blocks; block += readers) {
      const std::uint64_t done = kBlock * static_cast<std::uint64_t>(block);
      try {
        if (!mine.read(records.substr(done * layout.bytes), std::min(kBlock, count - done))) {
          gave_up.store(true);
          return turns.fail();
        }
      } catch (...) {
        turns.fail();
        throw;
      }
      if (!turns.take(block, [&] { mine.give(take); })) return;
    }
  });
  return !gave_up.load();
}

}  // namespace

const PclLibrary& pclPlyLibrary() {
  static constexpr PclLibrary kLibrary{"PCL " PCL_VERSION_PRETTY, nullptr, nullptr, readPlyRecords};
  return kLibrary;
}

}  // namespace relievo
