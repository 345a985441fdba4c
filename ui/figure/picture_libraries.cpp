// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/picture_libraries.h"

#include <QtGlobal>

#include "ui/vtk/vtk_version.h"

namespace relievo {

std::vector<LibraryVersion> pictureLibraries() {
  return {{"Qt", qVersion()}, {"VTK", vtkVersionText()}};
}

}  // namespace relievo
