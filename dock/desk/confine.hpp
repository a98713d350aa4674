// What a worker may not do to the machine.
#pragma once

namespace mmverify::dock {

/// From here on this process, and with it the subject: starts no other process (fork and its like fail with EAGAIN;
/// threads are free), sends signals to none but itself, traces none and raises no limit (EPERM); has `open_files` files
/// open at most, and writes none longer than `file_bytes`.  Memory and threads are the tool's to watch: see Worker.
/// Needs no rights.  A kernel without seccomp leaves the first three to the good will of the subject.
void confine();

constexpr unsigned open_files = 256;
constexpr unsigned long file_bytes = 64ul << 20;

}  // namespace mmverify::dock
