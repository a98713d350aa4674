// [night] Our own tree codec by contract: each step holds, and each fault of one place is refuted by one step.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <set>

#include "tests/source/made_codec.hpp"

namespace mmverify::codec_test {
namespace {

struct Fault {
  const char *name, *says, *file, *was, *is, *function;
  unsigned format, size;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

const std::vector<Fault> faults{
#define MMVERIFY_FAULT(name, says, file, was, is, function, format, size) \
  {#name, says, file, was, is, function, format, size},
#include "tests/source/own_step_faults.def"
#undef MMVERIFY_FAULT
};

constexpr unsigned level = 3;
constexpr double seconds = 300;

source::CodecAnswer answer_of(source::Codec& codec, const Fault& f) {
  return codec.prove({"impl_tree.cc", f.function, level, f.format, f.size}, {seconds, {}, {}, {}});
}

/// Our own codec, with the files of a folder in place of its own.
source::Codec codec_with(const tests::Folder& folder) {
  return {MMVERIFY_ROOT "/tests/subjects/codecs/impl_stream.cpp",
          {"-I" + folder.path().string(), "-I" MMVERIFY_ROOT},
          proofs::codecs::texts()};
}

TEST(OwnSteps, Hold) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  const tests::Folder none;
  source::Codec codec = codec_with(none);
  std::set<std::string> asked;
  for (Fault f : faults)
    for (f.format = 1; f.format <= 2; ++f.format) {
      if (!asked.insert(f.function + std::to_string(10 * f.size + f.format)).second) continue;
      const source::CodecAnswer answer = answer_of(codec, f);
      EXPECT_EQ(answer.kind, source::CodecAnswer::Kind::proved)
          << f.function << " size " << f.size << " format " << f.format << ": " << answer.text;
    }
}

class OwnFault : public testing::TestWithParam<Fault> {};

TEST_P(OwnFault, IsRefuted) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  const Fault& f = GetParam();
  const std::string file = std::string("impl/tree/") + f.file;
  std::string text = source_text(file);
  const std::size_t at = text.find(f.was);
  ASSERT_NE(at, std::string::npos) << f.says << ": " << file << " has no " << f.was;
  text.replace(at, std::string(f.was).size(), f.is);
  const tests::Folder changed;
  std::filesystem::create_directories(changed / "impl/tree");
  std::ofstream(changed / file) << text;
  source::Codec codec = codec_with(changed);
  const source::CodecAnswer answer = answer_of(codec, f);
  EXPECT_EQ(answer.kind, source::CodecAnswer::Kind::refuted) << f.says << ": " << answer.text;
}

INSTANTIATE_TEST_SUITE_P(Codec, OwnFault, testing::ValuesIn(faults),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mmverify::codec_test
