// The program's own three streams: what is printed, and what becomes of it where nobody takes it.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace mmverify::cli {

/// Opens /dev/null in the place of each standard stream that the caller has closed: or the first file that the program
/// writes would have its descriptor, and what is printed would go into that file.
void reserve_standard_streams();

/// Lets SIGPIPE end the program: for a command that only prints.  Any other goes on without its reader, since its files
/// and its exit code are still to come.
void end_with_the_reader();

/// Prints to stdout or stderr, and never throws: a stream that takes no more must not cost a result its file.
void say_text(std::FILE* out, std::string_view text) noexcept;

template <class... Args>
void say(std::FILE* out, fmt::format_string<Args...> format, Args&&... args) {
  say_text(out, fmt::format(format, std::forward<Args>(args)...));
}

/// The exit code of a program that has printed all it had to: 4 in the place of 0 where standard output did not take it.
/// A reader that went away took what it wanted: the code stays.
int after_printing(int code);

}  // namespace mmverify::cli
