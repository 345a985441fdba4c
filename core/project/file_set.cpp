// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/file_set.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/failure.h"
#include "core/hash/sha256.h"
#include "core/io/file_check.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/project/embedded_state.h"
#include "core/provenance/parameters_json.h"
#include "core/provenance/set_mark.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCaptionBytes = 1U << 20U;

struct Identity {
  std::string map_content;  ///< Of a map's files.
  SetMark mark;
  std::string state;  ///< Of files that carry one without a mark.
  bool says() const { return !map_content.empty() || !mark.id.empty() || !state.empty(); }
};

/// What a file carries of how it was made; of lists of measurements the part that says so.
std::optional<std::string> stateOf(const fs::path& file) {
  constexpr std::size_t kMostListBytes = 64U << 20U;
  if (inputFacts(file).host_file != HostFileKind::project) return embeddedStateOf(file);
  Json list;
  try {
    list = parsedJson(readHead(file, kMostListBytes));
  } catch (const std::exception&) {
    throw failure<MessageId::embedded_state_damaged>(shownName(file));
  }
  const auto made = list.find("provenance");
  if (made == list.end()) return std::nullopt;
  return made->dump(-1, ' ', true, Json::error_handler_t::replace);
}

Identity identityOf(const fs::path& file) {
  Identity identity;
  if (const auto head = importTiffHead(file)) {
    const auto content = head->facts.find(kSetFact);
    if (content != head->facts.end()) identity.map_content = content->second;
  }
  const std::optional<std::string> state = stateOf(file);
  if (!state) return identity;
  identity.mark = markIn(*state, shownName(file));
  if (identity.mark.id.empty()) identity.state = *state;
  return identity;
}

SetMembership compared(const std::string& a, const std::string& b) {
  return a == b ? SetMembership::same : SetMembership::other;
}

/// A caption is a text and nothing else: it can only be the picture's own, word for word.
SetMembership captionMembership(const Identity& main, const fs::path& file) {
  if (main.mark.caption_sha256.empty()) return SetMembership::unsaid;
  std::string text = readHead(file, kMostCaptionBytes);
  if (text.ends_with('\n')) text.pop_back();
  return compared(sha256OfText(text), main.mark.caption_sha256);
}

SetMembership membershipIn(const Identity& main, const fs::path& file) {
  const Identity other = identityOf(file);
  if (!other.says()) {
    if (file.extension() == ".txt") return captionMembership(main, file);
    // Beside a map that says its set, a raster that does not is another one's.
    const bool raster = importTiffHead(file).has_value();
    return raster && !main.map_content.empty() ? SetMembership::other : SetMembership::unsaid;
  }
  if (!main.map_content.empty() && !other.map_content.empty()) {
    return compared(main.map_content, other.map_content);
  }
  if (!main.mark.id.empty() && !other.mark.id.empty()) {
    return compared(main.mark.id, other.mark.id);
  }
  if (!main.state.empty() && !other.state.empty()) return compared(main.state, other.state);
  return SetMembership::unsaid;
}

/// "MAP.L0.tif" -> "MAP"; nothing: no level.
std::optional<std::string> nameOfLevels(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t at = stem.rfind(".L");
  if (at == std::string::npos || at + 2 == stem.size()) return std::nullopt;
  const bool digits = std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(at) + 2, stem.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return std::nullopt;
  return stem.substr(0, at);
}

std::vector<fs::path> namesBeside(const fs::path& main) {
  std::vector<fs::path> names;
  const auto with = [&](const std::string& stem, const std::string& ending) {
    const fs::path file = main.parent_path() / (stem + ending);
    std::error_code missing;
    if (file != main && fs::is_regular_file(file, missing)) names.push_back(file);
  };
  const std::string stem = main.stem().string();
  for (const char* const eye : {".left.png", ".right.png"}) with(stem, eye);
  if (main.extension() == ".tif" || main.extension() == ".tiff") {
    const auto with_parts = [&](const std::string& name) {
      for (const char* const part : {"", ".colour", ".count", ".intensity", ".origin", ".spread"}) {
        with(name, part + main.extension().string());
      }
    };
    with_parts(stem);
    constexpr int kMostLevels = 64;
    const std::string levels = nameOfLevels(main).value_or(stem);
    for (int level = 0; level < kMostLevels; ++level) {
      const std::string name = levels + ".L" + std::to_string(level);
      if (name != stem) with_parts(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string_view name(SetMembership membership) {
  constexpr std::array<std::string_view, 3> kNames{"same", "other", "unsaid"};
  return kNames[static_cast<std::size_t>(membership)];
}

SetMembership membershipIn(const fs::path& main, const fs::path& file) {
  return membershipIn(identityOf(main), file);
}

std::vector<SetMember> filesBeside(const fs::path& main) {
  const std::vector<fs::path> names = namesBeside(main);
  std::vector<SetMember> members;
  if (names.empty()) return members;
  const Identity identity = identityOf(main);
  for (const fs::path& file : names) {
    SetMember member{.file = file};
    try {
      member.membership = membershipIn(identity, file);
    } catch (const FileError&) {
      member.membership = SetMembership::other;  // Damaged: it is nothing that belongs here.
    }
    members.push_back(member);
  }
  return members;
}

}  // namespace relievo
