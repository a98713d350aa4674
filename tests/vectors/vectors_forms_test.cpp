// [release] The forms of vectors, and what a builder refuses.
#include <nlohmann/json.hpp>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/forms/forms.hpp"
#include "subjects/shaders/compile/sha256.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_forms_test {

using namespace mmverify;
using namespace mmverify::vectors;

const Provenance made_by{"1.2.3", std::string(64, 'a'), shaders::sha256};

Family small() {
  Builder out("small", 7, "a family of one of each kind");
  out.table("all", "one of each",
            {{"about", Kind::about, "a"},
             {"n", Kind::number, "a"},
             {"o", Kind::optional, "a"},
             {"e", Kind::optional, "a"},
             {"f", Kind::binary32, "a"},
             {"m", Kind::name, "a", {"no", "yes"}},
             {"w", Kind::wide, "a"},
             {"s", Kind::set, "a", {"p", "q", "r"}},
             {"b", Kind::bytes, "a"},
             {"d", Kind::digits, "a"},
             {"l", Kind::words, "a"},
             {"g", Kind::binary32s, "a"}});
  out.add({"first", 1u, none, Optional(0xffffffffu), 0x3f800000u, 1u, std::uint64_t{1} << 40,
           std::uint64_t{5}, Bytes{1, 255}, Bytes{0, 3, 2}, std::vector{7u, 8u}, std::vector{0x40000000u}});
  return out.take();
}

TEST(VectorsForms, JsonHasEachKind) {
  const auto json = nlohmann::json::parse(as_json(small(), made_by));
  EXPECT_EQ(json["tables"][0]["vectors"],
            nlohmann::json::parse(R"([{"id": 0, "about": "first", "n": 1, "o": null, "e": 4294967295,
      "f": "3f800000", "m": "yes", "w": 1099511627776, "s": ["p", "r"], "b": "01ff", "d": "032", "l": [7, 8],
      "g": ["40000000"]}])"));
  EXPECT_EQ(json["sha256"], shaders::sha256(payload(small())));
  EXPECT_EQ(json["tool"]["spec_hash"], std::string(64, 'a'));
}

TEST(VectorsForms, BinaryIsWhatItsTableOfContentsSays) {
  const Family one[] = {small()};
  const std::string binary = as_binary(one, made_by);
  const auto word = [&](std::size_t at) {
    std::uint32_t w = 0;
    for (std::size_t k = 0; k < 4; ++k)
      w |= std::uint32_t{static_cast<std::uint8_t>(binary.at(at + k))} << 8 * k;
    return w;
  };
  EXPECT_EQ(binary.substr(0, 8), "MMVECTOR");
  EXPECT_EQ(word(8), 2u);
  EXPECT_EQ(word(12), 3u);  // the table, its data, its texts
  EXPECT_EQ(word(20), binary.size());
  std::string parts;
  for (std::size_t entry = 0; entry < 3; ++entry) {
    const std::size_t at = word(16) + 64 * entry;
    EXPECT_EQ(word(at + 32), 7u);
    EXPECT_EQ(word(at + 44) % 256, 0u);
    parts += binary.substr(word(at + 44), word(at + 36) * word(at + 40));
  }
  EXPECT_EQ(parts, payload(small()));
  EXPECT_EQ(word(word(16) + 36), 4u * (4 + 2 * 8));
  Family other = small();
  other.tables[0].words[1] ^= 1;
  EXPECT_NE(digest(other, made_by), digest(small(), made_by));
}

TEST(VectorsForms, BuilderRefusesWhatIsNoValueOfTheColumn) {
  Builder out("small", 1, "a");
  out.table("t", "a", {{"about", Kind::about, "a"}, {"m", Kind::name, "a", {"no", "yes"}}});
  EXPECT_THROW(out.add({"why"}), std::logic_error);
  EXPECT_THROW(out.add({"why", 2u}), std::logic_error);
  EXPECT_THROW(out.add({"why", Bytes{}}), std::logic_error);
  EXPECT_THROW(out.add({"", 1u}), std::logic_error);
  EXPECT_THROW(out.add({std::string(64, 'x'), 1u}), std::logic_error);
  EXPECT_NO_THROW(out.add({std::string(63, 'x'), 1u}));
}

// Against the compiler's own conversions of doubles.
TEST(VectorsForms, RoundsToBinary32AsProcessorsDo) {
  for (const double x : {0.0, 1.0, 1.0 / 3, 0.1, 3e-39, 1e-45, 0.7e-45, 1 - std::ldexp(1, -25),
                         1 + std::ldexp(1, -24), 5e-40}) {
    int e = 0;
    const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    const Rational q = spec::scaled(m, e - 53);
    EXPECT_EQ(nearest(q), bits_of(static_cast<float>(x))) << x;
    const float down = std::bit_cast<float>(rounded_down(q));
    EXPECT_LE(down, x);
    EXPECT_GT(std::nextafter(down, 1e9f), x);
  }
}

// Each family keeps its description: names that C takes, records that fit their columns, the same each time.
TEST(VectorsForms, EveryFamilyIsMadeTheSameAgain) {
  for (const FamilyRow& row : families()) {
    const Family& family = tests::family(row.name);
    EXPECT_EQ(family.name, row.name);
    EXPECT_EQ(payload(row.make()), payload(family)) << row.name;
    EXPECT_EQ(family.data.size() % 4, 0u);
    for (const Table& table : family.tables) {
      EXPECT_GT(table.records(), 0u) << table.name;
      EXPECT_EQ(table.words.size() % table.stride(), 0u);
      EXPECT_EQ(table.columns[0].kind, Kind::about);
      for (std::size_t k = 0; k < table.records(); ++k)
        for_each_value(table, k, [&](const Column& column, std::span<const std::uint32_t> words) {
          if (in_data(column.kind)) {
            EXPECT_LE(std::size_t{words[0]} + words[1], family.data.size());
            EXPECT_EQ(words[0] % 4, 0u);
          }
        });
    }
  }
}

}  // namespace vectors_forms_test
