// Confines a worker process, so that it harms neither the machine nor the tool.
#pragma once

namespace mmverify::dock {

/// Confines this process, and with it the subject. From here on it
///   - starts no other process (fork and its like fail with EAGAIN; threads are free) and stays in its group
///     and session;
///   - sends signals only to itself, and none that would seem to come from outside: SIGKILL, stops;
///   - reads and writes no other process's memory, also as root, and takes no other process's descriptors;
///   - writes to no terminal, and to nothing below /proc and /sys;
///   - raises no limit (EPERM), makes no memory that belongs to no process (memfd_create: ENOSYS; shmget:
///     EPERM);
///   - has at most `open_files` files open, and writes none longer than `file_bytes`.
/// The tool watches its memory, its threads and the bytes that it writes in all: see Worker.
/// No rights are needed. Seccomp filters calls, Landlock (Linux 5.13) guards paths. Without Landlock, a user
/// namespace, or for root the dropped capabilities, still keep other processes' memory out of reach.
void confine();

/// Closes all descriptors from `first` on.
void close_from(int first);

constexpr unsigned open_files = 256;
constexpr unsigned long file_bytes = 64ul << 20;

}  // namespace mmverify::dock
