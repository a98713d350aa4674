// Files and processes that a worker keeps away from, by Landlock.
#pragma once

namespace mmverify::dock {

/// From here on this process opens no terminal, and nothing below /proc and /sys, for writing; reads and writes no
/// memory of a process that is not below it, and (Linux 6.12) signals none.  False where the kernel has no Landlock.
/// Needs PR_SET_NO_NEW_PRIVS.
bool lock_out_terminals_and_processes();

}  // namespace mmverify::dock
