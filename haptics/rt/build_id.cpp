// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/build_id.h"

#include <link.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace relievo {

namespace {
std::size_t aligned(std::size_t bytes) {
  return (bytes + 3) & ~std::size_t{3};
}

/// The id among the notes of one segment; empty: none.
std::string idAmong(std::span<const unsigned char> notes) {
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) header{};
    std::memcpy(&header, notes.data(), sizeof(header));
    const std::size_t name_at = sizeof(header), id_at = name_at + aligned(header.n_namesz);
    if (id_at + header.n_descsz > notes.size()) break;
    if (header.n_type == NT_GNU_BUILD_ID) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      std::string text;
      for (const unsigned char byte : notes.subspan(id_at, header.n_descsz)) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
      }
      return text;
    }
    notes = notes.subspan(std::min(notes.size(), id_at + aligned(header.n_descsz)));
  }
  return {};
}

int lookAt(dl_phdr_info* object, std::size_t, void* data) {
  const std::span<const ElfW(Phdr)> segments(object->dlpi_phdr, object->dlpi_phnum);
  const auto here = reinterpret_cast<std::uintptr_t>(&buildId);
  bool ours = false;
  for (const ElfW(Phdr) & segment : segments) {
    const std::uintptr_t first = object->dlpi_addr + segment.p_vaddr;
    ours = ours || (segment.p_type == PT_LOAD && here >= first && here < first + segment.p_memsz);
  }
  if (!ours) return 0;
  for (const ElfW(Phdr) & segment : segments) {
    if (segment.p_type != PT_NOTE) continue;
    const auto* first = reinterpret_cast<const unsigned char*>(object->dlpi_addr + segment.p_vaddr);
    const std::string id = idAmong({first, segment.p_memsz});
    if (!id.empty()) *static_cast<std::string*>(data) = id;
  }
  return 1;
}
}  // namespace

std::string buildId() {
  std::string id;
  ::dl_iterate_phdr(lookAt, &id);
  return id.empty() ? "unnamed" : id;
}

}  // namespace relievo
