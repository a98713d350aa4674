// [release] Proofs by contract: the example's recursion keeps its contract, and each fault is refuted by one step.
#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "tests/source/made_codec.hpp"

namespace mmverify::codec_test {
namespace {

struct Fault {
  const char *name, *says, *was, *is, *file, *function;
  unsigned level;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

const std::vector<Fault> faults{
#define MMVERIFY_FAULT(name, says, was, is, file, function, level) \
  {#name, says, was, is, file, function, level},
#include "tests/source/contract_faults.def"
#undef MMVERIFY_FAULT
};

constexpr const char* example = "examples/subject_tree/subject_tree.c";
/// A prover that hangs ends here; the proofs take seconds on a quiet machine.
constexpr double seconds = 1200;

source::CodecAnswer answer_of(Made& made, const Fault& f, unsigned format) {
  return made.codec->prove({f.file, f.function, f.level, format, f.level}, {seconds, {}, {}, {}});
}

TEST(Contract, QuestionsAreOfTheHarness) {
  const auto laws = [](const std::string& symbol) {
    const Facts facts{[](dock::Call) { return true; }, MMVERIFY_TREE_STREAM, 12,
                      [=](const std::string& s) { return s == symbol; }};
    std::set<std::string> ids;
    for (const proofs::codecs::CodecLaw& law : proofs::codecs::laws()) {
      EXPECT_TRUE(questions_by_contract(law, facts, proofs::codecs::by_contract_from - 1, 2).empty())
          << law.id;
      for (const Question& q : questions_by_contract(law, facts, 5, 2)) {
        ids.insert(law.id);
        EXPECT_NE(proofs::codecs::texts().at(q.file).find("void " + q.function + "("), std::string::npos)
            << q.function;
      }
    }
    return ids;
  };
  EXPECT_EQ(laws("mmverify_contract_v1"),
            (std::set<std::string>{"tree.canonical", "tree.equals_spec", "tree.lookup_is_decode",
                                   "tree.malformed", "tree.round_trip"}));
  EXPECT_EQ(laws("_ZN8mmverify4impl4tree6detail10write_nodeERNS2_14SequenceWriterEjm"),
            (std::set<std::string>{"tree.equals_spec", "tree.lookup_is_decode", "tree.round_trip"}));
}

TEST(Contract, IsKeptByTheExample) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  Made made(source_text(example));
  ASSERT_TRUE(made.facts.defines("mmverify_contract_v1"));
  std::set<std::string> asked;
  for (const Fault& f : faults)
    for (const unsigned format : {1U, 2U}) {
      if (!asked.insert(f.function + std::to_string(10 * f.level + format)).second) continue;
      const source::CodecAnswer answer = answer_of(made, f, format);
      EXPECT_EQ(answer.kind, source::CodecAnswer::Kind::proved)
          << f.function << " level " << f.level << " format " << format << ": " << answer.text;
    }
}

class ContractFault : public testing::TestWithParam<Fault> {};

TEST_P(ContractFault, IsRefuted) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  const Fault& f = GetParam();
  std::string text = source_text(example);
  const std::size_t at = text.find(f.was);
  ASSERT_NE(at, std::string::npos) << f.says << ": the example has no " << f.was;
  text.replace(at, std::string(f.was).size(), f.is);
  Made made(text);
  const source::CodecAnswer answer = answer_of(made, f, 2);
  EXPECT_EQ(answer.kind, source::CodecAnswer::Kind::refuted) << f.says << ": " << answer.text;
}

INSTANTIATE_TEST_SUITE_P(Codec, ContractFault, testing::ValuesIn(faults),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mmverify::codec_test
