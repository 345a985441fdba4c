// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/ply_bytes.h"

#include <array>
#include <bit>
#include <cstring>

namespace relievo::samples {
namespace {

static_assert(std::endian::native == std::endian::little, "plyBytes writes the machine's order");

std::string header(const Cloud& cloud) {
  const std::string type = cloud.double_precision ? "double" : "float";
  return "ply\nformat binary_little_endian 1.0\ncomment unit " + cloud.unit +
         "\ncomment made by relievo-generate-samples\nelement vertex " +
         std::to_string(cloud.points.size()) + "\nproperty " + type + " x\nproperty " + type +
         " y\nproperty " + type + " z\nend_header\n";
}

template <class Scalar>
void append(std::string& bytes, const std::array<double, 3>& point) {
  for (const double value : point) {
    const auto stored = static_cast<Scalar>(value);
    std::array<char, sizeof(Scalar)> raw{};
    std::memcpy(raw.data(), &stored, sizeof(Scalar));
    bytes.append(raw.data(), raw.size());
  }
}

}  // namespace

std::size_t plyRecordBytes(const Cloud& cloud) {
  return 3 * (cloud.double_precision ? sizeof(double) : sizeof(float));
}

std::string plyBytes(const Cloud& cloud) {
  std::string bytes = header(cloud);
  bytes.reserve(bytes.size() + cloud.points.size() * plyRecordBytes(cloud));
  for (const auto& point : cloud.points) {
    if (cloud.double_precision) {
      append<double>(bytes, point);
    } else {
      append<float>(bytes, point);
    }
  }
  return bytes;
}

std::string truncatedPlyBytes(const Cloud& cloud) {
  const std::size_t half_a_record = plyRecordBytes(cloud) / 2;
  const std::size_t kept = cloud.points.size() / 2 * plyRecordBytes(cloud) + half_a_record;
  return plyBytes(cloud).substr(0, header(cloud).size() + kept);
}

}  // namespace relievo::samples
