// [release] Every entry point that takes floats has a law on floats, and it runs wherever a proof over cells asks that entry
// point: cells decide nothing for a subject that rounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "proofs/index/subject.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/tree/subject.hpp"

namespace {

using namespace mmverify::proofs;
using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's

/// Whoever adds an entry point that takes floats comes by here: it needs a line in `Entries`, below.  Those of
/// attribute maps and of graphs are asked by samples of floats alone, so that no proof over cells has to bring one along.
TEST(FloatLaws, TheHeadersEntryPointsForPointsAreThese) {
  std::ifstream file(MMVERIFY_HEADER);
  const std::string header{std::istreambuf_iterator<char>(file), {}};
  const std::regex entry(R"(\(\*(\w+)\)\(([^;]*)\);)"), floats(R"(const (float|double)\*)");
  std::set<std::string> taking_floats;
  for (std::sregex_iterator at(header.begin(), header.end(), entry), end; at != end; ++at)
    if (const std::string parameters = (*at)[2]; std::regex_search(parameters, floats))
      taking_floats.insert((*at)[1]);
  EXPECT_THAT(taking_floats,
              testing::ElementsAre("attribute_triplet_f32", "attribute_weights_f32", "dag_lookup_f32",
                                   "index_f32", "index_f64", "row_index_f32", "tree_lookup_f32"));
}

/// A float subject that has every entry point, but for what is taken away.
SubjectPtr index_probe(index::Arithmetic arithmetic, void (*take_away)(index::Functions&) = nullptr) {
  using namespace index;
  Functions f;
  f.arithmetic = arithmetic;
  f.index = f.row_index = [](Level, Batch, auto) {};
  f.index_floats = f.row_index_floats = [](Level, FloatBatch, auto) {};
  f.index_at = f.row_index_at = [](Level, const RationalPoint&) { return 0u; };
  f.corners = f.row_corners = [](Level, auto, auto) {};
  f.max_wide_level = 30;
  f.wide_index = [](Level, const Row&, auto) {};
  f.wide_index_at = [](Level, const RationalPoint&) { return std::uint64_t{0}; };
  if (take_away != nullptr) take_away(f);
  return std::make_shared<IndexSubject>("probe", "has entry points", std::move(f));
}

SubjectPtr tree_probe(bool takes_points) {
  using namespace tree;
  Functions functions;
  functions.encode = [](const Map&) { return Code{}; };
  functions.decode = [](const Code&) { return Bytes{}; };
  functions.lookup = [](const Code&, auto, auto) {};
  if (takes_points) functions.point = [](const Code&, auto, auto, auto) {};
  functions.bytes = functions.decode;
  functions.open = [](Level, Format, auto) { return std::nullopt; };
  functions.tree_bits_read = [](const Code&, std::uint64_t) { return 0; };
  functions.writes_paper = functions.reads_paper = true;
  return std::make_shared<TreeSubject>("probe", "has entry points", std::move(functions));
}

struct Probes {
  const char* entry;
  SubjectPtr all, without;
};

Probes index_probes(const char* entry, index::Arithmetic arithmetic, void (*take_away)(index::Functions&)) {
  return {entry, index_probe(arithmetic), index_probe(arithmetic, take_away)};
}

/// A line for each entry point of the header that takes floats, and for the library's own.
std::vector<Probes> entries() {
  using index::Arithmetic;
  const auto index = [](index::Functions& f) { f.index = {}, f.index_at = {}; };
  const auto row_index = [](index::Functions& f) { f.row_index = {}; };
  const auto wide_index = [](index::Functions& f) { f.wide_index = {}; };
  return {index_probes("index_f32", Arithmetic::binary32, index),
          index_probes("index_f64", Arithmetic::binary64, index),
          index_probes("row_index_f32", Arithmetic::binary32, row_index),
          index_probes("the library's wide index", Arithmetic::binary32, wide_index),
          {"tree_lookup_f32", tree_probe(true), tree_probe(false)}};
}

bool fits(const Law& law, const Subject& subject) {
  for (Level n = law.tiers.long_run.first; n <= law.tiers.long_run.last; ++n)
    if (!law.unfit(subject, n)) return true;
  return false;
}

bool asks(const Law& law, const Probes& probes) {
  return fits(law, *probes.all) && !fits(law, *probes.without);
}

TEST(FloatLaws, EveryProofOverCellsBringsTheSampleOfItsEntryPointAlong) {
  for (const Probes& probes : entries()) {
    std::uint64_t proofs = 0;
    for (const Law& law : laws()) {
      if (!law.general || law.method != Method::exhaustive || law.topic != probes.all->topic() ||
          !asks(law, probes))
        continue;
      ++proofs;
      Request request;
      request.laws = {&law};
      request.subjects = {probes.all};
      bool on_floats = false;
      for (const Job& job : plan(request))
        on_floats =
            on_floats || (job.law->method == Method::sample && asks(*job.law, probes) && job.unfit.empty());
      EXPECT_TRUE(on_floats) << law.id << " asks " << probes.entry << " on cells alone";
    }
    EXPECT_GT(proofs, 0u) << probes.entry;
  }
}

// A lookup in samples of trees is also asked at points on the way down.
TEST(FloatLaws, TreesOfSamplesBringItAlong) {
  EXPECT_EQ(find_law("tree.on_samples")->companion, "tree.point_exact_on_floats");
}

TEST(FloatLaws, DoublesAreAskedOfThoseWhoTakeThem) {
  const auto ids = [](index::Arithmetic arithmetic) {
    Request request;
    request.laws = {find_law("index.nested")};
    request.subjects = {index_probe(arithmetic)};
    std::vector<std::string> all;
    for (const Job& job : plan(request)) all.push_back(job.law->id);
    return all;
  };
  using testing::ElementsAre;
  EXPECT_THAT(ids(index::Arithmetic::binary64),
              ElementsAre("index.nested", "index.exact_on_floats", "index.exact_on_doubles"));
  EXPECT_THAT(ids(index::Arithmetic::binary32), ElementsAre("index.nested", "index.exact_on_floats"));
  EXPECT_THAT(ids(index::Arithmetic::exact), ElementsAre("index.nested"));
}

/// The weakest verdict of a run of one law that cells prove.
Verdict overall(const char* law, const char* subject, Levels levels) {
  Request request;
  request.laws = {find_law(law)};
  request.subjects = {find_subject(subject)};
  request.levels = levels;
  RunOptions options;
  options.show_progress = false;
  options.mutants = false;
  return weakest(run_jobs(plan(request), options, [](const Result&) {}).results, subject);
}

TEST(FloatLaws, FigureFourInBinary32IsNotProved) {
  EXPECT_EQ(run_level(*find_law("index.row_order"), *find_subject("w-minor-f32"), 1, LawRun{}).verdict,
            Verdict::proved);
  EXPECT_EQ(overall("index.row_order", "w-minor-f32", {1, 1}), Verdict::refuted);
  EXPECT_EQ(overall("index.row_order", "w-minor-f64", {12, 12}), Verdict::refuted);
  EXPECT_EQ(overall("index.row_order", "impl", {1, 1}), Verdict::checked);
  EXPECT_EQ(overall("index.row_order", "w-minor", {1, 1}), Verdict::proved);
}

TEST(FloatLaws, ATreeThatIsAskedAtPointsIsNotProvedOnFloats) {
  EXPECT_EQ(overall("tree.point_is_index", "tree-ranked", {1, 1}), Verdict::checked);
  EXPECT_EQ(overall("tree.lookup_is_decode", "tree-ranked", {1, 1}), Verdict::proved);
}

// Exact arithmetic: (1/2 - 2^-25) + 2^-26 is below 1/2, row 0.  In binary32 the sum is 1/2.
TEST(FloatLaws, TheCaseThatShowedIt) {
  const points::RationalPoint p{points::rational(16777215.0f / 33554432.0f),
                                points::rational(1.0f / 67108864.0f)};
  EXPECT_EQ(index::built_in("w-minor")->functions.row_index_at(1, p), 0u);
  EXPECT_EQ(index::built_in("impl")->functions.row_index_at(1, p), 0u);
  EXPECT_EQ(index::built_in("w-minor-f32")->functions.row_index_at(1, p), 2u);
}

}  // namespace
