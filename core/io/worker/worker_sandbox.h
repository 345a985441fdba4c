// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace relievo {

/// The environment for a child that reads foreign bytes: what libraries need to be found and
/// sanitizers to report, the C locale, and who started it; nothing else of ours. [any thread]
std::vector<std::string> workerEnvironment();

/// For the child, first of all: it dies with the process that started it, whatever the number of
/// that is (1 in a container).
/// @return  false if that process is gone already
bool dieWithParent();

/// For the child, before it looks at foreign bytes: closes every descriptor above `last_fd`, gives
/// up gaining rights by programs it could start, and lets the kernel refuse (EPERM) what no reader
/// needs: network, other programs and processes, looking into processes, and opening, making,
/// renaming or removing files for writing. Descriptors that are open stay writable, threads may be
/// started. docs/adr/0098. [before other threads are started]
/// @param network  open: of the network nothing is refused, for the process that fetches
/// @return  false if the kernel does not offer the last; the rest is done all the same
enum class SandboxNetwork : bool { refused, open };
bool enterWorkerSandbox(int last_fd, SandboxNetwork network = SandboxNetwork::refused);

}  // namespace relievo
