// [sanitized, memory] A baker refuses bad input and names the fault.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "tests/complaint.hpp"

namespace impl_bake_errors_test {

using namespace mmverify::impl::bake;

template <class Make>
std::string error_of(Make make) {
  return mmverify::tests::complaint_of<std::invalid_argument>([&] { make(); });
}

/// The inputs of a baker of one texture of four floats.
struct Parts {
  std::vector<float> texels{0, 1, 0, 1};
  std::size_t mips = 1;
  AlphaMode mode = Mask{0.5f};
  Sampling sampling;
};

TEST(ImplBakeErrors, NameWhatIsWrong) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity();
  const auto error = [&](auto change) {
    Parts parts;
    change(parts);
    const Texels mip = TexelView<float>{parts.texels.data(), 2, 2, 2};
    return error_of([&] { TriangleBaker({&mip, parts.mips}, parts.mode, parts.sampling); });
  };
  EXPECT_EQ(error([](auto&) {}), "none");
  EXPECT_EQ(error([](auto& parts) { parts.mips = 0; }), "bake: no mip level");
  for (const float bad : {nan, infinite, -infinite}) {
    EXPECT_EQ(error([&](auto& parts) { parts.texels[2] = bad; }), "bake: texel (0, 1) is not finite");
    EXPECT_EQ(error([&](auto& parts) { parts.sampling.border = bad; }), "bake: a border that is not finite");
    EXPECT_EQ(error([&](auto& parts) { parts.sampling.factors[1] = bad; }),
              "bake: a factor that is not finite");
    EXPECT_EQ(error([&](auto& parts) { parts.sampling.margin = bad; }), "bake: a margin that is not finite");
    EXPECT_EQ(error([&](auto& parts) { parts.mode = Mask{bad}; }), "bake: a cutoff that is not finite");
  }
  EXPECT_EQ(error([](auto& parts) { parts.sampling.factors[0] = -1; }), "bake: a factor below 0");
  EXPECT_EQ(error([](auto& parts) { parts.sampling.margin = -1; }), "bake: a margin below 0");
  EXPECT_EQ(error([](auto& parts) { parts.sampling.margin = 0x1p20f; }),
            "bake: a margin of 2^20 texels or more");
  EXPECT_EQ(error([](auto& parts) { parts.mode = Cutoff{1, 0}; }), "bake: a cutoff over 0");
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

TEST(ImplBakeErrors, OfTrianglesWriteNothing) {
  const std::vector<std::uint8_t> alpha(4, 0);
  const AlphaView picture{alpha.data(), 2, 2, 2};
  const TriangleBaker baker(picture, {});
  std::vector<std::uint8_t> map(4, 0xee);
  const BaseTriangle fine{{{0, 0}, {1, 0}, {0, 1}}};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 0x1p20f, -0x1p20f})
    for (std::size_t k = 0; k < 3; ++k)
      for (const bool u : {true, false}) {
        BaseTriangle uv = fine;
        (u ? uv[k].u : uv[k].v) = bad;
        EXPECT_THROW(baker.bake(uv, 2, map), std::invalid_argument);
      }
  EXPECT_THROW(baker.bake(fine, 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 3, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, max_bake_level + 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 0xffffffff, map), std::invalid_argument);
  EXPECT_EQ(map, std::vector<std::uint8_t>(4, 0xee));
  EXPECT_NO_THROW(baker.bake(fine, 2, map));
  for (const auto& [width, height] : {std::pair{0u, 2u}, {2u, 0u}, {16385u, 1u}, {1u, 0xffffffffu}})
    EXPECT_THROW(TriangleBaker({alpha.data(), width, height, 2}, {}), std::invalid_argument);
  EXPECT_THROW(TriangleBaker(picture, {1, 0}), std::invalid_argument);
}

}  // namespace impl_bake_errors_test
