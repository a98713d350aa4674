// Keeps a worker from files and processes by Landlock.
#pragma once

namespace mmverify::dock {

/// Restricts this process: it opens no terminal, and nothing below /proc and /sys, for writing; it reads and
/// writes no memory of a process that is not its descendant, and (Linux 6.12) signals none. False if the
/// kernel has no Landlock. PR_SET_NO_NEW_PRIVS must be set.
bool lock_out_terminals_and_processes();

}  // namespace mmverify::dock
