// Random functions that are GLSL and C at once: what the reader makes of the shader's SPIR-V and what clang makes of the C
// give the same bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "subjects/program/folder.hpp"
#include "subjects/program/program.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/source/compile.hpp"
#include "tests/folder.hpp"
#include "tests/source/opened.hpp"
#include "tests/source/random_shader.hpp"

namespace mmverify {
namespace {

using source::Compiled;
using tests::Opened;

constexpr unsigned shader_functions = 16, pairs = 400;

class Beside {
 public:
  explicit Beside(std::uint64_t seed) : seed_(seed) {
    const tests::RandomShader text(seed, shader_functions);
    std::ofstream(shader()) << text.glsl();
    std::ofstream(c()) << text.c();
    spirv_ = shaders::compile_function(shader(), "all", kept_);
  }
  /// Runs a pass of spirv-opt that makes an unset variable OpUndef.
  void optimize() {
    const std::string to = kept_.file("optimized.spv");
    const program::ProgramEnd end = program::run_program({"spirv-opt", "--ssa-rewrite", spirv_, "-o", to});
    ASSERT_TRUE(end.succeeded) << end.errors;
    spirv_ = to;
  }
  void compiled() const { Compiled(shader(), "all", {}, spirv_); }
  /// The first pair on which the two give other bits; empty: there is none.
  std::string difference(const std::string& fault = {}) const {
    const Compiled of_shader(shader(), "all", {}, spirv_, fault), of_c(c(), "all");
    const Opened a(of_shader), b(of_c);
    for (unsigned k = 0; k < shader_functions; ++k)
      for (unsigned pair = 0; pair < pairs; ++pair) {
        proofs::Random random(seed_, k + 1, pair);
        const float u = tests::some_float(random), v = tests::some_float(random);
        if (a(k, u, v) != b(k, u, v))
          return fmt::format("seed {} f{}({:a}, {:a}): {} by SPIR-V, {} by C", seed_, k, u, v, a(k, u, v),
                             b(k, u, v));
      }
    return {};
  }

 private:
  std::string shader() const { return (folder_ / "random.glsl").string(); }
  std::string c() const { return (folder_ / "random.c").string(); }

  std::uint64_t seed_;
  tests::Folder folder_;
  program::Folder kept_{"source"};
  std::string spirv_;
};

class Spirv : public testing::Test {
 protected:
  void SetUp() override {
    try {
      Beside(1).compiled();
    } catch (const source::NotAvailable& why) {
      GTEST_SKIP() << why.what();
    } catch (const shaders::NotAvailable& why) {
      GTEST_SKIP() << why.what();
    }
  }
};

// MMVERIFY_FUZZ_SEEDS=N runs so many seeds in the place of two.
TEST_F(Spirv, GivesTheBitsThatTheSameFunctionsInCGive) {
  const char* seeds = std::getenv("MMVERIFY_FUZZ_SEEDS");
  const unsigned long last = seeds != nullptr ? std::stoul(seeds) : 2;
  for (unsigned long seed = 1; seed <= last; ++seed) EXPECT_EQ(Beside(seed).difference(), "");
}

TEST_F(Spirv, GivesTheSameBitsWithOpUndef) {
  Beside one(1);
  try {
    one.optimize();
  } catch (const program::NoProgram&) {
    GTEST_SKIP() << "no spirv-opt (Debian: spirv-tools)";
  }
  EXPECT_EQ(one.difference(), "");
}

TEST_F(Spirv, MistakesOfTheReaderAreCaught) {
  for (const char* fault : {"shuffled-otherwise", "signed-numbers", "lowest-for-highest",
                            "clamped-above-alone", "table-of-one"}) {
    std::string found;
    for (std::uint64_t seed = 1; found.empty() && seed <= 4; ++seed) found = Beside(seed).difference(fault);
    EXPECT_NE(found, "") << fault;
    fmt::print("{}: {}\n", fault, found);
  }
}

}  // namespace
}  // namespace mmverify
