// [release, night] The laws of orders at every level: each hypothesis can be fulfilled, each mistake fails where it is, and the parts that
// the statements are about are what the specification is made of.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "proofs/attribute/elements.hpp"
#include "proofs/attribute/induction/provable.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/sanitized.hpp"

namespace attribute_induction_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::attribute;
using namespace mmverify::proofs::attribute::induction;
using mmverify::proofs::induction::Answer;
using mmverify::proofs::induction::ask_z3;
using mmverify::spec::attribute::face_count;
using mmverify::spec::attribute::face_orders;
using mmverify::spec::attribute::vertex_count;
using mmverify::spec::attribute::vertex_orders;
using LawRun = mmverify::proofs::Run;
using Names = std::set<std::string>;

const std::map<std::string, std::vector<Statement> (*)()> shipped{
    {"attribute.w_minor_all_levels", shipped_w_minor},
    {"attribute.u_major_all_levels", shipped_u_major},
    {"attribute.bird_all_levels", shipped_bird},
    {"attribute.faces_all_levels", shipped_faces}};

TEST(AttributeStatements, EachLemmaHasItsWitness) {
  for (const auto& [id, statements] : shipped) {
    Names lemmas, witnesses;
    for (const Statement& s : statements()) {
      const bool witness = s.name.starts_with("witness_");
      EXPECT_EQ(s.expected, witness ? Answer::sat : Answer::unsat) << s.name;
      (witness ? witnesses : lemmas).insert(witness ? s.name.substr(8) : s.name);
    }
    EXPECT_EQ(lemmas, witnesses) << id;
  }
}

/// The names of the statements that do not come out as expected.
/// Those that z3 settles the other way: an answer of `unknown` is none.
Names failing(const std::vector<Statement>& statements) {
  Names names;
  for (const Statement& s : statements)
    if (const Answer answer = ask_z3(s).answer; answer != s.expected && answer != Answer::unknown)
      names.insert(s.name);
  return names;
}

/// The statements that fail for a mutant, and the lowest level that shows it, both worked out by hand.
struct Shown {
  Names statements;
  Level level;
};
const std::map<std::string, Shown> expected_of_mutants{
    {"rows from number 16 on begin where row 15 does", {{"w_minor_back", "w_minor_onto"}, 4}},
    {"a row's first index is taken for the row before", {{"triangular_root"}, 0}},
    {"the way back counts j from the edge w-v", {{"w_minor_back", "w_minor_onto"}, 0}},
    {"each column has N+1 vertices", {{"u_major_reversed"}, 1}},
    {"columns from number 9 on have one length", {{"u_major_reversed"}, 4}},
    {"the way back reads columns from their far end", {{"u_major_back", "u_major_onto"}, 0}},
    {"an upper face has its square's row", {{"rows_back", "rows_onto"}, 1}},
    {"strips from number 8 on have one length", {{"u_major_faces_reversed"}, 4}},
    {"an upper face's corners wind the other way", {{"corners"}, 1}},
    {"on the way back child 3 does not change the first two corners", {{"curve_corners_step"}, 2}},
    {"triplets begin with the edge u-v", {{"bird_middle"}, 1}},
    {"a middle child's children are counted as if it were not turned", {{"upright_step"}, 3}},
    {"children with 4 to a side or more are counted as with 2", {{"upright_step"}, 4}},
    {"a level's vertices begin at T(M), not at T(M+1)", {{"bird_number"}, 1}},
    {"the way back takes the middle child for an upright one", {{"upright_step"}, 2}},
};

TEST(AttributeMutants, FailInTheStatementsThatTheirMistakeIsIn) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  std::size_t met = 0;
  for (const auto& [id, statements] : shipped)
    for (const Mutant& m : find_law(id)->mutants) {
      const Names failed = failing(dynamic_cast<const Provable&>(*m.subject).statements());
      for (const std::string& name : expected_of_mutants.at(m.name).statements)
        EXPECT_TRUE(failed.contains(name)) << m.name << ": " << name << " holds";
      ++met;
    }
  EXPECT_EQ(met, expected_of_mutants.size());
}

