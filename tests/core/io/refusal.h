// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/error.h"

namespace relievo::test {

/// How a file was refused.
struct Refusal {
  std::string words = "it was not refused";
  std::string code = "not refused";  ///< Of the error catalogue, or empty.
};

template <class Work>
Refusal refusalOf(const Work& work) {
  try {
    work();
  } catch (const FileError& error) {
    return {error.what(), error.code};
  }
  return {};
}

}  // namespace relievo::test
