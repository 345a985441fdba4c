// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// From here on and for good, no reader of scans or rasters runs in this process: the import
/// programs have them. main() of relievo calls it first of all (docs/adr/0146). [any thread]
void forbidReaders() noexcept;

/// Every reader calls it before it looks at a byte. Where readers are forbidden it ends the process
/// with a line that names the reader: a parser of foreign bytes in the main program is a fault of
/// the program, and going on with it is what must not happen. [any thread]
void requireReadersAllowed(const char* reader) noexcept;

}  // namespace relievo
