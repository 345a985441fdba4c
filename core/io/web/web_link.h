// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/io/web/published_map.h"
#include "core/io/web/web_protocol.h"

namespace relievo {

/// Files of web servers, object stores and folders, by a process that fetches and unpacks them
/// (docs/adr/0200): this program opens no connection and unpacks no foreign byte. The process is
/// started when something is asked for, and anew if it has ended.
class WebLink {
 public:
  struct Answer {
    WebEnd end = WebEnd::good;
    std::vector<std::byte> bytes;
    std::string why;  ///< In words of the system, unless it is good.
  };

  WebLink();
  ~WebLink();
  WebLink(const WebLink&) = delete;
  WebLink& operator=(const WebLink&) = delete;

  /// Does not wait for the answer. [any thread]
  /// @param name  as fetchName makes it
  /// @throw FileError  the program that fetches is not where it should be
  std::future<Answer> ask(WebAsk what, const std::string& name, std::uint64_t first = 0,
                          std::uint32_t count = 0, TilePart part = TilePart::heights);
  /// Waits for it; looks at the stop token every 50 ms. @throw FileError, Cancelled
  Answer wait(std::future<Answer> answer, const Task& task = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// "https://", "http://" or "s3://"?
bool isWebAddress(const std::string& name) noexcept;
/// What GDAL calls a file of an address or a folder: /vsicurl/https://..., /vsis3/..., or the file.
std::string fetchName(const std::string& place, const std::string& file);

}  // namespace relievo
