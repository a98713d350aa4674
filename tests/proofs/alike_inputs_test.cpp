// [release] Functions that are wrong only of inputs that are alike in part: records that share bytes, entries that
// repeat, maps of tiles, codes of small maps that zeros fill up; and zeros that keep their signs.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "proofs/array/law_parts.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/tree/mutants.hpp"
#include "proofs/vq/maps.hpp"

namespace alike_inputs_test {

using namespace mmverify::proofs;
using mmverify::spec::vq::Vq2;
using mmverify::spec::vq::Vq4;
using LawRun = Run;

Result judged(const char* law, const Mutant& m, Level level) {
  return run_level(*find_law(law), *m.subject, level, LawRun{});
}

std::uint64_t bytes_of(const array::Record& r) {
  using namespace mmverify::spec::micromap;
  return packed_bytes(micro_triangles(r.level), static_cast<Format>(r.format));
}

TEST(AlikeInputs, RecordsMayShareBytes) {
  const auto known_by_place = [](array::Functions& f) {
    f.compact = [real = f.compact](const array::Bundle& was) {
      array::Bundle b = was;
      std::map<std::pair<std::uint32_t, std::uint64_t>, array::Record> first;
      for (array::Record& r : b.array.records)
        r = first.try_emplace({r.offset, bytes_of(r)}, r).first->second;
      return real(b);
    };
  };
  EXPECT_EQ(judged("array.changes_on_samples", array::mutant("", "array", {0, 5}, known_by_place), 0).verdict,
            Verdict::refuted);
  const auto without_overlaps = [](array::Functions& f) {
    f.write = [real = f.write](const array::Bundle& was, std::uint32_t version) {
      array::Bundle b = was;
      b.array.data.clear();
      for (array::Record& r : b.array.records) {
        const auto from = was.array.data.begin() + static_cast<std::ptrdiff_t>(r.offset);
        r.offset = static_cast<std::uint32_t>(b.array.data.size());
        b.array.data.insert(b.array.data.end(), from, from + static_cast<std::ptrdiff_t>(bytes_of(r)));
      }
      return real(b.array.data.size() > was.array.data.size() ? b : was, version);
    };
  };
  EXPECT_EQ(judged("array.files_on_samples", array::mutant("", "array", {0, 5}, without_overlaps), 0).verdict,
            Verdict::refuted);
}

TEST(AlikeInputs, ACompactedArrayMayShareBytesToo) {
  const auto shares = [](array::Functions& f) {
    f.compact = [real = f.compact](const array::Bundle& was) {
      array::Bundle b = real(was);
      std::vector<std::uint8_t> data;
      std::map<std::vector<std::uint8_t>, std::uint32_t> known;
      for (array::Record& r : b.array.records) {
        const auto from = b.array.data.begin() + static_cast<std::ptrdiff_t>(r.offset);
        const std::vector<std::uint8_t> bytes(from, from + static_cast<std::ptrdiff_t>(bytes_of(r)));
        const auto [at, is_new] = known.try_emplace(bytes, static_cast<std::uint32_t>(data.size()));
        if (is_new) data.insert(data.end(), bytes.begin(), bytes.end());
        r.offset = at->second;
      }
      b.array.data = data;
      return b;
    };
  };
  const Mutant right = array::mutant("", "array", {0, 5}, shares);
  EXPECT_EQ(judged("array.compact", right, 1).verdict, Verdict::proved);
  EXPECT_EQ(judged("array.changes_on_samples", right, 2).verdict, Verdict::checked);
}

/// A decoder that leaves the transforms out where all of these entries are equal.
template <class Format, class Entries>
Mutant turns_no_equal_entries(Entries entries) {
  return vq::mutant("", "vq", {vq::level_of<Format>, vq::level_of<Format>}, [=](vq::Functions& f) {
    f.codec<Format>().regions = {};
    f.codec<Format>().decode = [=](const vq::BlockBytes<Format>& block) {
      Format fields = mmverify::spec::vq::from_bytes<Format>(block);
      const std::vector<std::uint32_t> all = entries(fields);
      if (std::all_of(all.begin(), all.end(), [&](std::uint32_t e) { return e == all.front(); }))
        fields.transforms = {};
      return mmverify::spec::vq::decode(fields);
    };
  });
}

TEST(AlikeInputs, EntriesOfABlockMayBeEqual) {
  const Mutant two = turns_no_equal_entries<Vq2>([](const Vq2& f) {
    std::vector<std::uint32_t> all(f.shared.begin(), f.shared.end());
    for (const auto& pair : f.own) all.insert(all.end(), pair.begin(), pair.end());
    return all;
  });
  EXPECT_EQ(judged("vq2.on_random_blocks", two, 4).verdict, Verdict::refuted);
  const Mutant four = turns_no_equal_entries<Vq4>(
      [](const Vq4& f) { return std::vector<std::uint32_t>(f.codebook.begin() + 5, f.codebook.end()); });
  EXPECT_EQ(judged("vq4.on_random_blocks", four, 5).verdict, Verdict::refuted);
}

template <class Format>
void expect_tiles(std::uint64_t k) {
  const vq::Map<Format> map = vq::sample_map<Format>(1, k);
  for (std::uint32_t vector = 0; vector < 64; ++vector)
    EXPECT_EQ(vq::vector_of<Format>(map, vector), vq::vector_of<Format>(map, (vector % 8 + vector / 8) % 2))
        << k << ' ' << vector;
}

TEST(AlikeInputs, MapsMayBeTiled) {
  for (const std::uint64_t k : {11u, 28u, 43u, 60u}) {
    expect_tiles<Vq2>(k);
    expect_tiles<Vq4>(k);
  }
}

TEST(AlikeInputs, CodesOfSmallMapsMayBeFilledUp) {
  const auto fills_to_eight =
      tree::opens_wrongly([](const tree::Functions& real, Level n, tree::Format f,
                             std::span<const std::uint8_t> bytes, std::optional<tree::Code> code) {
        for (std::size_t size = 1; n < 2 && !code && bytes.size() == 8 && size < 8; ++size)
          if (std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(size), bytes.end(),
                          [](std::uint8_t byte) { return byte == 0; }))
            code = real.open(n, f, bytes.first(size));
        return code;
      });
  const Mutant wrong = tree::mutant("", "tree-stream", {0, 1}, fills_to_eight);
  EXPECT_EQ(judged("tree.malformed_on_samples", wrong, 0).verdict, Verdict::refuted);
  EXPECT_EQ(judged("tree.malformed_on_samples", wrong, 1).verdict, Verdict::refuted);
}

TEST(AlikeInputs, ANegativeZeroIsReplayedAsOne) {
  const Mutant wrong =
      index::mutant("", "impl", {4, 4}, index::on_floats([](Level, float u, float, std::uint32_t answer) {
                      return u == 0 && std::signbit(u) ? answer ^ 1 : answer;
                    }));
  const Result r = judged("index.exact_on_floats", wrong, 4);
  ASSERT_EQ(r.verdict, Verdict::refuted);
  EXPECT_NE(r.counterexamples.front().at.find("u=-0"), std::string::npos) << r.counterexamples.front().at;
  EXPECT_EQ(r.counterexamples.front().hex.find("(-0x0p+0"), 0u) << r.counterexamples.front().hex;
  EXPECT_FALSE(
      find_law("index.exact_on_floats")->replay(*wrong.subject, 4, r.counterexamples.front().at).holds);
}

}  // namespace alike_inputs_test
