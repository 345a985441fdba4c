// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <thread>

namespace relievo::test {

/// Runs `function` without an administrator's power over files, whoever runs the test: in a thread
/// of its own, because a thread cannot take the power back.
inline void asOrdinaryAccount(const std::function<void()>& function) {
  std::thread([&function] {
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
    if (syscall(SYS_capset, &header, none.data()) != 0) throw std::runtime_error("capset");
    function();
  }).join();
}

}  // namespace relievo::test