TEST(AttributeMutants, AreRefutedOnTheLowestLevelThatShowsThem) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  for (const auto& [id, statements] : shipped)
    for (const Mutant& m : find_law(id)->mutants) {
      const Law& law = *find_law(id);
      const Result r = run_level(law, *m.subject, 0, LawRun{});
      EXPECT_EQ(r.verdict, Verdict::refuted) << m.name;
      ASSERT_EQ(r.counterexamples.size(), 1u) << m.name;
      const Counterexample& c = r.counterexamples.front();
      EXPECT_EQ(c.level, expected_of_mutants.at(m.name).level) << m.name;
      EXPECT_FALSE(law.replay(*m.subject, c.level, c.at).holds) << m.name;
      EXPECT_TRUE(law.replay(*find_subject("attribute-spec"), c.level, c.at).holds) << m.name;
    }
}

/// Compares the answers of both subjects to `ask(subject, out)`.
template <class Answer, class Ask>
void expect_same(std::size_t count, const std::string& what, Ask ask) {
  const auto specified = built_in("attribute-spec");
  const auto by_parts = specified_by_parts();
  std::vector<Answer> wanted(count), got(count);
  ask(specified->functions.orders, wanted);
  ask(by_parts->functions.orders, got);
  EXPECT_TRUE(wanted == got) << what;
}

// The theorem is about the functions of spec/attribute/order.hpp: put together from the parts that the statements run on
// names, the orders are these.
TEST(AttributeParts, MakeUpTheSpecificationOnLevels0To8) {
  for (Level n = 0; n <= 8; ++n) {
    const std::size_t vertices = vertex_count(n), faces = face_count(n);
    std::vector<Vertex> at(vertices);
    fill(n, 0, std::span(at));
    std::vector<MicroTriangle> of(faces);
    fill(n, 0, std::span(of));
    std::vector<std::uint32_t> number(std::max(vertices, faces));
    for (std::size_t k = 0; k < number.size(); ++k) number[k] = static_cast<std::uint32_t>(k);
    const std::span<const std::uint32_t> of_vertices(number.data(), vertices), of_faces(number.data(), faces);
    for (const VertexOrder order : vertex_orders) {
      const std::string what = fmt::format("level {}, {}", n, name_of(order));
      expect_same<std::uint32_t>(vertices, what,
                                 [&](const Orders& f, auto& out) { f.vertex_index(order, n, at, out); });
      expect_same<Vertex>(vertices, what,
                          [&](const Orders& f, auto& out) { f.vertex_at(order, n, of_vertices, out); });
      expect_same<Triplet>(faces, what, [&](const Orders& f, auto& out) {
        f.triplet(FaceOrder::curve, order, n, of_faces, out);
      });
    }
    for (const FaceOrder order : face_orders) {
      const std::string what = fmt::format("level {}, faces {}", n, name_of(order));
      expect_same<std::uint32_t>(faces, what,
                                 [&](const Orders& f, auto& out) { f.face_index(order, n, of, out); });
      expect_same<MicroTriangle>(faces, what,
                                 [&](const Orders& f, auto& out) { f.face_at(order, n, of_faces, out); });
    }
  }
}

// The statements assume this recurrence: level M has T(M+1) vertices, the next one 3 T(M) more, and T(M) faces are
// upright.
TEST(AttributeParts, LevelsGrowAsTheStatementsSay) {
  for (Level n = 0; n <= 8; ++n) {
    std::vector<MicroTriangle> of(face_count(n));
    fill(n, 0, std::span(of));
    std::uint64_t upright = 0;
    for (const MicroTriangle& t : of) upright += t.upper ? 0 : 1;
    EXPECT_EQ(vertex_count(n + 1) - vertex_count(n), 3 * upright) << n;
    EXPECT_EQ(mmverify::spec::attribute::upright_within(std::uint64_t{mmverify::spec::side(n)}, true),
              upright)
        << n;
  }
}

TEST(AttributeLaws, AreAboutTheSpecification) {
  for (const auto& [id, statements] : shipped) {
    const Law& law = *find_law(id);
    const Result r = run_level(law, *find_subject("attribute-spec"), 0, LawRun{});
    EXPECT_EQ(r.verdict, Verdict::proved) << id << " " << r.reason;
    EXPECT_EQ(r.proof, "induction");
    EXPECT_EQ(r.cases_run(), statements().size());
    for (const char* name : {"attribute", "attribute-single", "step"})
      EXPECT_EQ(run_level(law, *find_subject(name), 0, LawRun{}).verdict, Verdict::not_applicable) << name;
  }
}

}  // namespace attribute_induction_test
