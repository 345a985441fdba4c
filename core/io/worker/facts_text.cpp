// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/facts_text.h"

#include <array>
#include <cstring>
#include <utility>

#include "core/io/worker/answer_text.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMostItems = 1U << 16U;

std::array<std::uint32_t*, 7> numbersOf(TiffHead& head) {
  return {&head.bands,  &head.bits,      &head.sample_format, &head.compression,
          &head.planes, &head.tile_cols, &head.tile_rows};
}

void pack(TiffHead head, Packer& packer) {
  packer.put(head.cols);
  packer.put(head.rows);
  for (const std::uint32_t* number : numbersOf(head)) packer.put(*number);
  packer.put(static_cast<std::uint64_t>(head.little_endian));
  packer.put(static_cast<std::uint64_t>(head.facts.size()));
  for (const auto& [name, text] : head.facts) {
    packer.put(name);
    packer.put(text);
  }
  packer.put(std::string(reinterpret_cast<const char*>(head.tile_offsets.data()),
                         head.tile_offsets.size() * sizeof(std::uint64_t)));
}

bool unpack(Unpacker& unpacker, TiffHead& head) {
  constexpr std::uint64_t kMostCells = 0x7fffffff;
  head.cols = unpacker.get<std::uint64_t>();
  head.rows = unpacker.get<std::uint64_t>();
  for (std::uint32_t* number : numbersOf(head)) *number = unpacker.get<std::uint32_t>();
  head.little_endian = unpacker.get<std::uint64_t>() != 0;
  const auto facts = unpacker.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < facts && unpacker.good(); ++i) {
    std::string name = unpacker.text();
    head.facts[std::move(name)] = unpacker.text();
  }
  const std::string offsets = unpacker.text();
  if (!unpacker.good() || offsets.size() % sizeof(std::uint64_t) != 0) return false;
  head.tile_offsets.resize(offsets.size() / sizeof(std::uint64_t));
  if (!offsets.empty()) std::memcpy(head.tile_offsets.data(), offsets.data(), offsets.size());
  return head.cols >= 1 && head.cols <= kMostCells && head.rows >= 1 && head.rows <= kMostCells;
}

void pack(const InputFacts& facts, Packer& packer) {
  packer.put(static_cast<std::uint64_t>(facts.kind));
  packer.put(static_cast<std::uint64_t>(facts.host_file));
  packer.put(static_cast<std::uint64_t>(facts.is_hdf5));
  packer.put(static_cast<std::uint64_t>(facts.is_log));
  packer.put(static_cast<std::uint64_t>(facts.in_blocks));
  packer.put(static_cast<std::uint64_t>(facts.has_faces));
}

bool unpack(Unpacker& unpacker, InputFacts& facts) {
  const auto kind = unpacker.get<std::uint64_t>();
  const auto host_file = unpacker.get<std::uint64_t>();
  if (kind > static_cast<std::uint64_t>(InputKind::tiled_map) ||
      host_file > static_cast<std::uint64_t>(HostFileKind::package)) {
    return false;
  }
  facts.kind = static_cast<InputKind>(kind);
  facts.host_file = static_cast<HostFileKind>(host_file);
  facts.is_hdf5 = unpacker.get<std::uint64_t>() != 0;
  facts.is_log = unpacker.get<std::uint64_t>() != 0;
  facts.in_blocks = unpacker.get<std::uint64_t>() != 0;
  facts.has_faces = unpacker.get<std::uint64_t>() != 0;
  return unpacker.good();
}

template <class Item>
WorkerText listText(const std::vector<std::optional<Item>>& items) {
  Packer packer;
  packer.put(static_cast<std::uint64_t>(items.size()));
  for (const auto& item : items) {
    packer.put(static_cast<std::uint64_t>(item.has_value()));
    if (item) pack(*item, packer);
  }
  return {packer.bytes()};
}

template <class Item>
std::optional<std::vector<std::optional<Item>>> listOf(const WorkerText& text) {
  Unpacker unpacker(text.bytes);
  const auto count = unpacker.get<std::uint64_t>();
  if (!unpacker.good() || count > kMostItems) return std::nullopt;
  std::vector<std::optional<Item>> items(static_cast<std::size_t>(count));
  for (auto& item : items) {
    if (unpacker.get<std::uint64_t>() == 0) continue;
    item.emplace();
    if (!unpack(unpacker, *item)) return std::nullopt;
  }
  return unpacker.good() ? std::optional(std::move(items)) : std::nullopt;
}

}  // namespace

WorkerText textOf(const std::vector<std::optional<InputFacts>>& facts) {
  return listText(facts);
}

std::optional<std::vector<std::optional<InputFacts>>> inputFactsOf(const WorkerText& text) {
  return listOf<InputFacts>(text);
}

WorkerText textOf(const std::optional<std::string>& state) {
  Packer packer;
  packer.put(static_cast<std::uint64_t>(state.has_value()));
  packer.put(state.value_or(std::string()));
  return {packer.bytes()};
}

std::optional<std::optional<std::string>> stateOf(const WorkerText& text) {
  Unpacker unpacker(text.bytes);
  const bool is_there = unpacker.get<std::uint64_t>() != 0;
  std::string state = unpacker.text();
  if (!unpacker.good()) return std::nullopt;
  std::optional<std::string> carried;
  if (is_there) carried = std::move(state);
  return std::optional<std::optional<std::string>>(std::in_place, std::move(carried));
}

WorkerText textOf(const std::optional<StoredPixels>& pixels) {
  Packer packer;
  const StoredPixels some = pixels.value_or(StoredPixels{});
  for (const int number : {some.width, some.height, some.channels}) {
    packer.put(static_cast<std::uint64_t>(number));
  }
  packer.put(std::string(some.bytes.begin(), some.bytes.end()));
  return {packer.bytes()};
}

std::optional<std::optional<StoredPixels>> pixelsOf(const WorkerText& text) {
  Unpacker unpacker(text.bytes);
  std::array<std::uint64_t, 3> shape{};
  for (std::uint64_t& number : shape) number = unpacker.get<std::uint64_t>();
  const std::string bytes = unpacker.text();
  if (!unpacker.good()) return std::nullopt;
  const auto [width, height, channels] = shape;
  if (width == 0 && height == 0) return std::optional<StoredPixels>();
  constexpr std::uint64_t kMostSide = 1U << 20U;
  const bool makes_sense = width > 0 && height > 0 && width <= kMostSide && height <= kMostSide &&
                           (channels == 3 || channels == 4) &&
                           bytes.size() == width * height * channels;
  if (!makes_sense) return std::nullopt;
  return StoredPixels{.width = static_cast<int>(width),
                      .height = static_cast<int>(height),
                      .channels = static_cast<int>(channels),
                      .bytes = {bytes.begin(), bytes.end()}};
}

WorkerText textOf(const std::vector<std::optional<TiffHead>>& heads) {
  return listText(heads);
}

std::optional<std::vector<std::optional<TiffHead>>> tiffHeadsOf(const WorkerText& text) {
  return listOf<TiffHead>(text);
}

}  // namespace relievo
