// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/vtk_version.h"

#include <vtkVersion.h>

namespace relievo {

std::string vtkVersionText() {
  return vtkVersion::GetVTKVersion();
}

}  // namespace relievo
