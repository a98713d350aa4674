#include "proofs/attribute/mips/law_parts.hpp"

namespace mmverify::proofs::attribute {

constinit const Entry face_mip_entry{"four children -> mean",
                                     [](const Functions& f) { return bool{f.mips.face_mip}; }};
constinit const Entry face_chain_entry{"face map -> chain",
                                       [](const Functions& f) { return bool{f.mips.face_chain}; }};

namespace {
constexpr std::array<const char*, 4> rounding_names{"half-up", "half-to-even", "truncate", "halves-up"};
}  // namespace

const char* rounding_name(Rounding r) { return rounding_names[static_cast<std::size_t>(r)]; }
Rounding rounding_of(const std::string& name, const std::string& text) {
  for (const Rounding r : spec::attribute::roundings)
    if (name == rounding_name(r)) return r;
  throw BadCase(fmt::format("'{:.60}': roundings are half-up, half-to-even, truncate and halves-up", text));
}

std::uint64_t number_of(const std::string& digits, const std::string& text, std::uint64_t last) {
  if (digits.size() > 18 || std::stoull(digits) > last)
    throw BadCase(fmt::format("'{:.60}': a number beyond {}", text, last));
  return std::stoull(digits);
}

bool is_rounded(Rounding r, const Codes& x, std::uint32_t m) {
  const auto sum = static_cast<std::int64_t>(x[0] + x[1] + x[2] + x[3]),
             off = 4 * static_cast<std::int64_t>(m) - sum;
  switch (r) {
    case Rounding::half_up: return -2 < off && off <= 2;
    case Rounding::half_to_even: return (-2 < off && off < 2) || ((off == 2 || off == -2) && m % 2 == 0);
    case Rounding::truncate: return -4 < off && off <= 0;
    case Rounding::halves_up: break;
  }
  return m == ((x[0] + x[1] + 1) / 2 + (x[2] + x[3] + 1) / 2 + 1) / 2;
}

std::function<void(Functions&)> meaning(Mean mean) {
  return spoils(
      &Functions::mips, &Mips::face_mip,
      [mean](Rounding r, std::span<const std::uint32_t> children, std::span<std::uint32_t> parents) {
        for (std::size_t k = 0; k < parents.size(); ++k) {
          std::uint32_t word = 0;
          for (unsigned which = 0; which < 4; ++which) {
            Codes four;
            for (std::size_t c = 0; c < 4; ++c) four[c] = children[4 * k + c] >> 8 * which & 255;
            word |= mean(r, four, parents[k] >> 8 * which & 255, which) << 8 * which;
          }
          parents[k] = word;
        }
      });
}

std::function<void(Functions&)> chaining(
    std::function<void(const Chain& real, Level, Rounding, ChainOf, std::span<const std::uint32_t>,
                       std::span<std::uint32_t>)>
        by) {
  return [by](Functions& f) {
    f.mips.face_chain = [by, real = f.mips.face_chain](
                            Level n, Rounding r, ChainOf of, std::span<const std::uint32_t> base,
                            std::span<std::uint32_t> chain) { by(real, n, r, of, base, chain); };
  };
}

}  // namespace mmverify::proofs::attribute
