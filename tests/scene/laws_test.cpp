// [release] The laws on a scene's own data: they hold of ours, and each refutes what is planted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "proofs/scene/bake_sample.hpp"
#include "proofs/scene/claimed.hpp"
#include "tests/scene/made_scene.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::tests;
using mmverify::scene::BakedTriangle;
using proofs::Level;

/// All laws, or the one of that id.
proofs::Report judged(const proofs::scene::Data& data, std::optional<std::uint64_t> samples = 400,
                      const std::string& id = {}) {
  proofs::scene::SceneLaws laws = proofs::scene::scene_laws(data, {samples}, "mmverify scene made.gltf");
  std::erase_if(laws.jobs, [&](const proofs::Job& job) { return !id.empty() && job.law->id != id; });
  proofs::RunOptions run;
  run.show_progress = false;
  run.mutants = false;
  return proofs::run_jobs(laws.jobs, run, [](const proofs::Result&) {});
}

std::map<std::string, proofs::Verdict> verdicts(const proofs::Report& report) {
  std::map<std::string, proofs::Verdict> weakest;
  for (const proofs::Result& r : report.results) {
    const auto [at, is_new] = weakest.try_emplace(r.law, r.verdict);
    if (r.verdict == proofs::Verdict::refuted || is_new) at->second = r.verdict;
  }
  return weakest;
}

TEST(SceneLaws, HoldOfOurOwnMaps) {
  using enum proofs::Verdict;
  const Made made;
  for (const auto& [law, verdict] : verdicts(judged(made.data(), 40)))
    EXPECT_EQ(verdict, law == "vq.square_map" || law.starts_with("bake.") ? checked : proved) << law;
  for (const auto& [law, verdict] : verdicts(judged(made.data(), std::nullopt)))
    EXPECT_EQ(verdict, law == "vq.square_map" ? checked : proved) << law;
}

TEST(SceneLaws, ClaimedMicroTrianglesAreNumberedInOrder) {
  using proofs::scene::Claim;
  const Made made;
  for (const Claim::About about : {Claim::known, Claim::unknown, Claim::forced})
    for (Level n = 0; n <= 7; ++n) {
      const Claim claim{"", "", about, ""};
      const proofs::scene::Claimed claimed(claim, made.b, n);
      std::uint64_t number = 0;
      for (std::size_t t = 0; t < made.b.triangles.size(); ++t)
        for (std::uint32_t k = 0; made.b.triangles[t].level == n && k < 1u << 2 * n; ++k) {
          if (!claim.about(proofs::scene::state_code(made.b.triangles[t], k))) continue;
          ASSERT_LT(number, claimed.size());
          const auto at = claimed.at(number++);
          ASSERT_EQ(std::pair(at.triangle, at.index), std::pair(t, k)) << "level " << n;
        }
      EXPECT_EQ(number, claimed.size());
    }
}

