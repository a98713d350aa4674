// Lines to and from a program on a pipe: a case a line.
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

/// A line that is no answer, or an early end; what() names the line.
struct BadAnswers : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Output lines, sent in pieces.  If the reader leaves early, output ends without an error.
class Written {
 public:
  explicit Written(std::FILE* out) : out_(out) {}
  /// Adds a line; false if the reader has left.
  bool line(std::string_view text);
  /// Sends the rest; false if not all was accepted.
  bool end();

 private:
  void flush();

  std::FILE* out_;
  std::string text_;
  bool open_ = true;
};

/// The beginning of the first line of all cases.
inline constexpr char heading_begins[] = "# mmverify ";

/// The lines of answers, "CASE ANSWER", in the order of the cases.  Empty lines and lines that start with # are
/// skipped, but a copied heading must match that of these cases.  All functions throw BadAnswers.
class Answers {
 public:
  /// heading: the first line of the cases; form: the form of a line, such as "CASE INDEX"; answer: its name, such as
  /// "index".
  Answers(std::istream& in, std::string heading, const char* form, const char* answer)
      : in_(in), heading_(std::move(heading)), form_(form), answer_(answer) {}

  /// The answer to case `number` of `cases`, words separated by blanks; valid until the next call.
  std::string_view text(std::uint64_t number, std::uint64_t cases);
  /// The answer as `count` numbers, decimal or 0x hexadecimal.
  std::span<const std::uint32_t> numbers(std::uint64_t number, std::uint64_t cases, std::size_t count);
  /// Throws if another line follows.
  void end(std::uint64_t cases);
  /// Throws: the last line read is no answer to case `number`.
  [[noreturn]] void garbled(std::uint64_t number) const;

 private:
  /// Reads the next line that is not skipped.
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
