// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <new>
#include <vector>

#include "core/base/error.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {
constexpr std::size_t kPieceBytes = 1U << 20U;  // About a millisecond: often enough to cancel.
}

struct Sha256::Impl {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
};

Sha256::Sha256() : impl_(std::make_unique<Impl>()) {
  if (impl_->context == nullptr || EVP_DigestInit_ex(impl_->context, EVP_sha256(), nullptr) != 1) {
    EVP_MD_CTX_free(impl_->context);
    throw std::bad_alloc();  // Nothing else can go wrong in making a digest.
  }
}

Sha256::~Sha256() {
  EVP_MD_CTX_free(impl_->context);
}

void Sha256::add(std::span<const std::byte> bytes) {
  EVP_DigestUpdate(impl_->context, bytes.data(), bytes.size());
}

void Sha256::add(std::string_view bytes) {
  add(std::as_bytes(std::span(bytes)));
}

std::string Sha256::finish() {
  std::array<unsigned char, 32> digest{};
  unsigned int length = 0;
  EVP_DigestFinal_ex(impl_->context, digest.data(), &length);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::string sha256OfText(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.finish();
}

std::string sha256OfFile(const std::filesystem::path& file, const Task& task) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw FileError("Cannot read " + shownName(file) +
                    ": it is missing or not a file. Its checksum was not made.");
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  std::ifstream in(file, std::ios::binary);
  std::vector<char> piece(kPieceBytes);
  Sha256 hash;
  double done = 0;
  while (in) {
    task.check();
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    hash.add(std::string_view(piece.data(), count));
    done += static_cast<double>(count);
    if (bytes > 0) task.report("Checksum", done / bytes);
  }
  if (!in.eof()) {
    throw FileError("Cannot read " + shownName(file) + " to its end. Its checksum was not made.");
  }
  return hash.finish();
}

std::string relativePath(const std::filesystem::path& file, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path to = fs::weakly_canonical(fs::absolute(file), error);
  const fs::path start = fs::weakly_canonical(fs::absolute(folder), error);
  const fs::path relative = to.lexically_relative(start);
  return (relative.empty() ? to : relative).generic_string();
}

InputFile inputFile(const std::filesystem::path& file, const std::filesystem::path& from,
                    const Task& task) {
  InputFile input{.file = file.filename().generic_string(),
                  .sha256 = sha256OfFile(file, task),
                  .bytes = std::filesystem::file_size(file)};
  if (!from.empty()) input.file = relativePath(file, from);
  return input;
}

}  // namespace relievo
