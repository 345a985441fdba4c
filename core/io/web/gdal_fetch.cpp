// SPDX-License-Identifier: BSD-3-Clause
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <cpl_vsi_error.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/io/web/web_worker.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

struct CloseFile {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

bool isRemote(const std::string& name) {
  return name.starts_with("/vsicurl/") || name.starts_with("/vsis3/");
}

/// Does this number stand in the words? 404 does not stand in "port 40412".
bool saysNumber(std::string_view words, std::string_view number) {
  const auto isDigit = [&words](std::size_t at) {
    return at < words.size() && words[at] >= '0' && words[at] <= '9';
  };
  for (std::size_t at = words.find(number); at != std::string_view::npos;
       at = words.find(number, at + 1)) {
    const bool goes_on = isDigit(at + number.size()) || (at > 0 && isDigit(at - 1));
    if (!goes_on) return true;
  }
  return false;
}

/// What nobody can fetch now may be there next time: GDAL remembers that it was not.
FetchedBytes failed(const std::string& name, const std::string& words) {
  const auto says = [&words](const char* code) { return saysNumber(words, code); };
  // Of an object store, a key that is not there or fits not is no matter of the network either.
  const int store = VSIGetLastErrorNo();
  const bool of_store = store == VSIE_AWSBucketNotFound || store == VSIE_AWSObjectNotFound ||
                        store == VSIE_AWSAccessDenied || store == VSIE_AWSInvalidCredentials ||
                        store == VSIE_AWSSignatureDoesNotMatch;
  const bool refused = of_store || says("404") || says("403") || says("410") || says("401");
  if (isRemote(name)) VSICurlPartialClearCache(name.c_str());
  FetchedBytes none;
  none.end = refused || !isRemote(name) ? WebEnd::missing : WebEnd::unreachable;
  none.why = words;
  return none;
}

std::string wordsOf(const std::string& name) {
  if (!isRemote(name)) return std::strerror(errno);
  std::string words = VSIGetLastErrorMsg();
  if (words.empty()) words = CPLGetLastErrorMsg();
  return words.empty() ? "no answer" : words;
}

}  // namespace

void prepareFetching() {
  CPLSetErrorHandler(CPLQuietErrorHandler);
  for (const auto& [name, value] : {std::pair{"GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR"},
                                    {"GDAL_HTTP_CONNECTTIMEOUT", "5"},
                                    {"GDAL_HTTP_TIMEOUT", "60"},
                                    {"GDAL_HTTP_LOW_SPEED_TIME", "10"},
                                    {"GDAL_HTTP_LOW_SPEED_LIMIT", "100"},
                                    {"GDAL_HTTP_MAX_RETRY", "0"},
                                    {"GDAL_HTTP_USERAGENT", "relievo"},
                                    {"CPL_VSIL_CURL_CACHE_SIZE", "1048576"}}) {
    CPLSetConfigOption(name, value);
  }
}

FetchedBytes fetched(const std::string& name, std::uint64_t first, std::uint32_t count) {
  requireReadersAllowed("fetched");
  VSIErrorReset();
  CPLErrorReset();
  errno = 0;
  const std::unique_ptr<VSILFILE, CloseFile> file(VSIFOpenExL(name.c_str(), "rb", 1));
  if (!file) return failed(name, wordsOf(name));
  std::uint64_t bytes = count;
  if (count == 0) {
    if (VSIFSeekL(file.get(), 0, SEEK_END) != 0) return failed(name, wordsOf(name));
    bytes = VSIFTellL(file.get());
  }
  if (bytes == 0 || bytes > kMostWebBytes) {
    return {.end = WebEnd::damaged, .bytes = {}, .why = "its length makes no sense"};
  }
  FetchedBytes got;
  got.bytes.resize(static_cast<std::size_t>(bytes));
  // Two ranges, which GDAL joins into one request for exactly these bytes; a single one would be
  // taken from what it keeps of the file, and damaged bytes from there again and again.
  const auto half = static_cast<std::size_t>(bytes / 2);
  std::array<void*, 2> places{got.bytes.data(), got.bytes.data() + half};
  const std::array<vsi_l_offset, 2> at{first, first + half};
  const std::array<std::size_t, 2> sizes{half, got.bytes.size() - half};
  const int ranges = half > 0 ? 2 : 1;
  const auto from = static_cast<std::size_t>(2 - ranges);
  VSIErrorReset();
  CPLErrorReset();
  if (VSIFReadMultiRangeL(ranges, &places[from], &at[from], &sizes[from], file.get()) != 0) {
    FetchedBytes none = failed(name, wordsOf(name));
    if (!isRemote(name)) none.end = WebEnd::damaged;  // It is there, and shorter.
    return none;
  }
  return got;
}

}  // namespace relievo
