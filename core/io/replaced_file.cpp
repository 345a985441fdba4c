// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/replaced_file.h"

#include <unistd.h>

#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/replaceable.h"

namespace relievo {

void cannotWrite(const std::filesystem::path& file, const std::string& reason) {
  throw WriteError("Cannot write " + file.string() + ": " + reason +
                   ". Check the folder, its permissions and the free space.");
}

ReplacedFile::ReplacedFile(std::filesystem::path final_name)
    : final_(std::move(final_name)),
      temporary_(final_.parent_path() /
                 ("." + final_.stem().string() + "." + std::to_string(::getpid()) + ".tmp" +
                  final_.extension().string())) {
  requireReplaceable(final_);
}

ReplacedFile::~ReplacedFile() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(temporary_, ignored);
}

void ReplacedFile::keep() {
  std::error_code error;
  std::filesystem::rename(temporary_, final_, error);
  if (error) cannotWrite(final_, error.message());
  kept_ = true;
}

}  // namespace relievo
