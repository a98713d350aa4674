// A case of a baker: a texture, its sampling, the alpha mode, and a base triangle on it.
#pragma once

#include "proofs/engine/law.hpp"
#include "spec/bake/state.hpp"

namespace mmverify::proofs::bake {

using spec::bake::Filter;
using spec::bake::Wrap;

/// The stored form of a texel; its alpha is byte / 255, word / 65535 or the number itself.
enum class Texel : std::uint8_t { unorm8, unorm16, float32 };

struct Cutoff {
  std::uint32_t numerator = 1, denominator = 2;
  friend bool operator==(const Cutoff&, const Cutoff&) = default;
};

/// The rules by which a state is right: by default those of subjects/sdk/mmverify_subject.h, or those that a subject declares.
struct Rules {
  bool above = false;  ///< MASK: alpha must be above the cutoff to be opaque; else at least the cutoff
  spec::bake::Contact contact = spec::bake::Contact::closed;
  float slack = 0;  ///< alpha this near to the cutoff may count as above or below it
  friend bool operator==(const Rules&, const Rules&) = default;
};

/// The cutoff that a state is judged at: the cutoff less the slack, the cutoff, or the cutoff plus the slack.
enum class Threshold : std::uint8_t { lower, exact, upper };

/// A change of texels that a map is brought up to date with: of mip k those of boxes[k] (x, y, width, height; none where
/// the width is 0), which before were drawn with `seed`.
struct TexelChange {
  std::vector<std::array<std::uint32_t, 4>> boxes = {};
  std::uint64_t seed = 0;
  friend bool operator==(const TexelChange&, const TexelChange&) = default;
};

/// Texels by their bits, mip after mip, rows from the top; mip k is max(1, width >> k) x max(1, height >> k).
struct Case {
  std::uint32_t width = 1, height = 1, mips = 1;
  Texel texel = Texel::unorm8;
  std::vector<std::uint32_t> alpha = {0};
  Filter filter = Filter::bilinear;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  std::uint32_t border = 0;
  float factor = 1, vertex_factor = 1;  ///< alpha is the sampled value times both
  bool blend = false;                   ///< the alpha mode is BLEND; else MASK, with the cutoff
  Cutoff cutoff = {};
  float margin = 0;               ///< in texels
  std::array<float, 6> uv{};      ///< of the three vertices
  std::array<float, 2> travel{};  ///< each vertex moves by up to this along u and v, on its own
  TexelChange change = {};        ///< without boxes: none, and all is baked afresh
  Rules rules = {};
  std::string drawn =
      {};  ///< the name of the draw that made all texels (domains/strata.hpp, plateaus.hpp, lone_texel.hpp); else empty
  friend bool operator==(const Case&, const Case&) = default;
};

/// The case before its change.  Domain: a box for each mip, within it.
Case before_change(const Case& one);

/// The number of texels of all mips together.
std::uint64_t texels_of(std::uint32_t width, std::uint32_t height, std::uint32_t mips);

/// A case as one word of a shell, "texels=u8:2x2:00ff80ff,wrap=repeat:clamp,cutoff=1/2,uv=0x0p+0:...".  Defaults (one
/// mip, bilinear, MASK, factors 1, no margin, travel or change) are left out.  The draw stands for more than 1024 drawn texels:
/// "texels=u8:4096x3:drawn-1-5-77"; a lone texel's and a plateau's draw always does, "texels=u8:256x256:lone-ff-0-17-200",
/// "texels=f32:24x34:plateau-1-2-7".
std::string text_of(const Case& one);
/// The case of a text.  Throws BadCase, also for a side of 0 or above 16384, a number that is not finite, a cutoff
/// over 0, or a factor or margin below 0: no baker takes such a case.
Case case_from(const std::string& text);

/// The number that is stored as `bits`, in another type: of what it cannot hold the nearest that it can.
std::uint32_t converted(Texel from, Texel to, std::uint32_t bits);

/// The case with the first columns and rows of each mip alone, its texels and its border converted.
/// None where it has fewer columns, rows or mips.
std::optional<Case> resized(Case one, std::uint32_t width, std::uint32_t height, std::uint32_t mips,
                            Texel texel);

}  // namespace mmverify::proofs::bake
