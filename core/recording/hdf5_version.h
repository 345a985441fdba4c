// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Of the HDF5 that this process has loaded: "1.10.8". [any thread]
std::string hdf5Version();

}  // namespace relievo
