// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/signal_stack.h"

#include <sys/mman.h>
#include <csignal>

#include <cstddef>

namespace relievo {

namespace {
constexpr std::size_t kBytes = std::size_t{64} << 10U;  // Registers alone take up to 11 kB.

class SignalStack {
 public:
  SignalStack() {
    stack_t before{};
    if (sigaltstack(nullptr, &before) != 0 || (before.ss_flags & SS_DISABLE) == 0) return;
    void* memory =
        ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    memory_ = memory;
    stack_t mine{};
    mine.ss_sp = memory_;
    mine.ss_size = kBytes;
    sigaltstack(&mine, nullptr);
  }
  ~SignalStack() {
    if (memory_ == nullptr) return;
    stack_t now{};
    if (sigaltstack(nullptr, &now) == 0 && now.ss_sp == memory_) {
      stack_t none{};
      none.ss_flags = SS_DISABLE;
      if (sigaltstack(&none, nullptr) != 0) return;  // In use: never freed.
    }
    ::munmap(memory_, kBytes);
  }
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;

 private:
  void* memory_ = nullptr;
};
}  // namespace

void giveSignalStack() {
  // Its destructor runs when the thread ends, and only there can it be taken away.
  [[maybe_unused]] thread_local const SignalStack kStack;
}

}  // namespace relievo
