#include "proofs/index/pipe.hpp"

#include "proofs/engine/runner.hpp"
#include "proofs/index/diagnosis.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/index/subjects/rounded_subject.hpp"
#include "proofs/pipe/lines.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr Level highest_diagnosed = 8;

std::uint64_t cases_of(Level n, bool interiors_only) {
  return interiors_only ? triangle_count(n) : cell_count(n);
}

/// Calls visit(case number, row, t) for each case.
template <class Visit>
void each_case(Level n, bool interiors_only, Visit visit) {
  const Cells cells(n);
  std::uint64_t number = 0;
  cells.rows(0, cells.size(), [&](const Row& row) {
    if (interiors_only && row.even != Kind::interior) return;
    for (std::uint64_t t = 0; t < row.count; ++t) visit(number++, row, t);
  });
}

std::string heading(const char* topic, Level n, std::uint64_t cases) {
  return fmt::format("{}{} level {} cases {}", pipe::heading_begins, topic, n, cases);
}

}  // namespace

bool generate_cases(Level n, bool interiors_only, std::FILE* out) {
  pipe::Written written(out);
  bool open = written.line(heading("index", n, cases_of(n, interiors_only)));
  each_case(n, interiors_only, [&](std::uint64_t number, const Row& row, std::uint64_t t) {
    if (!open) return;
    const GridPoint p = representative(row, t, n);
    open = written.line(fmt::format("{} {:a} {:a}", number, as_double(p.u), as_double(p.v)));
  });
  return written.end();
}

bool generate_indices(Level n, std::FILE* out) {
  pipe::Written written(out);
  bool open = written.line(heading("corners", n, triangle_count(n)));
  for (std::uint64_t k = 0; k < triangle_count(n) && open; ++k)
    open = written.line(fmt::format("{} {}", k, k));
  return written.end();
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
  pipe::Answers answers(in, heading("index", n, r.cases_expected), "CASE INDEX", "index");
  std::vector<std::uint32_t> inside;  // by 2 (i + j N) + inverted, for the diagnosis
  if (n <= highest_diagnosed) inside.resize(std::size_t{2} << (2 * n));
  const auto place = [n](const MicroTriangle& m) {
    return 2 * (m.i + std::size_t{m.j} * side(n)) + (m.inverted ? 1 : 0);
  };
  each_case(n, interiors_only, [&](std::uint64_t number, const Row& row, std::uint64_t t) {
    const std::uint32_t got = answers.numbers(number, r.cases_expected, 1).front();
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
  answers.end(r.cases_expected);

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

Answered check_corners(Level n, std::size_t errors, std::istream& in) {
  pipe::Answers answers(in, heading("corners", n, triangle_count(n)), "CASE I0 J0 I1 J1 I2 J2", "corners");
  std::vector<Corners> given(triangle_count(n));
  for (std::uint64_t k = 0; k < given.size(); ++k) {
    const auto c = answers.numbers(k, given.size(), 6);
    given[k] = {spec::index::Vertex{c[0], c[1]}, spec::index::Vertex{c[2], c[3]},
                spec::index::Vertex{c[4], c[5]}};
  }
  answers.end(given.size());

  // The answers make a subject like any other, of this one level.
  Functions f;
  f.corners = [&given](Level, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = given[indices[t]];
  };
  const IndexSubject subject("standard input", "answers on a pipe", std::move(f));
  Run run;
  run.errors = errors;
  std::vector<Law> all = laws();
  const auto law =
      std::find_if(all.begin(), all.end(), [](const Law& one) { return one.id == "index.corners"; });
  law->topic = subject.topic();
  Answered answered{run_level(*law, subject, n, run), {}};
  answered.diagnosis.push_back("its order of corners: " + name_corner_order(subject, n));
  return answered;
}

}  // namespace mmverify::proofs::index
