// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/answer_text.h"

#include <cmath>
#include <cstring>

#include "core/io/worker/planted_fault.h"

namespace relievo {

void Unpacker::take(void* out, std::size_t bytes) {
  if (bytes_.size() - at_ < bytes) {
    good_ = false;
    return;
  }
  std::memcpy(out, bytes_.data() + at_, bytes);
  at_ += bytes;
}

std::string Unpacker::text() {
  const auto size = get<std::uint64_t>();
  if (size > bytes_.size() - at_) {
    good_ = false;
    return {};
  }
  at_ += static_cast<std::size_t>(size);
  return bytes_.substr(at_ - static_cast<std::size_t>(size), static_cast<std::size_t>(size));
}

void pack(const LasSystem& system, Packer& packer) {
  packer.put(static_cast<std::int64_t>(system.code));
  packer.put(
      static_cast<std::int64_t>(system.height_unit ? static_cast<int>(*system.height_unit) : -1));
}

bool unpack(Unpacker& unpacker, LasSystem& system) {
  constexpr std::int64_t kMostCode = 0xFFFF;
  const auto code = unpacker.get<std::int64_t>();
  const auto unit = unpacker.get<std::int64_t>();
  if (!unpacker.good() || code < 0 || code > kMostCode ||
      unit >= static_cast<std::int64_t>(kLengthUnits.size())) {
    return false;
  }
  system.code = static_cast<int>(code);
  if (unit >= 0) system.height_unit = static_cast<LengthUnit>(unit);
  return true;
}

void pack(const ScanInfo& info, Packer& packer) {
  packer.put(info.points);
  packer.put(info.finite_points);
  packer.put(info.faces);
  packer.put(info.dropped_faces);
  packer.put(info.bounds.value_or(FileBounds{}));
  packer.put(static_cast<std::uint64_t>(info.bounds.has_value()));
  packer.put(static_cast<std::int64_t>(info.unit ? static_cast<int>(*info.unit) : -1));
  packer.put(info.format);
  packer.put(info.reader);
  packer.put(info.reference_system);
  packer.put(info.withheld);
  packer.put(info.height_step);
  packer.put(static_cast<std::uint64_t>(info.colour.has_value()));
  if (info.colour) {
    packer.put(info.colour->source);
    packer.put(static_cast<std::int64_t>(info.colour->bits));
    packer.put(info.colour->points);
  }
  packer.put(static_cast<std::uint64_t>(info.intensity.has_value()));
  packer.put(info.intensity.value_or(IntensityRange{}));
  packer.put(static_cast<std::uint64_t>(info.parts.size()));
  for (const ScanPart& part : info.parts) {
    packer.put(part.name);
    packer.put(part.points);
    packer.put(static_cast<std::uint64_t>(part.viewpoint.has_value()));
    packer.put(part.viewpoint.value_or(FilePoint{}));
  }
  packer.put(static_cast<std::uint64_t>(info.warnings.size()));
  for (const Message& warning : info.warnings) packer.put(messageBytes(warning));
}

namespace {

/// What a file says of its points beside their places. @return  false if it makes no sense
bool unpackValues(Unpacker& unpacker, ScanInfo& info) {
  constexpr std::uint64_t kMostParts = 256;
  info.reader = unpacker.text();
  info.reference_system = unpacker.text();
  info.withheld = unpacker.get<std::uint64_t>();
  info.height_step = unpacker.get<double>();
  if (!std::isfinite(info.height_step) || info.height_step < 0) return false;
  if (unpacker.get<std::uint64_t>() != 0) {
    ColourFact fact;
    fact.source = unpacker.text();
    const auto bits = unpacker.get<std::int64_t>();
    fact.points = unpacker.get<std::uint64_t>();
    if (bits != 8 && bits != 16 && bits != 32) return false;
    fact.bits = static_cast<int>(bits);
    info.colour = fact;
  }
  const bool has_intensity = unpacker.get<std::uint64_t>() != 0;
  const auto range = unpacker.get<IntensityRange>();
  if (has_intensity) {
    const bool usable =
        std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high;
    if (!usable) return false;
    info.intensity = range;
  }
  const auto parts = unpacker.get<std::uint64_t>();
  if (parts > kMostParts) return false;
  for (std::uint64_t i = 0; i < parts && unpacker.good(); ++i) {
    ScanPart part;
    part.name = unpacker.text();
    part.points = unpacker.get<std::uint64_t>();
    const bool has_viewpoint = unpacker.get<std::uint64_t>() != 0;
    const auto viewpoint = unpacker.get<FilePoint>();
    if (has_viewpoint && !isFinite(viewpoint)) return false;
    if (has_viewpoint) part.viewpoint = viewpoint;
    info.parts.push_back(std::move(part));
  }
  return unpacker.good();
}

}  // namespace

bool unpack(Unpacker& unpacker, ScanInfo& info) {
  info.points = unpacker.get<std::uint64_t>();
  info.finite_points = unpacker.get<std::uint64_t>();
  info.faces = unpacker.get<std::uint64_t>();
  info.dropped_faces = unpacker.get<std::uint64_t>();
  const auto bounds = unpacker.get<FileBounds>();
  if (unpacker.get<std::uint64_t>() != 0) info.bounds = bounds;
  const auto unit = unpacker.get<std::int64_t>();
  if (unit >= static_cast<std::int64_t>(kLengthUnits.size())) return false;
  if (unit >= 0) info.unit = static_cast<LengthUnit>(unit);
  info.format = unpacker.text();
  if (!unpackValues(unpacker, info)) return false;
  const auto warnings = unpacker.get<std::uint64_t>();
  plantedFault(warnings == 5);
  for (std::uint64_t i = 0; i < warnings && unpacker.good(); ++i) {
    auto warning = messageFromBytes(unpacker.text());
    if (!warning) return false;
    info.warnings.push_back(*std::move(warning));
  }
  return unpacker.good();
}

}  // namespace relievo
