// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/web/published_map.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_nesting.h"
#include "core/io/worker/answer_text.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, kTileParts> kPartNames{"heights", "origins", "colours",
                                                         "intensities"};
constexpr int kFormat = 1;
constexpr std::size_t kMostLevels = 64;
constexpr int kMostCells = 1 << 23;  // A side; docs/adr/0179.
constexpr std::uint64_t kMostListBytes = std::uint64_t{1} << 30U;

template <std::size_t N>
bool allFinite(const std::array<double, N>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

std::size_t bytesOf(TilePart part) noexcept {
  constexpr std::array<std::size_t, kTileParts> kBytes{4, 1, 4, 2};
  return 256 * 256 * kBytes[static_cast<std::size_t>(part)];
}

bool makesSense(const PublishedMap& map) noexcept {
  const auto size_fits = [](GridSize size) {
    return size.cols >= 1 && size.rows >= 1 && size.cols <= kMostCells && size.rows <= kMostCells;
  };
  const bool parts_in_order =
      map.parts.size() >= 2 && map.parts.size() <= kTileParts &&
      map.parts[0] == TilePart::heights && map.parts[1] == TilePart::origins &&
      std::is_sorted(map.parts.begin(), map.parts.end()) &&
      std::adjacent_find(map.parts.begin(), map.parts.end()) == map.parts.end() &&
      map.parts.back() <= TilePart::intensities;
  const bool in_range = map.spacing_mm > 0 && map.factor > 1 && map.factor <= 8 &&
                        map.low_mm <= map.high_mm &&
                        std::isfinite(map.first_x_mm + map.first_y_mm + map.spacing_mm) &&
                        std::isfinite(map.low_mm) && std::isfinite(map.high_mm) &&
                        allFinite(map.view_from_file) && allFinite(map.cells_by_origin) &&
                        std::all_of(map.cells_by_origin.begin(), map.cells_by_origin.end(),
                                    [](double count) { return count >= 0; });
  return !map.levels.empty() && map.levels.size() <= kMostLevels &&
         std::all_of(map.levels.begin(), map.levels.end(), size_fits) && parts_in_order &&
         in_range && map.pack_list_bytes <= kMostListBytes &&
         map.pack_list_bytes % sizeof(PackRecord) == 0 && map.pack_list_sha256.size() == 64;
}

std::string jsonOf(const PublishedMap& map) {
  Json levels = Json::array();
  for (const GridSize& size : map.levels) levels.push_back({size.cols, size.rows});
  Json parts = Json::array();
  for (const TilePart part : map.parts) {
    parts.push_back(kPartNames[static_cast<std::size_t>(part)]);
  }
  const Json json{{"relievo_published_map", kFormat},
                  {"title", map.title},
                  {"licence", map.licence},
                  {"citation", map.citation},
                  {"made_from", map.made_from},
                  {"unit", "mm"},
                  {"view_from_file", map.view_from_file},
                  {"first_mm", {map.first_x_mm, map.first_y_mm}},
                  {"spacing_mm", map.spacing_mm},
                  {"factor", map.factor},
                  {"heights_mm", {map.low_mm, map.high_mm}},
                  {"cells_by_origin", map.cells_by_origin},
                  {"levels", std::move(levels)},
                  {"parts", std::move(parts)},
                  {"tile_cells", 256},
                  {"pack_tiles", kPackSide},
                  {"packs", {{"bytes", map.pack_list_bytes}, {"sha256", map.pack_list_sha256}}},
                  {"set", map.set},
                  {"state", map.state}};
  return json.dump(1) + "\n";
}

std::optional<PublishedMap> readPublishedMap(std::string_view text) {
  requireReadersAllowed("readPublishedMap");
  constexpr int kDeepest = 8;
  if (isNestedDeeper(text, kDeepest)) return std::nullopt;
  try {
    const Json json = Json::parse(text);
    if (json.at("relievo_published_map").get<int>() != kFormat ||
        json.at("tile_cells").get<int>() != 256 || json.at("pack_tiles").get<int>() != kPackSide) {
      return std::nullopt;
    }
    PublishedMap map;
    for (const auto& [name, to] : {std::pair{"title", &map.title},
                                   {"licence", &map.licence},
                                   {"citation", &map.citation},
                                   {"made_from", &map.made_from},
                                   {"set", &map.set},
                                   {"state", &map.state}}) {
      *to = json.at(name).get<std::string>();
    }
    json.at("view_from_file").get_to(map.view_from_file);
    map.first_x_mm = json.at("first_mm").at(0).get<double>();
    map.first_y_mm = json.at("first_mm").at(1).get<double>();
    json.at("spacing_mm").get_to(map.spacing_mm);
    json.at("factor").get_to(map.factor);
    map.low_mm = json.at("heights_mm").at(0).get<double>();
    map.high_mm = json.at("heights_mm").at(1).get<double>();
    json.at("cells_by_origin").get_to(map.cells_by_origin);
    for (const Json& size : json.at("levels")) {
      map.levels.push_back({.cols = size.at(0).get<int>(), .rows = size.at(1).get<int>()});
    }
    for (const Json& name : json.at("parts")) {
      const auto* const known =
          std::find(kPartNames.begin(), kPartNames.end(), name.get<std::string>());
      if (known == kPartNames.end()) return std::nullopt;
      map.parts.push_back(static_cast<TilePart>(known - kPartNames.begin()));
    }
    json.at("packs").at("bytes").get_to(map.pack_list_bytes);
    json.at("packs").at("sha256").get_to(map.pack_list_sha256);
    if (!makesSense(map)) return std::nullopt;
    return map;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::string packed(const PublishedMap& map) {
  Packer packer;
  for (const std::string* text : {&map.title, &map.licence, &map.citation, &map.made_from, &map.set,
                                  &map.state, &map.pack_list_sha256}) {
    packer.put(*text);
  }
  packer.put(map.view_from_file);
  packer.put(std::array{map.first_x_mm, map.first_y_mm, map.spacing_mm, map.factor, map.low_mm,
                        map.high_mm});
  packer.put(map.cells_by_origin);
  packer.put(static_cast<std::uint64_t>(map.levels.size()));
  for (const GridSize& size : map.levels) packer.put(size);
  packer.put(static_cast<std::uint64_t>(map.parts.size()));
  for (const TilePart part : map.parts) packer.put(part);
  packer.put(map.pack_list_bytes);
  return packer.bytes();
}

std::optional<PublishedMap> unpackedMap(std::string bytes) {
  Unpacker unpacker(std::move(bytes));
  PublishedMap map;
  for (std::string* text : {&map.title, &map.licence, &map.citation, &map.made_from, &map.set,
                            &map.state, &map.pack_list_sha256}) {
    *text = unpacker.text();
  }
  map.view_from_file = unpacker.get<std::array<double, 16>>();
  const auto numbers = unpacker.get<std::array<double, 6>>();
  map.first_x_mm = numbers[0];
  map.first_y_mm = numbers[1];
  map.spacing_mm = numbers[2];
  map.factor = numbers[3];
  map.low_mm = numbers[4];
  map.high_mm = numbers[5];
  map.cells_by_origin = unpacker.get<std::array<double, kOriginCount>>();
  const auto levels = unpacker.get<std::uint64_t>();
  if (levels > kMostLevels) return std::nullopt;
  for (std::uint64_t i = 0; i < levels; ++i) map.levels.push_back(unpacker.get<GridSize>());
  const auto parts = unpacker.get<std::uint64_t>();
  if (parts > kTileParts) return std::nullopt;
  for (std::uint64_t i = 0; i < parts; ++i) map.parts.push_back(unpacker.get<TilePart>());
  map.pack_list_bytes = unpacker.get<std::uint64_t>();
  if (!unpacker.good() || !makesSense(map)) return std::nullopt;
  return map;
}

}  // namespace relievo
