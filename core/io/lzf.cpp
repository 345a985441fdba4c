// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees PCL. Never compile it with AVX flags: Debian's PCL aligns to 16 bytes.
#include "core/io/lzf.h"

#include <pcl/io/lzf.h>

namespace relievo {

std::vector<char> unpackLzf(std::string_view packed, std::size_t size) {
  std::vector<char> bytes(size);
  const unsigned got = pcl::lzfDecompress(packed.data(), static_cast<unsigned>(packed.size()),
                                          bytes.data(), static_cast<unsigned>(size));
  if (got != size) bytes.clear();
  return bytes;
}

}  // namespace relievo
