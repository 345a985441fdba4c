// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/job/job_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/base/exchange.h"
#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/hash/sha256.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "relievo work 1\n";
constexpr const char* kFacts = "work.txt";
constexpr const char* kLock = "lock";
constexpr std::array kParts{"points", "heights", "filled"};  // Folders of parts.
constexpr std::string_view kMagic = "RLVPART1";
constexpr std::size_t kFooterBytes = 8 + 64;  // kMagic and the checksum.

std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Checksums: what a file's name or content is, is nobody's business who finds the folder.
std::string textOf(const JobFacts& facts) {
  std::string text(kHead);
  for (const auto& [name, what] : facts) text += name + '\t' + sha256OfText(what) + '\n';
  return text;
}

void write(const fs::path& file, std::initializer_list<std::string_view> pieces) {
  try {
    AtomicFile out(file);
    for (const std::string_view piece : pieces) out.write(piece);
    out.commit();
  } catch (const CannotWrite& error) {
    throw failure<MessageId::job_unit_not_kept>(file, error.reason);
  }
}

}  // namespace

JobFolder::JobFolder(fs::path folder, const JobFacts& facts, Exchange* processes)
    : folder_(std::move(folder)), sum_(sha256OfText(textOf(facts))) {
  if (processes == nullptr || processes->isFirst()) begin(facts);
  if (processes == nullptr) return;
  processes->wait();
  if (!processes->isFirst()) join(facts, *processes);
}

void JobFolder::begin(const JobFacts& facts) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw failure<MessageId::job_unit_not_kept>(folder_, error.message());
  const fs::path known = folder_ / kFacts;
  if (!fs::exists(known)) {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path().filename() != kLock) throw failure<MessageId::job_not_ours>(folder_);
    }
  }
  takeLock();
  if (fs::exists(known)) {
    const std::string other = differing(facts);
    if (!other.empty()) throw failure<MessageId::job_of_other_work>(folder_, other);
  } else {
    is_new_ = true;
    write(known, {textOf(facts)});
  }
  for (const char* const parts : kParts) {
    fs::create_directories(folder_ / parts, error);
    if (error) throw failure<MessageId::job_unit_not_kept>(folder_ / parts, error.message());
    removeLeftFiles(folder_ / parts);
  }
}

/// The first of the processes has it, and the others do the same work.
void JobFolder::join(const JobFacts& facts, const Exchange& processes) {
  std::string other = "the folder of --job";
  if (fs::exists(folder_ / kFacts)) other = differing(facts);
  if (other.empty()) return;
  throw failure<MessageId::processes_differ>(
      NumberArgument{.value = static_cast<double>(processes.rank() + 1)},
      NumberArgument{.value = static_cast<double>(processes.ranks())}, other);
}

void JobFolder::takeLock() {
  lock_.reset(::open((folder_ / kLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock_.get() < 0) {
    throw failure<MessageId::job_unit_not_kept>(folder_ / kLock, std::strerror(errno));
  }
  // Where the file system knows no locks nobody is kept out: equal work has equal parts.
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw failure<MessageId::job_in_use>(folder_);
  }
}

std::string JobFolder::differing(const JobFacts& facts) const {
  const std::string there = contentOf(folder_ / kFacts);
  if (!std::string_view(there).starts_with(kHead)) {
    throw failure<MessageId::job_not_ours>(folder_);
  }
  for (const auto& [name, what] : facts) {
    if (there.find(name + '\t' + sha256OfText(what) + '\n') == std::string::npos) {
      return name;
    }
  }
  return {};
}

std::string JobFolder::sumOf(std::string_view part,
                             std::initializer_list<std::string_view> content) const {
  Sha256 sum;
  sum.add(sum_);
  sum.add(part);
  sum.add(std::string_view("\n"));
  for (const std::string_view piece : content) sum.add(piece);
  return sum.finish();
}

std::optional<std::string> JobFolder::load(const std::string& part) {
  const fs::path file = fileOf(part);
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown)) return std::nullopt;
  std::string content = contentOf(file);
  if (content.size() >= kFooterBytes) {
    const std::string footer = content.substr(content.size() - kFooterBytes);
    content.resize(content.size() - kFooterBytes);
    if (footer == std::string(kMagic) + sumOf(part, {content})) return content;
  }
  ++damaged_;
  return std::nullopt;
}

void JobFolder::keep(const std::string& part, std::initializer_list<std::string_view> content) {
  const std::string footer = std::string(kMagic) + sumOf(part, content);
  const fs::path file = fileOf(part);
  try {
    // A folder of thousands is not looked through for each; who has the lock did it once.
    AtomicFile out(file, TemporaryName::none, LeftFiles::stay);
    for (const std::string_view piece : content) out.write(piece);
    out.write(footer);
    out.commit();
  } catch (const CannotWrite& error) {
    throw failure<MessageId::job_unit_not_kept>(file, error.reason);
  }
}

void JobFolder::remove(const std::string& parts) {
  std::error_code unknown;
  fs::remove_all(folder_ / parts, unknown);
}

void JobFolder::finish() {
  std::error_code unknown;
  for (const char* const parts : kParts) remove(parts);
  for (const auto& entry : fs::directory_iterator(folder_, unknown)) {
    const std::string name = entry.path().filename().string();
    if (name == kFacts || name == kLock || name.ends_with(".part")) {
      fs::remove(entry.path(), unknown);
    }
  }
  fs::remove(folder_, unknown);  // If it is empty now.
}

void readPart(const fs::path& file, std::uint64_t at, std::span<std::byte> bytes) {
  const OwnedFd fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (fd.get() < 0) {
    throw failure<MessageId::spill_not_kept>(file.parent_path(), std::strerror(errno));
  }
  while (!bytes.empty()) {
    const ssize_t done = ::pread(fd.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) {
      throw failure<MessageId::spill_not_kept>(file.parent_path(),
                                               std::strerror(done < 0 ? errno : EIO));
    }
    at += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

}  // namespace relievo
