// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/zip_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/file/owned_fd.h"
#include "core/project/zip_session.h"

namespace relievo {

struct ZipTarget::Impl {
  explicit Impl(const std::filesystem::path& name)
      : file(::open(name.c_str(), O_RDWR | O_CLOEXEC)) {
    zip_error_init(&error);
  }
  ~Impl() { zip_error_fini(&error); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  OwnedFd file;
  zip_int64_t read_at = 0, write_at = 0;
  zip_error_t error{};

  zip_int64_t failed(int what) {
    zip_error_set(&error, what, errno);
    return -1;
  }
  zip_int64_t size() const {
    struct stat facts {};
    return ::fstat(file.get(), &facts) == 0 ? facts.st_size : 0;
  }
  zip_int64_t seek(zip_int64_t& at, void* data, zip_uint64_t bytes) {
    const zip_int64_t to = zip_source_seek_compute_offset(
        static_cast<zip_uint64_t>(at), static_cast<zip_uint64_t>(size()), data, bytes, &error);
    if (to < 0) return -1;
    at = to;
    return 0;
  }
  zip_int64_t read(void* data, zip_uint64_t bytes) {
    const ssize_t got = ::pread(file.get(), data, bytes, read_at);
    if (got < 0) return failed(ZIP_ER_READ);
    read_at += got;
    return got;
  }
  zip_int64_t write(const void* data, zip_uint64_t bytes) {
    // libzip takes a write that is shorter for one that was interrupted.
    const auto* left = static_cast<const char*>(data);
    for (zip_uint64_t to_go = bytes; to_go > 0;) {
      const ssize_t put = ::pwrite(file.get(), left, to_go, write_at);
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) return failed(ZIP_ER_WRITE);
      write_at += put;
      left += put;
      to_go -= static_cast<zip_uint64_t>(put);
    }
    return static_cast<zip_int64_t>(bytes);
  }
  zip_int64_t facts(void* data) const {
    auto* told = static_cast<zip_stat_t*>(data);
    zip_stat_init(told);
    told->size = static_cast<zip_uint64_t>(size());
    told->valid = ZIP_STAT_SIZE;
    return sizeof(zip_stat_t);
  }
  zip_int64_t empty() {
    write_at = 0;
    return ::ftruncate(file.get(), 0) == 0 ? 0 : failed(ZIP_ER_WRITE);
  }
  zip_int64_t answer(void* data, zip_uint64_t bytes, zip_source_cmd_t wanted);
};

zip_int64_t ZipTarget::Impl::answer(void* data, zip_uint64_t bytes, zip_source_cmd_t wanted) {
  switch (wanted) {
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(
          ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
          ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_BEGIN_WRITE,
          ZIP_SOURCE_WRITE, ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE,
          ZIP_SOURCE_SEEK_WRITE, ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_REMOVE, -1);
    case ZIP_SOURCE_OPEN:
      read_at = 0;
      return 0;
    case ZIP_SOURCE_READ:
      return read(data, bytes);
    case ZIP_SOURCE_SEEK:
      return seek(read_at, data, bytes);
    case ZIP_SOURCE_TELL:
      return read_at;
    case ZIP_SOURCE_STAT:
      return facts(data);
    case ZIP_SOURCE_WRITE:
      return write(data, bytes);
    case ZIP_SOURCE_SEEK_WRITE:
      return seek(write_at, data, bytes);
    case ZIP_SOURCE_TELL_WRITE:
      return write_at;
    case ZIP_SOURCE_BEGIN_WRITE:
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_REMOVE:
      return empty();
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_FREE:
      return 0;
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&error, data, bytes);
    default:
      zip_error_set(&error, ZIP_ER_OPNOTSUPP, 0);
      return -1;
  }
}

ZipTarget::ZipTarget(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}
ZipTarget::~ZipTarget() = default;

zip_source* ZipTarget::source() {
  if (impl_->file.get() < 0) return nullptr;
  return zip_source_function_create(
      [](void* target, void* data, zip_uint64_t bytes, zip_source_cmd_t wanted) {
        return static_cast<Impl*>(target)->answer(data, bytes, wanted);
      },
      impl_.get(), &impl_->error);
}

std::string libzipVersion() {
  return zip_libzip_version();
}

}  // namespace relievo
