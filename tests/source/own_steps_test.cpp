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

/// Puts a file of impl/tree into the folder, with another text in one place.
void change(const tests::Folder& folder, const std::string& name, const std::string& was,
            const std::string& is) {
  const std::string file = "impl/tree/" + name;
  std::string text = source_text(file);
  const std::size_t at = text.find(was);
  ASSERT_NE(at, std::string::npos) << file << " has no " << was;
  text.replace(at, was.size(), is);
  std::filesystem::create_directories(folder / "impl/tree");
  std::ofstream(folder / file) << text;
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

// A field that no step knows may keep what no step sees.
TEST(OwnSteps, RefuseAClassWithAnotherField) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  for (const auto& [file, was] :
       {std::pair("bits.hpp", "  std::uint32_t used_;\n"), std::pair("bits.hpp", "  std::uint64_t place_;\n"),
        std::pair("pyramid.hpp", "  std::uint32_t b_;\n"),
        std::pair("recursion.hpp", "  std::optional<Fault> fault;\n"),
        std::pair("recursion.hpp", "  BitWriter tree, data;\n")}) {
    const tests::Folder changed;
    change(changed, file, was, std::string(was) + "\n  std::uint32_t more = 0;\n");
    source::Codec codec = codec_with(changed);
    EXPECT_THROW(answer_of(codec, faults.front()), source::BadSource) << file << ": " << was;
  }
}

class OwnFault : public testing::TestWithParam<Fault> {};

TEST_P(OwnFault, IsRefuted) {
  if (no_prover()) GTEST_SKIP() << "this build has no mmverify-codec";
  const Fault& f = GetParam();
  const tests::Folder changed;
  change(changed, f.file, f.was, f.is);
  source::Codec codec = codec_with(changed);
  const source::CodecAnswer answer = answer_of(codec, f);
  EXPECT_EQ(answer.kind, source::CodecAnswer::Kind::refuted) << f.says << ": " << answer.text;
}

INSTANTIATE_TEST_SUITE_P(Codec, OwnFault, testing::ValuesIn(faults),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mmverify::codec_test
