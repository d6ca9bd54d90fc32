#include "tools/grade/box_filter.hpp"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>

namespace kreda::tools {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

// Newer than the headers of some distributions; the numbers are the same on all architectures.
constexpr long kNewest[] = {425, 426, 427, 428, 429, 430, 431, 432, 433, 438,
                            442, 443, 447, 452, 463, 464, 466, 467, 469};
// io_uring_setup, _enter, _register, open_tree, move_mount, fsopen, fsconfig, fsmount, fspick, pidfd_getfd,
// mount_setattr, quotactl_fd, memfd_secret, fchmodat2, setxattrat, getxattrat, removexattrat, open_tree_attr,
// file_setattr

constexpr std::uint32_t kClone3 = 435, kPidfdSendSignal = 424, kPidfdOpen = 434, kProcessMadvise = 440;

/// Always refused.
constexpr long kRefused[] = {
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_unshare,
    SYS_setns,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_kcmp,
    SYS_perf_event_open,
    SYS_bpf,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_acct,
    SYS_quotactl,
    SYS_name_to_handle_at,
    SYS_open_by_handle_at,
    SYS_fanotify_init,
    SYS_syslog,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_adjtimex,
    SYS_clock_adjtime,
    SYS_personality,
    // The network, and sockets of every kind.
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    // Memory that no limit counts or that outlives the process.
    SYS_memfd_create,
    SYS_shmget,
    SYS_shmat,
    SYS_msgget,
    SYS_semget,
    SYS_mq_open,
    // Other processes.
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    kPidfdSendSignal,
    kPidfdOpen,
    kProcessMadvise,
    SYS_setpriority,
    SYS_ioprio_set,
    SYS_sched_setaffinity,
    SYS_sched_setparam,
    SYS_sched_setscheduler,
    SYS_sched_setattr,
    SYS_migrate_pages,
    SYS_move_pages,
    // Landlock does not watch over these.
    SYS_truncate,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fchownat,
    SYS_utimensat,
#if defined(__x86_64__)
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
    SYS_iopl,
    SYS_ioperm,
    SYS_modify_ldt,
    SYS_uselib,
#endif
};

/// Refused to a program, allowed to a compiler.
constexpr long kRefusedToPrograms[] = {
    SYS_fchmodat,
#if defined(__x86_64__)
    SYS_chmod,
    SYS_fork,
    SYS_vfork,
#endif
};

constexpr std::uint32_t kNamespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

class Filter {
public:
    Filter() {
        load(offsetof(seccomp_data, arch));
        add(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0);
        end(SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
        constexpr std::uint32_t kX32 = 0x40000000;  // calls of x32 have other numbers
        add(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1);
        end(SECCOMP_RET_KILL_PROCESS);
#endif
    }

    void refuse(long call, int error = EPERM) {
        add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1);
        end(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
    }
    /// Where the low half of argument `i` is this value.
    void refuse_if_equal(long call, std::size_t i, std::uint32_t value) {
        when(call, i, BPF_JEQ, value, true);
    }
    void refuse_unless_equal(long call, std::size_t i, std::uint32_t value) {
        when(call, i, BPF_JEQ, value, false);
    }
    /// Where any of these bits is set.
    void refuse_if_bits(long call, std::size_t i, std::uint32_t bits) {
        when(call, i, BPF_JSET, bits, true);
    }
    void refuse_unless_bits(long call, std::size_t i, std::uint32_t bits) {
        when(call, i, BPF_JSET, bits, false);
    }
    [[nodiscard]] std::vector<sock_filter> finish() {
        end(SECCOMP_RET_ALLOW);
        return program_;
    }

private:
    void add(std::uint32_t code, std::uint32_t k, std::uint8_t if_true = 0, std::uint8_t if_false = 0) {
        program_.push_back({static_cast<std::uint16_t>(code), if_true, if_false, k});
    }
    void load(std::size_t offset) {
        add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
    }
    void end(std::uint32_t action) {
        add(BPF_RET | BPF_K, action);
    }
    void when(long call, std::size_t i, std::uint32_t test, std::uint32_t value, bool refused_if) {
        add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4);
        load(offsetof(seccomp_data, args) + i * sizeof(std::uint64_t));  // both architectures are little-endian
        add(BPF_JMP | test | BPF_K, value, refused_if ? 0 : 1, refused_if ? 1 : 0);
        end(SECCOMP_RET_ERRNO | EPERM);
        load(offsetof(seccomp_data, nr));
    }

    std::vector<sock_filter> program_;
};

void refuse_signals(Filter& filter, bool may_raise) {
    if (may_raise) {
        filter.refuse_unless_equal(SYS_tgkill, 2, SIGABRT);
        filter.refuse_unless_equal(SYS_kill, 1, SIGABRT);
    } else {
        filter.refuse(SYS_tgkill);
        filter.refuse(SYS_kill);
    }
    // A file's owner is sent a signal of one's choice.
    for (const int command : {F_SETOWN, F_SETSIG, 15 /* F_SETOWN_EX */})
        filter.refuse_if_equal(SYS_fcntl, 1, static_cast<std::uint32_t>(command));
    for (const std::uint32_t request :
         {0x8901u /* FIOSETOWN */, 0x8902u /* SIOCSPGRP */, std::uint32_t(TIOCSTI), std::uint32_t(TIOCLINUX)})
        filter.refuse_if_equal(SYS_ioctl, 1, request);
}

}  // namespace

std::vector<sock_filter> make_filter(const FilterWish& wish) {
    if (kArchitecture == 0) return {};
    Filter filter;
    for (const long call : kRefused) filter.refuse(call);
    for (const long call : kNewest) filter.refuse(call);
    refuse_signals(filter, wish.may_raise_signals);
    filter.refuse_unless_equal(SYS_prlimit64, 0, 0);  // limits of other processes
    filter.refuse(kClone3, ENOSYS);                   // its flags lie in memory; the C library falls back to clone
    filter.refuse_if_bits(SYS_clone, 0, kNamespaces);
    if (!wish.may_start_processes) {
        for (const long call : kRefusedToPrograms) filter.refuse(call);
        filter.refuse_unless_bits(SYS_clone, 0, CLONE_THREAD);
    }
    return filter.finish();
}

}  // namespace kreda::tools
