// The program's three standard streams: output, and its failures.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace mmverify::cli {

/// Opens /dev/null for each standard stream that the caller has closed: otherwise the first file that the
/// program opens would get its descriptor, and output would go into that file.
void reserve_standard_streams();

/// Lets SIGPIPE end the program, for a command that only prints. Other commands go on without their reader,
/// since their files and exit code are still to come.
void end_with_the_reader();

/// Prints to stdout or stderr and never throws: a stream that fails must not cost a result its file.
void say_text(std::FILE* out, std::string_view text) noexcept;

template <class... Args>
void say(std::FILE* out, fmt::format_string<Args...> format, Args&&... args) {
  say_text(out, fmt::format(format, std::forward<Args>(args)...));
}

/// The exit code after all output: 4 instead of 0 if standard output failed. If the reader closed the pipe,
/// the code stays.
int after_printing(int code);

}  // namespace mmverify::cli
