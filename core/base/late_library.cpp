// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/late_library.h"

#include <dlfcn.h>

namespace relievo {

namespace {
std::string lastProblem() {
  const char* const words = dlerror();
  return words == nullptr ? "the system does not say why" : words;
}
}  // namespace

LateLibrary::LateLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) problem_ = lastProblem();
}

void* LateLibrary::addressOf(const char* name) {
  if (!isThere()) return nullptr;
  void* const address = dlsym(handle_, name);
  if (address == nullptr) problem_ = lastProblem();
  return address;
}

}  // namespace relievo
