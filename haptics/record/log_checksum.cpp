// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log_checksum.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <new>

namespace relievo {

namespace {
constexpr std::size_t kDigits = 64;
}

struct LogHash::Impl {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
};

LogHash::LogHash() : impl_(std::make_unique<Impl>()) {
  if (impl_->context == nullptr || EVP_DigestInit_ex(impl_->context, EVP_sha256(), nullptr) != 1) {
    EVP_MD_CTX_free(impl_->context);
    throw std::bad_alloc();  // Nothing else can go wrong in making a digest.
  }
}

LogHash::~LogHash() {
  EVP_MD_CTX_free(impl_->context);
}

void LogHash::add(std::string_view bytes) {
  EVP_DigestUpdate(impl_->context, bytes.data(), bytes.size());
}

std::string LogHash::digits() {
  std::array<unsigned char, kDigits / 2> digest{};
  unsigned int length = 0;
  EVP_DigestFinal_ex(impl_->context, digest.data(), &length);
  constexpr std::string_view kHexadecimal = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += kHexadecimal[byte >> 4U];
    text += kHexadecimal[byte & 15U];
  }
  return text;
}

std::string checksumLine(std::string_view before, std::string_view word, std::string_view count,
                         std::string_view block) {
  std::string line(word);
  line.append(count).append(" ");
  LogHash hash;
  hash.add(before);
  hash.add("\n");
  hash.add(line);
  hash.add("\n");
  hash.add(block);
  return line + hash.digits();
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
