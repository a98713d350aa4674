// Laws of special indices: the meaning of every code, in each encoding.
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"

namespace mmverify::proofs::micromap {
namespace {

using Kind = Meaning::Kind;
using enum State;

constexpr const char* encoding_names[] = {"u8", "u16", "u32", "i16", "i32"};

const char* name(Encoding e) { return encoding_names[static_cast<std::size_t>(e)]; }

std::string text(const Meaning& m) {
  if (m.kind == Kind::index) return fmt::format("index {}", m.index);
  return m.kind == Kind::special ? fmt::format("state {}", spec::micromap::code(m.state)) : "nothing";
}

// The meaning of a code by arithmetic on its signed value; the specification compares codes.
Meaning expected(std::uint32_t code, Encoding e) {
  const unsigned width = e == Encoding::u8 ? 8 : e == Encoding::u16 || e == Encoding::i16 ? 16 : 32;
  const std::int64_t value = code, all = std::int64_t{1} << width,
                     as_signed = value - (value >= all / 2 ? all : 0);
  if (as_signed >= -4 && as_signed < 0) return {Kind::special, 0, static_cast<State>(-1 - as_signed)};
  const bool has_sign = e == Encoding::i16 || e == Encoding::i32;
  return has_sign && as_signed < 0 ? Meaning{Kind::unknown} : Meaning{Kind::index, code};
}

Finding means(const MicromapSubject& s, Encoding e, std::uint32_t code) {
  const Meaning is = expected(code, e), got = s.functions.meaning(code, e);
  if (got != is) return wrong(text(is), text(got));
  if (is.kind == Kind::special)
    if (const std::uint32_t back = s.functions.special_code(is.state, e); back != code)
      return wrong(fmt::format("code {} for {}", code, text(is)), fmt::format("{}", back));
  return {
      static_cast<std::uint64_t>(is.kind) << 40 | is.index | spec::micromap::code(is.state), true, {}, {}};
}

struct Code {
  Encoding encoding;
  std::uint32_t code;
};

std::string at(const Code& c) { return fmt::format("{}:{}", name(c.encoding), c.code); }

Finding replayed(const MicromapSubject& s, Level, const std::string& text) {
  const Groups parts = groups_of(text, "(u8|u16|u32|i16|i32):([0-9]{1,10})");
  if (!parts) throw BadCase("'" + text + "': write u16:65533");
  std::size_t e = 0;
  while ((*parts)[1] != encoding_names[e]) ++e;
  const auto encoding = static_cast<Encoding>(e);
  const std::uint64_t code = std::stoull((*parts)[2]);
  if (code >> spec::micromap::width(encoding) != 0)
    throw BadCase(fmt::format("'{}': a code has {} bits", text, spec::micromap::width(encoding)));
  return means(s, encoding, static_cast<std::uint32_t>(code));
}

// The number of codes of 8 bits, of 16 unsigned, and of 16 signed.
constexpr std::uint64_t small_codes = 256 + 2 * 65'536;

Code small_code(std::uint64_t k) {
  if (k < 256) return {Encoding::u8, static_cast<std::uint32_t>(k)};
  k -= 256;
  return {k < 65'536 ? Encoding::u16 : Encoding::i16, static_cast<std::uint32_t>(k % 65'536)};
}

// The codes of each 32-bit encoding: those around 0 and 2^31; 16 around each power of two, at which codes of fewer
// bits have their special ones; and others anywhere.
constexpr std::uint64_t around = 8192, powers = 32, around_power = 16, anywhere = 50'000;
constexpr std::uint64_t wide_codes = 2 * (2 * around + powers * around_power + anywhere);

Code wide_code(std::uint64_t k, std::uint64_t seed) {
  const Encoding e = k % 2 == 0 ? Encoding::u32 : Encoding::i32;
  k /= 2;
  if (k < 2 * around)
    return {e, static_cast<std::uint32_t>((k < around ? 0 : 0x80000000u) + k % around - around / 2)};
  k -= 2 * around;
  if (k < powers * around_power)
    return {e, static_cast<std::uint32_t>((1u << k / around_power) + k % around_power - around_power / 2)};
  return {e, static_cast<std::uint32_t>(Random(seed, 0, k).next())};
}

auto one_code(Encoding encoding, std::uint32_t code, Meaning now) {
  return spoils(&Functions::meaning, [=](std::uint32_t c, Encoding e, Meaning& m) {
    if (c == code && e == encoding) m = now;
  });
}

constexpr char source[] =
    "VkAccelerationStructureTrianglesOpacityMicromapKHR; EXT_mesh_opacity_micromap, Special Indices";
constexpr char says[] =
    "the last four codes of an encoding, and no others, are T, O, UT, UO from the last down; other negative "
    "codes mean nothing, the rest are indices";

Law small() {
  return on_cases({.id = "micromap.special_indices",
                   .says = says,
                   .source = source,
                   .subjects = {"micromap-spec", "micromap"},
                   .tiers = {.fast = {0, 0}, .long_run = {0, 0}, .seconds = 1},
                   .at_once = "all levels",
                   .domain = "all codes of u8, u16 and i16",
                   .mutants = {mutant("-5 is UO in 8 bits", "micromap", {0, 0},
                                      one_code(Encoding::u8, 251, {Kind::special, 0, UO})),
                               mutant("-32768 is an index", "micromap-spec", {0, 0},
                                      one_code(Encoding::i16, 0x8000, {Kind::index, 0x8000})),
                               mutant("UT and UO change codes in 16 bits with a sign", "micromap", {0, 0},
                                      spoils(&Functions::special_code,
                                             [](State s, Encoding e, std::uint32_t& code) {
                                               if (e == Encoding::i16 && (s == UT || s == UO)) code ^= 1;
                                             }))}},
                  {entry::special},
                  {[](Level) { return small_codes; },
                   [](const MicromapSubject& s, Level, std::uint64_t k, const Run&) {
                     return means(s, small_code(k).encoding, small_code(k).code);
                   },
                   [](Level, std::uint64_t k, const Run&) { return at(small_code(k)); }, replayed, 8192});
}

Law wide() {
  return on_cases(
      {.id = "micromap.special_indices_32",
       .says = says,
       .source = source,
       .method = Method::sample,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {0, 0}, .long_run = {0, 0}, .seconds = 1},
       .at_once = "all levels",
       .domain = "codes of u32 and i32: 8192 around 0, 8192 around 2^31, 16 around each power of two, 50,000 "
                 "anywhere",
       .mutants = {mutant("-5 without sign means nothing", "micromap", {0, 0},
                          one_code(Encoding::u32, 0xfffffffb, {Kind::unknown})),
                   mutant("2^31 - 1 means nothing", "micromap-spec", {0, 0},
                          one_code(Encoding::i32, 0x7fffffff, {Kind::unknown})),
                   mutant("UO is -5", "micromap", {0, 0},
                          spoils(&Functions::special_code,
                                 [](State s, Encoding e, std::uint32_t& code) {
                                   if (e == Encoding::i32 && s == UO) --code;
                                 }))}},
      {entry::special},
      {[](Level) { return wide_codes; },
       [](const MicromapSubject& s, Level, std::uint64_t k, const Run& run) {
         const Code c = wide_code(k, run.seed);
         return means(s, c.encoding, c.code);
       },
       [](Level, std::uint64_t k, const Run& run) { return at(wide_code(k, run.seed)); }, replayed, 8192});
}

}  // namespace

std::vector<Law> special_laws() { return {small(), wide()}; }

}  // namespace mmverify::proofs::micromap
