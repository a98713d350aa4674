// What goes to a program on a pipe and comes back from it: a case a line.
#pragma once

#include <cstdint>
#include <cstdio>
#include <istream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mmverify::proofs::pipe {

/// A line that is no answer, or the end before its time; what() names the line.
struct BadAnswers : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Lines that go out in pieces. A reader that goes away early ends them, and is no error.
class Written {
 public:
  explicit Written(std::FILE* out) : out_(out) {}
  /// Adds a line; false once nobody takes them.
  bool line(std::string_view text);
  /// Sends the rest; false where not all was taken.
  bool end();

 private:
  void flush();

  std::FILE* out_;
  std::string text_;
  bool open_ = true;
};

/// How the first line of all cases begins.
inline constexpr char heading_begins[] = "# mmverify ";

/// The answers' lines, "CASE ANSWER", in the order of the cases. Empty lines and those that start with # are passed
/// over; but a heading that was copied has to be that of these cases.  All functions throw BadAnswers.
class Answers {
 public:
  /// heading: the first line of the cases; form: how a line is to look, "CASE INDEX"; answer: what is answered, "index".
  Answers(std::istream& in, std::string heading, const char* form, const char* answer)
      : in_(in), heading_(std::move(heading)), form_(form), answer_(answer) {}

  /// What answers case `number` of `cases`, in words that blanks part; until the next one is asked for.
  std::string_view text(std::uint64_t number, std::uint64_t cases);
  /// The same, as so many numbers, decimal or 0x hexadecimal.
  std::span<const std::uint32_t> numbers(std::uint64_t number, std::uint64_t cases, std::size_t count);
  /// Nothing may come any more.
  void end(std::uint64_t cases);
  /// The line read last is no answer of case `number`.
  [[noreturn]] void garbled(std::uint64_t number) const;

 private:
  /// The next line that is not passed over.
  bool next();
  [[noreturn]] void fail(const std::string& what) const;

  std::istream& in_;
  std::string heading_;
  const char *form_, *answer_;
  std::string line_;
  std::uint64_t at_ = 0;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace mmverify::proofs::pipe
