// Cases of baking: families that are enumerated whole, samples, and how they are named.
#pragma once

#include "proofs/attribute/bake/functions.hpp"

namespace mmverify::proofs::attribute {

// The family: every 2x2 texture over three codes in each channel, under eight pairs of addressing modes, both meanings
// of colours, seen by seven triangles.  Texture t of the 81 gives its channels the textures t, t+20, t+40, t+60, so that
// each channel has them all.
inline constexpr std::uint64_t family_textures = 81;
inline constexpr std::array<std::uint8_t, 3> family_alphabet{0, 101, 255};
/// The texture of a channel.
constexpr std::uint64_t family_texture(std::uint64_t texture, std::size_t channel) {
  return (texture + 20 * channel) % family_textures;
}
std::uint64_t family_spots();  ///< addressing, meaning, triangle
BakeCase family_case(std::uint64_t spot, std::uint64_t texture, Filter filter);
/// The spot of a case with a texture of the family, if it is of it.
std::optional<std::uint64_t> family_spot(const BakeCase& one);
const char* family_domain();

/// Textures of up to 9x7 texels, all meanings and modes; coordinates of few bits, of many, on lines, in points.
BakeCase sample_case(std::uint64_t seed, Level n, std::uint64_t k);
/// Two texels one code apart, and a triangle about the line between them that leans by 2^-32 to 2^-36 to one side: its
/// mean is a half code and at most 10^-9 of one more, or less, in each channel.
BakeCase near_half_case(std::uint64_t seed, Level n, std::uint64_t k);
/// A row, or a column, of 257 to 320 texels, under a triangle that is longer.
BakeCase long_row_case(std::uint64_t seed, Level n, std::uint64_t k);
/// Sampled nearest, with every micro-vertex on a line between texels but for what a float cannot hold of its
/// coordinates: in fewer bits than the exact sum has, it lies on the other side.  Domain: n up to 7.
BakeCase beside_lines_case(std::uint64_t seed, Level n, std::uint64_t k);
/// sample_case() of 16 bits, sRGB left out; a quarter with neighbours one code apart, on places where their means are ties.
BakeCaseOf<std::uint16_t> wide_sample_case(std::uint64_t seed, Level n, std::uint64_t k);
/// The same of floats, up to 7x7 texels: ordinary ones, 2^100 beside 2^-100, some that cancel, below 2^-126, neighbours
/// on places where their means are ties, zeros of both signs, one of eight 2^30 times the others, and any.
BakeCaseOf<float> float_sample_case(std::uint64_t seed, Level n, std::uint64_t k);

/// "2x2:RRGGBBAA...:repeat,clamp,bilinear,srgb,00000000:u0,v0,u1,v1,u2,v2", coordinates as hexadecimal floats; of texels
/// of 16 bits a channel, RRRRGGGGBBBBAAAA, and of floats their bits, eight digits a channel.
template <class Channel>
std::string text_of(const BakeCaseOf<Channel>& one);
/// Throws BadCase.
template <class Channel>
BakeCaseOf<Channel> read_bake_case_of(const std::string& text);
inline BakeCase read_bake_case(const std::string& text) { return read_bake_case_of<std::uint8_t>(text); }

/// "r g b a".
std::string text_of(const Rgba& codes);
std::string text_of(const RgbaOf<std::uint16_t>& codes);
std::string text_of(const RgbaOf<float>& numbers);  ///< hexadecimal

inline constexpr std::array<const char*, 5> wrap_names{"repeat", "mirror", "clamp", "border", "mirror-once"};
inline constexpr std::array<const char*, 2> filter_names{"bilinear", "nearest"};
inline constexpr std::array<const char*, 4> meaning_names{"linear", "srgb", "normal", "normal+length"};

}  // namespace mmverify::proofs::attribute
