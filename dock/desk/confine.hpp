// Limits of a worker process: it harms neither the machine nor the tool.
#pragma once

namespace mmverify::dock {

/// From here on this process, and with it the subject,
///   - starts no other process (fork and its like fail with EAGAIN; threads are free) and stays in its group and session;
///   - sends signals to none but itself, and none that would look as if it came from outside: SIGKILL, stops;
///   - reads and writes no other process's memory, also as root, and takes no other process's descriptors;
///   - writes to no terminal, and to nothing below /proc and /sys;
///   - raises no limit (EPERM), makes no memory that belongs to no process (memfd_create: ENOSYS; shmget: EPERM);
///   - has `open_files` files open at most, and writes none longer than `file_bytes`.
/// Memory, threads and what is written in all are the tool's to watch: see Worker.
/// Needs no rights.  Seccomp does it, and Landlock (Linux 5.13) what paths are in; without Landlock a user namespace,
/// or of root the want of capabilities, still keeps other processes' memory out of reach.
void confine();

/// Closes all descriptors from this one on.
void close_from(int first);

constexpr unsigned open_files = 256;
constexpr unsigned long file_bytes = 64ul << 20;

}  // namespace mmverify::dock
