// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Of the VTK that this process has loaded: "9.1.0".
std::string vtkVersionText();

}  // namespace relievo
