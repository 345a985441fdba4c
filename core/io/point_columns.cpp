// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_columns.h"

#include <algorithm>

#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::uint64_t kAtOnce = 1 << 16;

Column columnOf(const StoredNumber& number, const RecordLayout& layout, const char* records) {
  return {records + number.offset, layout.bytes, number.type};
}

bool areBytes(const std::array<Column, 3>& colour) {
  return std::all_of(colour.begin(), colour.end(),
                     [](const Column& c) { return c.type == ScalarType::u8; });
}

/// The next point. A function of its own for each kind of coordinates, so that the usual ones do
/// not ask for their type a million times.
struct AnyPoint {
  bool operator()(const PointColumns& c, std::uint64_t i, ScanBuilder& builder) const {
    return builder.addPoint(c.xyz[0].at(i, c.order), c.xyz[1].at(i, c.order),
                            c.xyz[2].at(i, c.order));
  }
};
struct FloatPoint {
  bool operator()(const PointColumns& c, std::uint64_t i, ScanBuilder& builder) const {
    const auto number = [&](std::size_t axis) {
      return static_cast<double>(
          loadAs<float>(c.xyz[axis].first + i * c.xyz[axis].stride, ByteOrder::little));
    };
    return builder.addPoint(number(0), number(1), number(2));
  }
};

void addValues(const PointColumns& c, std::uint64_t i, bool bytes, ScanBuilder& builder) {
  if (c.packed_colour.first != nullptr) {
    const auto packed =
        loadAs<std::uint32_t>(c.packed_colour.first + i * c.packed_colour.stride, c.order);
    builder.addColour(static_cast<std::uint8_t>(packed >> 16U),
                      static_cast<std::uint8_t>(packed >> 8U), static_cast<std::uint8_t>(packed));
  } else if (bytes) {
    const auto channel = [&](std::size_t k) {
      return static_cast<std::uint8_t>(c.colour[k].first[i * c.colour[k].stride]);
    };
    builder.addColour(channel(0), channel(1), channel(2));
  } else if (c.colour[0].first != nullptr) {
    builder.addWideColour({static_cast<float>(c.colour[0].at(i, c.order)),
                           static_cast<float>(c.colour[1].at(i, c.order)),
                           static_cast<float>(c.colour[2].at(i, c.order))});
  }
  if (c.intensity.first != nullptr) {
    builder.addWideIntensity(static_cast<float>(c.intensity.at(i, c.order)));
  }
}

template <class AddPoint>
void addAll(const PointColumns& columns, std::uint64_t count, ScanBuilder& builder,
            const AddPoint& addPoint) {
  const bool has_colour = columns.colour[0].first != nullptr;
  const bool has_values =
      has_colour || columns.packed_colour.first != nullptr || columns.intensity.first != nullptr;
  if (!has_values) {
    for (std::uint64_t i = 0; i < count; ++i) addPoint(columns, i, builder);
    return;
  }
  const bool bytes = has_colour && areBytes(columns.colour);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (addPoint(columns, i, builder)) addValues(columns, i, bytes, builder);
  }
}

/// Three floats after three floats, and no values.
bool isPointsAlone(const PointColumns& c) {
  constexpr std::size_t kFloat = sizeof(float);
  return c.xyz[0].stride == 3 * kFloat && c.xyz[1].first == c.xyz[0].first + kFloat &&
         c.xyz[2].first == c.xyz[0].first + 2 * kFloat && c.colour[0].first == nullptr &&
         c.packed_colour.first == nullptr && c.intensity.first == nullptr;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return out;
}

}  // namespace

PointColumns columnsOf(const RecordLayout& layout, const char* records) {
  PointColumns columns{
      .order = layout.order, .xyz = {}, .colour = {}, .packed_colour = {}, .intensity = {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.xyz[axis] = columnOf(layout.xyz[axis], layout, records);
    if (layout.colour) columns.colour[axis] = columnOf((*layout.colour)[axis], layout, records);
  }
  if (layout.packed_colour) {
    columns.packed_colour = columnOf({*layout.packed_colour, ScalarType::u32}, layout, records);
  }
  if (layout.intensity) columns.intensity = columnOf(*layout.intensity, layout, records);
  return columns;
}

bool hasByteColours(const RecordLayout& layout) noexcept {
  return layout.packed_colour ||
         (layout.colour &&
          std::all_of(layout.colour->begin(), layout.colour->end(),
                      [](const StoredNumber& n) { return n.type == ScalarType::u8; }));
}

void expectRecords(const RecordLayout& layout, std::uint64_t count, bool bytes,
                   ScanBuilder& builder) {
  builder.expectPoints(count);
  if (layout.hasColour()) {
    builder.expectColours(count, bytes);
    builder.info().colour = ColourFact{.source = layout.colour_source, .bits = 8, .points = 0};
  }
  if (layout.intensity) builder.expectIntensities(count, false);
}

void addColumns(const PointColumns& columns, std::uint64_t count, ScanBuilder& builder) {
  const bool floats = columns.order == ByteOrder::little &&
                      std::all_of(columns.xyz.begin(), columns.xyz.end(),
                                  [](const Column& c) { return c.type == ScalarType::f32; });
  if (floats && isPointsAlone(columns)) {
    builder.addPoints(columns.xyz[0].first, count);
  } else if (floats) {
    addAll(columns, count, builder, FloatPoint{});
  } else {
    addAll(columns, count, builder, AnyPoint{});
  }
  builder.passOn();
}

void addRecords(const RecordLayout& layout, std::string_view records, std::uint64_t count,
                const Task& task, ScanBuilder& builder) {
  for (std::uint64_t done = 0; done < count; done += kAtOnce) {
    task.check();
    task.report("reading points", static_cast<double>(done) / static_cast<double>(count));
    addColumns(columnsOf(layout, records.data() + done * layout.bytes),
               std::min(kAtOnce, count - done), builder);
  }
}

std::optional<std::size_t> colourChannel(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 4>, 3> kNames{{
      {"red", "r", "diffuse_red", "colorred"},
      {"green", "g", "diffuse_green", "colorgreen"},
      {"blue", "b", "diffuse_blue", "colorblue"},
  }};
  const std::string wanted = lower(name);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto& names = kNames[channel];
    if (std::find(names.begin(), names.end(), wanted) != names.end()) return channel;
  }
  return std::nullopt;
}

bool isIntensity(std::string_view name) {
  constexpr std::array<std::string_view, 5> kNames{"intensity", "scalar_intensity", "reflectance",
                                                   "scalar_reflectance", "i"};
  return std::find(kNames.begin(), kNames.end(), lower(name)) != kNames.end();
}

bool sameLetters(std::string_view a, std::string_view b) {
  return lower(a) == lower(b);
}

}  // namespace relievo
