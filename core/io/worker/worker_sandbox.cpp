// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/worker_sandbox.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace relievo {
namespace {

constexpr std::string_view kParent = "RELIEVO_PARENT=";

/// Where libraries, their tables and sanitizers' settings are.
constexpr std::array<std::string_view, 11> kKept{
    "LD_LIBRARY_PATH=", "PROJ_LIB=",          "PROJ_DATA=",     "GDAL_DATA=",
    "ASAN_OPTIONS=",    "UBSAN_OPTIONS=",     "TSAN_OPTIONS=",  "LSAN_OPTIONS=",
    "GCOV_PREFIX=",     "GCOV_PREFIX_STRIP=", "GLIBC_TUNABLES="};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitizer = true;  // Its search for leaks traces a process that it starts.
#else
constexpr bool kSanitizer = false;
#endif

#if defined(__x86_64__)
#define RELIEVO_AUDIT_ARCH AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define RELIEVO_AUDIT_ARCH AUDIT_ARCH_AARCH64
#endif

/// Calls that only the process makes that fetches.
constexpr auto kNetwork = std::to_array<std::uint32_t>({
    __NR_socket,
    __NR_socketpair,
    __NR_connect,
    __NR_bind,
    __NR_listen,
    __NR_accept,
    __NR_accept4,
    __NR_sendto,
    __NR_sendmsg,
    __NR_sendmmsg,
});

/// Calls that no reader makes. Those that an architecture does not have are left out.
constexpr auto kRefused = std::to_array<std::uint32_t>({
    // Programs, and rights.
    __NR_execve,
    __NR_execveat,
    __NR_setuid,
    __NR_setgid,
    __NR_setreuid,
    __NR_setregid,
    __NR_setresuid,
    __NR_setresgid,
    __NR_setgroups,
    __NR_capset,
    __NR_unshare,
    __NR_setns,
    __NR_chroot,
    __NR_pivot_root,
    __NR_mount,
    __NR_umount2,
    __NR_keyctl,
    __NR_add_key,
    __NR_request_key,
    __NR_bpf,
    __NR_perf_event_open,
    __NR_userfaultfd,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_kexec_load,
    __NR_reboot,
    __NR_swapon,
    __NR_swapoff,
    __NR_acct,
    __NR_sethostname,
    __NR_setdomainname,
    __NR_personality,
    __NR_settimeofday,
    __NR_clock_settime,
    __NR_adjtimex,
    // Other processes.
    __NR_process_vm_writev,
    __NR_kcmp,
    __NR_tkill,
    __NR_rt_sigqueueinfo,
    __NR_shmget,
    __NR_semget,
    __NR_msgget,
    __NR_mq_open,
#ifdef __NR_pidfd_open
    __NR_pidfd_open,
#endif
#ifdef __NR_pidfd_getfd
    __NR_pidfd_getfd,
#endif
#ifdef __NR_pidfd_send_signal
    __NR_pidfd_send_signal,
#endif
#ifdef __NR_fork
    __NR_fork,
    __NR_vfork,
#endif
// Files by their names.
#ifdef __NR_creat
    __NR_creat,
    __NR_mkdir,
    __NR_rmdir,
    __NR_rename,
    __NR_link,
    __NR_unlink,
    __NR_symlink,
    __NR_chmod,
    __NR_chown,
    __NR_lchown,
    __NR_mknod,
    __NR_utime,
    __NR_utimes,
    __NR_futimesat,
#endif
#ifdef __NR_renameat
    __NR_renameat,
#endif
    __NR_mkdirat,
    __NR_unlinkat,
    __NR_renameat2,
    __NR_linkat,
    __NR_symlinkat,
    __NR_mknodat,
    __NR_fchmodat,
    __NR_fchownat,
    __NR_truncate,
    __NR_utimensat,
    __NR_setxattr,
    __NR_lsetxattr,
    __NR_removexattr,
    __NR_lremovexattr,
    __NR_open_by_handle_at,
    __NR_name_to_handle_at,
    __NR_fanotify_init,
});

/// What only a sanitizer's own search needs.
constexpr auto kTracing = std::to_array<std::uint32_t>({__NR_ptrace, __NR_process_vm_readv});

/// Calls whose arguments a filter cannot see: callers then use the older ones.
constexpr auto kUnknown = std::to_array<std::uint32_t>({
#ifdef __NR_openat2
    __NR_openat2,
#endif
#ifdef __NR_clone3
    __NR_clone3,
#endif
#ifdef __NR_io_uring_setup
    __NR_io_uring_setup,
    __NR_io_uring_enter,
    __NR_io_uring_register,
#endif
});

class Filter {
 public:
  void load(std::size_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  }
  void loadCall() { load(offsetof(seccomp_data, nr)); }
  void loadArgument(std::size_t number) {  // Its lower half, on machines that store that first.
    load(offsetof(seccomp_data, args) + 8 * number);
  }
  void answer(std::uint32_t action) { add(BPF_RET | BPF_K, action); }
  void answerIf(std::uint32_t value, std::uint32_t action) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
    answer(action);
  }
  void answerUnless(std::uint32_t value, std::uint32_t action) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0));
    answer(action);
  }
  void answerFrom(std::uint32_t least, std::uint32_t action) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, least, 0, 1));
    answer(action);
  }
  /// Of `call`, an argument's bits decide: `if_any` if any of them is set, else `if_none`.
  void answerByBits(std::uint32_t call, std::size_t argument, std::uint32_t bits,
                    std::uint32_t if_any, std::uint32_t if_none) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
    loadArgument(argument);
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, 0, 1));
    answer(if_any);
    answer(if_none);
  }
  /// `call` may only name this number in its first argument.
  void allowOnlyFor(std::uint32_t call, std::uint32_t first_argument, std::uint32_t otherwise) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
    loadArgument(0);
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, first_argument, 0, 1));
    answer(SECCOMP_RET_ALLOW);
    answer(otherwise);
  }
  bool install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    // Also for threads that a library started before main().
    return ::syscall(__NR_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) ==
           0;
  }

 private:
  void add(int code, std::uint32_t value) {
    code_.push_back(BPF_STMT(static_cast<std::uint16_t>(code), value));
  }
  std::vector<sock_filter> code_;
};