TEST(SceneLaws, ABudgetBoundsWhatIsLookedAt) {
  const Made made;
  const proofs::scene::Claim claim{"", "", proofs::scene::Claim::known, ""};
  std::uint64_t all = 0;
  for (const auto& level : looked_at(claim, made.data(), {})) {
    EXPECT_TRUE(level.whole());
    all += level.all;
  }
  const auto sum = [&](std::uint64_t work, std::uint64_t whole) {
    std::uint64_t at = 0;
    for (const auto& level : looked_at(claim, made.data(), {.size = {}, .work = work, .whole = whole}))
      at += level.at;
    return at;
  };
  EXPECT_EQ(sum(1'000'000'000, 0), all);
  EXPECT_EQ(sum(1, 1'000'000'000), all);
  EXPECT_LT(sum(1, 0), sum(20'000, 0));
  EXPECT_LE(sum(1, 0), 13u * 64);
}

/// States are 0 T, 1 O, 2 UT, 3 UO, as codes.  The last micro-triangle of a baked map that has one state gets
/// another, and is counted so.
void change_last(Made& made, std::size_t triangle, unsigned from, unsigned to) {
  BakedTriangle& t = made.b.triangles[triangle];
  const unsigned b = impl::micromap::bits(t.format);
  std::uint32_t at = (1u << 2 * t.level) - 1;
  while (code(t.map, at, b) != from) --at;
  impl::micromap::Bytes map(t.map.begin(), t.map.end());
  map[at * b / 8] = static_cast<std::uint8_t>(map[at * b / 8] ^ (from ^ to) << (at * b % 8));
  t.map = std::move(map);
  --t.states[from], ++t.states[to];
}

/// The triangle that is O throughout, as another state.
void change_uniform(Made& made, unsigned to) {
  BakedTriangle& t = made.b.triangles[2];
  t.uniform = static_cast<impl::micromap::State>(to);
  std::swap(t.states[1], t.states[to]);
}

/// The first triangle once more at the end: a second use of one map.
mmverify::scene::Scene with_a_second_use() {
  mmverify::scene::Scene s = made_scene();
  s.primitives[0].triangles.push_back({0, 1, 2});
  return s;
}

/// The maps that a codec is given, with one bit of those of level 5 changed.
proofs::scene::Codecs::Map spoiled(Level n, proofs::scene::Codecs::Map map, impl::micromap::Bytes& copy) {
  copy.assign(map.begin(), map.end());
  if (n == 5) copy.back() ^= 1;
  return copy;
}

using Plant = std::function<void(Made&)>;
struct Planted {
  const char *law, *what;
  Plant plant;
  std::optional<unsigned> level = {};
  bool two_state = false, second_use = false;
};

using VqState = impl::vq::State;

const std::vector<Planted> planted{
    {"bake.conservative", "an unknown is O", [](Made& m) { change_last(m, 0, 3, 1); }},
    {"bake.conservative", "an unknown is T", [](Made& m) { change_last(m, 1, 2, 0); }},
    {"bake.conservative", "a T is O", [](Made& m) { change_last(m, 1, 0, 1); }},
    {"bake.tight", "a T is UT", [](Made& m) { change_last(m, 1, 0, 2); }},
    {"bake.tight", "an O is UO", [](Made& m) { change_last(m, 0, 1, 3); }},
    {"bake.tight", "a uniform O is UO", [](Made& m) { change_uniform(m, 3); }},
    {"bake.force2", "a T is O", [](Made& m) { change_last(m, 0, 0, 1); }, 4, true},
    {"bake.force2", "an O is T", [](Made& m) { change_last(m, 1, 1, 0); }, 4, true},
    {"bake.force2", "a uniform O is T", [](Made& m) { change_uniform(m, 0); }, 4, true},
    {"micromap.valid", "a geometry count is off",
     [](Made& m) { m.a.primitives[0].geometry.counts[0].count += 1; }},
    {"micromap.valid", "a code is beyond the records",
     [](Made& m) { m.a.primitives[0].geometry.indices[0] = 200; }},
    {"micromap.valid", "a record is beyond the data",
     [](Made& m) { m.a.array.records[3].offset += 1 << 20; }},
    {"micromap.indirection", "two triangles have each other's codes",
     [](Made& m) {
       std::swap(m.a.primitives[0].geometry.indices[0], m.a.primitives[0].geometry.indices[2]);
     }},
    {"micromap.indirection", "a code is beyond the records",
     [](Made& m) { m.a.primitives[0].geometry.indices[0] = 200; }},
    {"micromap.indirection", "a record is beyond the data",
     [](Made& m) { m.a.array.records[3].offset += 1 << 20; }},
    {"micromap.indirection", "one state of 16,384 is another in the array",
     [](Made& m) { m.a.array.data[m.a.array.records[1].offset + 1234] ^= 4; }, 7},
    {"micromap.indirection",
     "the second use of a map has another's code",
     [](Made& m) { m.a.primitives[0].geometry.indices[10] ^= 1; },
     {},
     false,
     true},
    {"micromap.indirection", "one state too many is counted",
     [](Made& m) { ++m.b.triangles[0].states[2], --m.b.triangles[0].states[3]; }},
    {"tree.round_trip", "the sequences are another map's",
     [](Made& m) {
       m.codecs.stream = [real = m.codecs.stream](Level n, auto f, auto map) {
         impl::micromap::Bytes copy;
         return real(n, f, spoiled(n, map, copy));
       };
     }},
    {"tree.round_trip", "the form for random access is another map's",
     [](Made& m) {
       m.codecs.tree = [real = m.codecs.tree](Level n, auto f, auto map) {
         impl::micromap::Bytes copy;
         return real(n, f, spoiled(n, map, copy));
       };
     }},
    {"tree.round_trip", "a bit of the values is flipped",
     [](Made& m) {
       m.codecs.stream = [real = m.codecs.stream](Level n, auto f, auto map) {
         impl::tree::Stream stream = real(n, f, map);
         stream.data[0] ^= 1;
         return stream;
       };
     }},
    {"vq2.conservative", "a substitution is not counted",
     [](Made& m) {
       m.codecs.vq2 = [real = m.codecs.vq2](const auto& map) {
         auto encoded = real(map);
         ++encoded.substitutions;
         return encoded;
       };
     }},
    {"vq2.conservative", "the block is that of all O",
     [](Made& m) {
       m.codecs.vq2 = [real = m.codecs.vq2](auto map) {
         map.fill(VqState::O);
         return real(map);
       };
     }},
    {"vq2.conservative", "one C is O",
     [](Made& m) {
       m.codecs.vq2 = [real = m.codecs.vq2](auto map) {
         *std::find(map.rbegin(), map.rend(), VqState::C) = VqState::O;
         return real(map);
       };
     }},
    {"vq4.conservative", "a substitution is not counted",
     [](Made& m) {
       m.codecs.vq4 = [real = m.codecs.vq4](const auto& map) {
         auto encoded = real(map);
         ++encoded.substitutions;
         return encoded;
       };
     }},
    {"vq4.conservative", "the block is that of all T",
     [](Made& m) {
       m.codecs.vq4 = [real = m.codecs.vq4](auto map) {
         map.fill(VqState::T);
         return real(map);
       };
     }},
    {"vq4.conservative", "one C is T",
     [](Made& m) {
       m.codecs.vq4 = [real = m.codecs.vq4](auto map) {
         *std::find(map.begin(), map.end(), VqState::C) = VqState::T;
         return real(map);
       };
     }},
    {"vq.square_map", "all is O",
     [](Made& m) {
       for (auto& map : m.m.vq2) map.fill(VqState::O);
     }},
    {"vq.square_map", "all is C",
     [](Made& m) {
       for (auto& map : m.m.vq4) map.fill(VqState::C);
     }},
    {"vq.square_map", "the rows run downwards", [](Made& m) {
       for (auto& map : m.m.vq4)
         for (std::size_t y = 0; y < 16; ++y)
           std::swap_ranges(map.begin() + static_cast<std::ptrdiff_t>(32 * y),
                            map.begin() + static_cast<std::ptrdiff_t>(32 * y + 32),
                            map.begin() + static_cast<std::ptrdiff_t>(32 * (31 - y)));
     }}};

TEST(SceneLaws, RefuteWhatIsPlanted) {
  for (const Planted& one : planted) {
    Made made(one.level, {0, one.two_state, 0, {}}, one.second_use ? with_a_second_use() : made_scene());
    EXPECT_NE(verdicts(judged(made.data(), std::nullopt, one.law))[one.law], proofs::Verdict::refuted)
        << one.what;
    one.plant(made);
    const proofs::Report report = judged(made.data(), std::nullopt, one.law);
    EXPECT_EQ(verdicts(report)[one.law], proofs::Verdict::refuted) << one.law << ": " << one.what;
    for (const proofs::Result& r : report.results)
      if (r.verdict == proofs::Verdict::refuted) {
        EXPECT_EQ(r.replayed_by, "mmverify scene made.gltf --replay " + std::string(one.law));
        EXPECT_FALSE(r.counterexamples.empty());
      }
  }
}

TEST(SceneLaws, EachHasThreePlants) {
  std::map<std::string, std::set<std::string>> plants;
  for (const Planted& one : planted) plants[one.law].insert(one.what);
  for (const bool two_state : {false, true})
    for (const auto& [law, verdict] : verdicts(judged(Made(4, {0, two_state, 0, {}}).data())))
      EXPECT_GE(plants[law].size(), 3u) << law;
}

TEST(SceneLaws, AnotherSurfaceIsAnotherRun) {
  const auto fingerprint = [](const Made& of) {
    return proofs::scene::SceneSubject(of.data(), "bake").fingerprint();
  };
  const Made made;
  EXPECT_EQ(fingerprint(made), fingerprint(Made()));
  Made other;
  other.p.surfaces[0].cutoff = 0.25f;
  EXPECT_NE(fingerprint(other), fingerprint(made));
}

TEST(SceneLaws, JudgeTwoStatesAsSuch) {
  const Made made(4, {0, true, 0, {}});
  auto found = verdicts(judged(made.data(), std::nullopt));
  EXPECT_EQ(found["bake.force2"], proofs::Verdict::proved);
  EXPECT_FALSE(found.contains("bake.tight"));
}

TEST(SceneLaws, NameTheSameCasesAgain) {
  const Made made;
  const proofs::scene::Data data = made.data();
  const proofs::scene::SceneLaws laws = proofs::scene::scene_laws(data, {50}, "");
  for (const proofs::Job& job : laws.jobs)
    if (job.law->id == "bake.tight" && job.levels.first == 5) {
      EXPECT_TRUE(job.law->replay(*job.subject, 5, "t0:i17").holds);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t0:i1024"), proofs::BadCase);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t0:i17x"), proofs::BadCase);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t2:i0"), proofs::BadCase);
    }
}

}  // namespace
