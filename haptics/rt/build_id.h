// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Names this very build of the library, as the linker did (GNU build id, hexadecimal); "unnamed"
/// if it did not. What holds for one build only is marked with it. [any thread]
std::string buildId();

}  // namespace relievo
