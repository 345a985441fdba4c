// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace relievo {

/// In which folder `relievo` lies: the programs that read files, and the one that draws, are looked
/// for from there. A program says it that is not relievo itself and holds its modules, as Python
/// does; otherwise the folder is that of the running program. [before all else]
void setProgramFolder(const std::filesystem::path& folder);

}  // namespace relievo
