// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// "1.13.0": of PCL's headers, because PCL has no function that tells. In a file of its own, so
/// that a program that names it does not load PCL. [any thread]
const char* pclVersion() noexcept;

}  // namespace relievo
