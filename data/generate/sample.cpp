// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/sample.h"

#include <fstream>
#include <stdexcept>

namespace relievo::samples {

void writeFile(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::path part = file;
  part += ".part";
  {
    std::ofstream out(part, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw std::runtime_error("Cannot write " + part.string() + ".");
  }
  std::filesystem::rename(part, file);
}

}  // namespace relievo::samples
