// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo::foreign {

/// Opens one device of a plug-in and runs it over the page at descriptor 3 until relievo lets go or
/// is gone, or a signal asks for an end. Whatever ends it, zero force is sent first.
/// @return the exit status
int drive(const std::string& file, const std::string& id);

}  // namespace relievo::foreign
