// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/io/e57/e57_pages.h"
#include "core/io/e57/e57_scans.h"

namespace relievo {

/// Where the packets of a scan lie, logical places.
struct E57Section {
  std::uint64_t first_packet = 0, end = 0;
  std::size_t streams = 0;  ///< In every data packet.
};

/// Reads the header of a scan's binary section and looks at all of its packets and pages, so that
/// nothing but its end can stop E57Stream. @throw E57Fault, Cancelled
E57Section openE57Section(const E57Scan& scan, E57Pages& pages);

/// The numbers of one field, one record after the other, over all packets.
class E57Stream {
 public:
  E57Stream(E57Pages& pages, const E57Section& section, const E57Field& field, std::size_t stream)
      : pages_(pages),
        section_(section),
        field_(field),
        stream_(stream),
        packet_(section.first_packet) {}

  /// @return  nothing where the section ends
  std::optional<double> next();

 private:
  bool loadPacket();
  std::uint64_t takeBits();

  E57Pages& pages_;
  E57Section section_;
  const E57Field& field_;
  std::size_t stream_;
  std::uint64_t packet_;  ///< The next one.
  std::string bytes_;     ///< Of this stream, from the packets read so far.
  std::size_t bit_ = 0;   ///< The next one in bytes_.
};

}  // namespace relievo
