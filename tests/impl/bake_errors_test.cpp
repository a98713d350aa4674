// [sanitized, memory] What a baker refuses, and that it names what is wrong.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/impl/bake_jobs.hpp"

namespace impl_bake_errors_test {

using namespace mmverify::tests;

template <class Make>
std::string error_of(Make make) {
  try {
    make();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

TEST(ImplBakeErrors, NameWhatIsWrong) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity();
  const Job<float> fine{{{2, 2, {0, 1, 0, 1}}}, Mask{0.5f}, {}, {{{0, 0}, {1, 0}, {0, 1}}}, 1};
  const auto error = [&](auto change) {
    Job<float> job = fine;
    change(job);
    return error_of([&] { baker(job); });
  };
  EXPECT_EQ(error([](auto&) {}), "none");
  EXPECT_EQ(error([](auto& job) { job.mips.clear(); }), "bake: no mip level");
  for (const float bad : {nan, infinite, -infinite}) {
    EXPECT_EQ(error([&](auto& job) { job.mips[0].texels[2] = bad; }), "bake: texel (0, 1) is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.border = bad; }), "bake: a border that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.factors[1] = bad; }), "bake: a factor that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.margin = bad; }), "bake: a margin that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.mode = Mask{bad}; }), "bake: a cutoff that is not finite");
  }
  EXPECT_EQ(error([](auto& job) { job.sampling.factors[0] = -1; }), "bake: a factor below 0");
  EXPECT_EQ(error([](auto& job) { job.sampling.margin = -1; }), "bake: a margin below 0");
  EXPECT_EQ(error([](auto& job) { job.sampling.margin = 0x1p20f; }), "bake: a margin of 2^20 texels or more");
  EXPECT_EQ(error([](auto& job) { job.mode = Cutoff{1, 0}; }), "bake: a cutoff over 0");
  const std::vector<std::uint8_t> bytes(4);
  const auto of_bytes = [&](const AlphaView& view, float border) {
    const Texels mip = view;
    return error_of([&] {
      TriangleBaker({&mip, 1}, Mask{}, {Wrap::repeat, Wrap::repeat, Filter::bilinear, border});
    });
  };
  EXPECT_EQ(of_bytes({bytes.data(), 2, 2, 2}, 255), "none");
  for (const float border : {-1.0f, 256.0f, 0.5f})
    EXPECT_EQ(of_bytes({bytes.data(), 2, 2, 2}, border), "bake: a border that is no such texel");
  EXPECT_EQ(of_bytes({nullptr, 2, 2, 2}, 0), "bake: a texture without texels");
  EXPECT_EQ(of_bytes({bytes.data(), 2, 2, ~std::size_t{0} / 2}, 0),
            "bake: a texture larger than memory can be");
  for (const auto& [width, height] : {std::pair{0u, 2u}, {2u, 0u}, {16385u, 1u}, {1u, 0xffffffffu}})
    EXPECT_EQ(of_bytes({bytes.data(), width, height, 2}, 0),
              "bake: a texture has 1 to 16384 texels along each side");
}

}  // namespace impl_bake_errors_test
