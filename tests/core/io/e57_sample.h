// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/core/io/sample_files.h"

namespace relievo::test {

/// Numbers packed lowest bit first, as E57 stores them.
class PackedBits {
 public:
  void add(std::uint64_t value, unsigned bits) {
    for (unsigned i = 0; i < bits; ++i, ++count_) {
      if (count_ % 8 == 0) bytes_ += '\0';
      const auto bit = static_cast<unsigned>(value >> i & 1U) << (count_ % 8);
      bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | bit);
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  unsigned count_ = 0;
};

struct E57SampleField {
  std::string name, attributes;
  std::string stream;
};

struct E57SampleScan {
  std::string records;
  std::vector<E57SampleField> fields;
  std::string pose;
  std::string codecs;
  std::size_t share = 1000;  ///< Bytes of every stream in one packet; streams may end early.
  std::string name = {};     ///< Written as it is, inside the element.
};

/// Slow and simple on purpose: the reader has its own.
inline std::uint32_t checksumBitByBit(const std::string& bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0x82F63B78U : 0U);
  }
  return ~crc;
}

/// Writes E57 files; what the test changes between writing and `file` makes the hostile ones.
class E57Sample {
 public:
  void add(const E57SampleScan& scan) {
    const std::size_t section = logical_.size();
    sections_.push_back(section);
    std::string packets = indexPacket();
    for (std::size_t at = 0; at == 0 || at < longest(scan); at += scan.share) {
      packets += dataPacket(scan, at);
    }
    logical_ += "\1" + std::string(7, '\0') +
                bytesOf(static_cast<std::uint64_t>(32 + packets.size())) +
                bytesOf(physical(section + 32)) + bytesOf(std::uint64_t{0}) + packets;
    const std::string name =
        scan.name.empty() ? "" : "<name type=\"String\">" + scan.name + "</name>";
    scans_ += "<vectorChild type=\"Structure\">" + name + scan.pose +
              R"(<points type="CompressedVector" fileOffset=")" +
              std::to_string(physical(section)) + "\" recordCount=\"" + scan.records +
              R"("><prototype type="Structure">)";
    for (const E57SampleField& field : scan.fields) {
      scans_ += "<" + field.name + " " + field.attributes + "/>";
    }
    scans_ +=
        "</prototype><codecs type=\"Vector\">" + scan.codecs + "</codecs></points></vectorChild>\n";
  }

  std::string xml() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" "
           "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\">\n<data3D type=\"Vector\">" +
           scans_ + "</data3D></e57Root>\n";
  }

  std::string file() const { return fileWith(xml()); }

  /// Logical places of the scans' binary sections.
  const std::vector<std::size_t>& sections() const { return sections_; }

  std::string fileWith(const std::string& xml_text) const {
    std::string logical = logical_ + xml_text;
    const std::size_t pages = (logical.size() + kPayload - 1) / kPayload;
    logical.resize(pages * kPayload, '\0');
    const std::string head =
        "ASTM-E57" + bytesOf(std::uint32_t{1}) + bytesOf(std::uint32_t{0}) +
        bytesOf(static_cast<std::uint64_t>(pages * 1024)) + bytesOf(physical(logical_.size())) +
        bytesOf(static_cast<std::uint64_t>(xml_text.size())) + bytesOf(std::uint64_t{1024});
    logical.replace(0, head.size(), head);
    std::string bytes;
    for (std::size_t page = 0; page < pages; ++page) {
      bytes += withChecksum(logical.substr(page * kPayload, kPayload));
    }
    return bytes;
  }

  /// The same file with other bytes at a logical place, and right checksums.
  static std::string changed(const std::string& bytes, std::size_t logical,
                             const std::string& value) {
    std::string result = bytes;
    result.replace(static_cast<std::size_t>(physical(logical)), value.size(), value);
    std::string sealed;
    for (std::size_t at = 0; at + 1024 <= result.size(); at += 1024) {
      sealed += withChecksum(result.substr(at, kPayload));
    }
    return sealed;
  }

  static std::uint64_t physical(std::size_t logical) {
    return logical / kPayload * 1024 + logical % kPayload;
  }

 private:
  static constexpr std::size_t kPayload = 1020;

  static std::string withChecksum(const std::string& payload) {
    return payload + bytesOf(checksumBitByBit(payload), true);
  }
  static std::size_t longest(const E57SampleScan& scan) {
    std::size_t bytes = 0;
    for (const E57SampleField& field : scan.fields) bytes = std::max(bytes, field.stream.size());
    return bytes;
  }
  static std::string indexPacket() {
    return std::string(2, '\0') + bytesOf(std::uint16_t{15}) + std::string(12, '\0');
  }
  static std::string dataPacket(const E57SampleScan& scan, std::size_t at) {
    std::string lengths, streams;
    for (const E57SampleField& field : scan.fields) {
      const std::string part =
          at < field.stream.size() ? field.stream.substr(at, scan.share) : std::string();
      lengths += bytesOf(static_cast<std::uint16_t>(part.size()));
      streams += part;
    }
    std::string packet =
        bytesOf(static_cast<std::uint16_t>(scan.fields.size())) + lengths + streams;
    packet.resize((packet.size() + 7) / 4 * 4 - 4, '\0');
    return "\1" + std::string(1, '\0') + bytesOf(static_cast<std::uint16_t>(packet.size() + 3)) +
           packet;
  }

  std::string logical_ = std::string(48, '\0');
  std::string scans_;
  std::vector<std::size_t> sections_;
};

}  // namespace relievo::test