#ifdef RELIEVO_AUDIT_ARCH
bool installFilter(SandboxNetwork network) {
  constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;
  constexpr std::uint32_t kNone = SECCOMP_RET_ERRNO | ENOSYS;
  constexpr std::uint32_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
  Filter filter;
  filter.load(offsetof(seccomp_data, arch));
  filter.answerUnless(RELIEVO_AUDIT_ARCH, SECCOMP_RET_KILL_PROCESS);
  filter.loadCall();
#ifdef __x86_64__
  filter.answerFrom(0x40000000U, SECCOMP_RET_KILL_PROCESS);  // The same calls by other numbers.
#endif
  for (const std::uint32_t call : kRefused) filter.answerIf(call, kRefuse);
  if (network == SandboxNetwork::refused) {
    for (const std::uint32_t call : kNetwork) filter.answerIf(call, kRefuse);
  }
  for (const std::uint32_t call : kUnknown) filter.answerIf(call, kNone);
  if (!kSanitizer) {
    for (const std::uint32_t call : kTracing) filter.answerIf(call, kRefuse);
    filter.answerByBits(__NR_clone, 0, CLONE_THREAD, SECCOMP_RET_ALLOW, kRefuse);
  }
#ifdef __NR_open
  filter.answerByBits(__NR_open, 1, kWriting, kRefuse, SECCOMP_RET_ALLOW);
#endif
  filter.answerByBits(__NR_openat, 2, kWriting, kRefuse, SECCOMP_RET_ALLOW);
  const auto self = static_cast<std::uint32_t>(::getpid());
  filter.allowOnlyFor(__NR_kill, self, kRefuse);
  filter.allowOnlyFor(__NR_tgkill, self, kRefuse);
  filter.answer(SECCOMP_RET_ALLOW);
  return filter.install();
}
#else
bool installFilter(SandboxNetwork /*network*/) {
  return false;
}
#endif

}  // namespace

std::vector<std::string> workerEnvironment() {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const bool kept = std::any_of(kKept.begin(), kKept.end(),
                                  [text](std::string_view name) { return text.starts_with(name); });
    if (kept) environment.emplace_back(text);
  }
  environment.emplace_back("LC_ALL=C");  // For libraries that set the locale as they load.
  environment.push_back(std::string(kParent) + std::to_string(::getpid()));
  return environment;
}

bool dieWithParent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Asked after the line above: whoever died before it is somebody else now.
  const std::string name(kParent.substr(0, kParent.size() - 1));
  const char* const stated = std::getenv(name.c_str());  // NOLINT(concurrency-mt-unsafe)
  if (stated == nullptr) return false;
  const std::string_view text = stated;
  pid_t parent = 0;
  std::from_chars(text.data(), text.data() + text.size(), parent);
  return parent > 0 && ::getppid() == parent;
}

bool enterWorkerSandbox(int last_fd, SandboxNetwork network) {
  ::close_range(static_cast<unsigned>(last_fd) + 1, ~0U, 0);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  return installFilter(network);
}

}  // namespace relievo
