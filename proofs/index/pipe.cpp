#include "proofs/index/pipe.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "proofs/index/diagnosis.hpp"
#include "proofs/index/on_cells.hpp"
#include "proofs/index/rounded_subject.hpp"
#include "proofs/kinds.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr Level highest_diagnosed = 8;

std::uint64_t cases_of(Level n, bool interiors_only) {
  return interiors_only ? triangle_count(n) : cell_count(n);
}

/// Calls visit(case number, row, t) for each case asked for.
template <class Visit>
void each_case(Level n, bool interiors_only, Visit visit) {
  const Cells cells(n);
  std::uint64_t number = 0;
  cells.rows(0, cells.size(), [&](const Row& row) {
    if (interiors_only && row.even != Kind::interior) return;
    for (std::uint64_t t = 0; t < row.count; ++t) visit(number++, row, t);
  });
}

/// The answers' lines, with what is wrong with one of them.
class Lines {
 public:
  explicit Lines(std::istream& in) : in_(in) {}

  /// The index that answers case `number`.
  std::uint32_t answer(std::uint64_t number, std::uint64_t cases) {
    while (next())
      if (!text_.empty() && text_.front() != '#') return parse(number);
    throw BadAnswers(fmt::format("standard input ended after line {}, with {} of {} cases answered", line_,
                                 number, cases));
  }

  void end(std::uint64_t cases) {
    while (next())
      if (!text_.empty() && text_.front() != '#')
        fail(fmt::format("more than the {} cases of this level", cases));
  }

 private:
  bool next() {
    if (!std::getline(in_, text_)) return false;
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    ++line_;
    return true;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw BadAnswers(fmt::format("standard input, line {}: {}", line_, what));
  }

  std::uint32_t parse(std::uint64_t number) const {
    const auto garbled = [&] {
      const std::string shown = text_.size() > 60 ? text_.substr(0, 60) + "..." : text_;
      fail(fmt::format("'{}' is not an answer: write CASE INDEX, here {} and the index", shown, number));
    };
    std::uint64_t which = 0;
    std::uint32_t index = 0;
    const char *at = text_.data(), *end = at + text_.size();
    const auto first = std::from_chars(at, end, which);
    if (first.ec != std::errc() || first.ptr == end || (*first.ptr != ' ' && *first.ptr != '\t')) garbled();
    at = first.ptr;
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
    const bool hex = end - at > 2 && at[0] == '0' && (at[1] == 'x' || at[1] == 'X');
    const auto second = std::from_chars(hex ? at + 2 : at, end, index, hex ? 16 : 10);
    if (second.ec != std::errc()) garbled();
    for (at = second.ptr; at != end; ++at)
      if (*at != ' ' && *at != '\t') garbled();
    if (which != number) fail(fmt::format("case {} where case {} is due", which, number));
    return index;
  }

  std::istream& in_;
  std::string text_;
  std::uint64_t line_ = 0;
};

}  // namespace

bool generate_cases(Level n, bool interiors_only, std::FILE* out) {
  bool open = true;
  std::string text = fmt::format("# mmverify index level {} cases {}\n", n, cases_of(n, interiors_only));
  constexpr std::size_t enough = 1 << 16;
  const auto flush = [&] {
    open = open && std::fwrite(text.data(), 1, text.size(), out) == text.size();
    text.clear();
  };
  each_case(n, interiors_only, [&](std::uint64_t number, const Row& row, std::uint64_t t) {
    if (!open) return;
    const GridPoint p = representative(row, t, n);
    fmt::format_to(std::back_inserter(text), "{} {:a} {:a}\n", number, as_double(p.u), as_double(p.v));
    if (text.size() >= enough) flush();
  });
  flush();
  return open && std::fflush(out) == 0;
}

Answered check_answers(Level n, bool interiors_only, std::size_t errors, std::istream& in) {
  Answered answered;
  Result& r = answered.result;
  r.law = "index.equals_reference";
  r.topic = "index";
  r.subject = "standard input";
  r.level = n;
  r.method = "exhaustive, against 64-bit fixed point";
  r.domain = interiors_only ? "the representatives of the N^2 open micro-triangles"
                            : "the 3N^2+3N+1 representatives";
  r.cases_expected = cases_of(n, interiors_only);

  Tally tally(errors);
  Lines lines(in);
  std::vector<std::uint32_t> inside;  // by 2 (i + j N) + inverted, for the diagnosis
  if (n <= highest_diagnosed) inside.resize(std::size_t{2} << (2 * n));
  const auto place = [n](const MicroTriangle& m) {
    return 2 * (m.i + std::size_t{m.j} * side(n)) + (m.inverted ? 1 : 0);
  };
  each_case(n, interiors_only, [&](std::uint64_t number, const Row& row, std::uint64_t t) {
    const std::uint32_t got = lines.answer(number, r.cases_expected);
    const GridPoint p = representative(row, t, n);
    const std::uint32_t want = spec::index::reference(p, n);
    tally.count(row.kind(t), 1);
    tally.digest(row.first + t, got);
    if (!inside.empty() && row.kind(t) == Kind::interior)
      inside[place({static_cast<std::uint32_t>((row.ku + static_cast<std::int64_t>(t) * row.stride) / 4),
                    static_cast<std::uint32_t>(row.kv / 4), row.kv % 4 == 3})] = got;
    if (want != got)
      tally.mismatch(row.kind(t), simplicity(p),
                     [&] { return at_point(p, n, say_number(want), say_number(got)); });
  });
  lines.end(r.cases_expected);

  r.by_kind = tally.by_kind();
  r.counterexamples = tally.found();
  r.digest = tally.digest();
  r.verdict = r.mismatches() == 0 ? Verdict::proved : Verdict::refuted;
  if (r.verdict == Verdict::refuted) {
    const std::uint64_t interiors = r.by_kind[static_cast<std::size_t>(Kind::interior)].mismatches;
    if (interiors == 0) answered.diagnosis.push_back("wrong on ties only; every interior is right");
    if (interiors != 0 && n >= 1 && !inside.empty()) {
      const std::string order = name_order(n, [&](const MicroTriangle& m) { return inside[place(m)]; });
      if (!order.empty()) answered.diagnosis.push_back("its order: " + order);
    }
  }
  return answered;
}

}  // namespace mmverify::proofs::index
