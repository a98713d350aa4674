#include "proofs/pipe/lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace mmverify::proofs::pipe {
namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

/// The next number of the text, blanks before it passed over, which is taken off; where there is none, nothing.
template <class Number>
std::optional<Number> number_of(std::string_view& text) {
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  const bool hex = text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  const char *at = text.data() + (hex ? 2 : 0), *end = text.data() + text.size();
  Number number = 0;
  const auto read = std::from_chars(at, end, number, hex ? 16 : 10);
  if (read.ec != std::errc() || (read.ptr != end && !blank(*read.ptr))) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

std::string shown(const std::string& line) { return line.size() > 60 ? line.substr(0, 60) + "..." : line; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

bool Written::line(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  text_ += text;
  text_ += '\n';
  if (text_.size() >= enough) flush();
  return open_;
}

bool Written::end() {
  flush();
  return open_ && std::fflush(out_) == 0;
}

void Written::flush() {
  open_ = open_ && std::fwrite(text_.data(), 1, text_.size(), out_) == text_.size();
  text_.clear();
}

std::string_view Answers::text(std::uint64_t number, std::uint64_t cases) {
  if (!next())
    throw BadAnswers(
        fmt::format("standard input ended after line {}, with {} of {} cases answered", at_, number, cases));
  std::string_view rest = line_;
  const auto which = number_of<std::uint64_t>(rest);
  rest = trimmed(rest);
  if (!which || rest.empty()) garbled(number);
  if (*which != number) fail(fmt::format("case {} where case {} is due", *which, number));
  return rest;
}

std::span<const std::uint32_t> Answers::numbers(std::uint64_t number, std::uint64_t cases,
                                                std::size_t count) {
  std::string_view rest = text(number, cases);
  numbers_.clear();
  while (numbers_.size() < count) {
    const auto one = number_of<std::uint32_t>(rest);
    if (!one) garbled(number);
    numbers_.push_back(*one);
  }
  if (!rest.empty()) garbled(number);
  return numbers_;
}

void Answers::end(std::uint64_t cases) {
  if (next()) fail(fmt::format("more than the {} cases asked", cases));
}

void Answers::garbled(std::uint64_t number) const {
  fail(fmt::format("'{}' is not an answer: write {}, here {} and the {}", shown(line_), form_, number,
                   answer_));
}

bool Answers::next() {
  while (std::getline(in_, line_)) {
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    ++at_;
    if (line_.starts_with(heading_begins) && line_ != heading_)
      fail(fmt::format(
          "'{}' answers other cases; give `check` what `gen` was given, or the other way round: '{}'",
          shown(line_), shown(heading_)));
    if (!line_.empty() && line_.front() != '#') return true;
  }
  return false;
}

void Answers::fail(const std::string& what) const {
  throw BadAnswers(fmt::format("standard input, line {}: {}", at_, what));
}

}  // namespace mmverify::proofs::pipe
