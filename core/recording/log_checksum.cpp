// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/log_checksum.h"

#include "core/hash/sha256.h"

namespace relievo {

namespace {
constexpr std::size_t kDigits = 64;
}

std::string checksumLine(std::string_view before, std::string_view word, std::string_view count,
                         std::string_view block) {
  std::string line(word);
  line.append(count).append(" ");
  Sha256 hash;
  hash.add(before);
  hash.add("\n");
  hash.add(line);
  hash.add("\n");
  hash.add(block);
  return line + hash.finish();
}

std::string digitsOf(std::string_view checksum_line) {
  return std::string(checksum_line.substr(checksum_line.size() - kDigits));
}

std::string emptyRoom() {
  std::string room = "# not ended";
  return room.append(kRoomBytes - 1 - room.size(), ' ') + '\n';
}

bool isChecksumLine(std::string_view comment) noexcept {
  return comment.starts_with(kChecksums) || comment.starts_with(kBlockWord) ||
         comment.starts_with(kFinishedWord);
}

std::string userBlock(std::string_view digits) {
  std::string text(kUserBlockWords);
  if (digits.empty()) {
    text += "not finished";
  } else {
    text.append("finished, SHA-256 of what follows this block: ").append(digits);
  }
  return text.append(kUserBlockBytes - 1 - text.size(), ' ') + '\n';
}

}  // namespace relievo
