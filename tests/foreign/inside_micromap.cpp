// Topic micromap: special indices and judges of substitutions; the other parts' rows are added.
// Source: VkOpacityMicromapSpecialIndexKHR; docs/MICROMAP.md, "Lossy substitution".
#include "tests/foreign/inside_micromap.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "proofs/micromap/subject.hpp"
#include "tests/foreign/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::micromap;
using proofs::Level;
using proofs::Levels;

// ---------------------------------------------------------------------------------------------------------------------
// Special indices
// ---------------------------------------------------------------------------------------------------------------------

enum class Wrong {
  nothing,
  bytes_have_a_sign,
  i16_has_no_sign,
  last_i16_index,
  u16_swaps_o_and_ut,
  i16_keeps_32_bits,
  u8_has_five,
  i16_ends_at_minus_128,
  u32_has_a_sign,
  i32_ends_at_minus_32768,
  low_half_alone,
  last_i32_index,
  through_binary32,
  i32_code_of_uo,
};

class Codes {
 public:
  explicit Codes(Wrong wrong) : wrong_(wrong) {}

  std::uint32_t special_code(State s, Encoding e) const {
    std::uint32_t number = static_cast<std::uint32_t>(s);
    if (wrong_ == Wrong::i32_code_of_uo && e == Encoding::i32 && number == 3) number = 2;
    if (wrong_ == Wrong::i16_keeps_32_bits && e == Encoding::i16) return ~number;
    return ~number & ones(e);
  }

  Meaning meaning(std::uint32_t code, Encoding e) const {
    // The code as a number below 0 where it is above the encoding's middle, or among the last of one without sign.
    std::uint32_t compared = code;
    if (wrong_ == Wrong::low_half_alone && e == Encoding::u32) compared |= 0xffff0000;
    const std::int64_t negative = std::int64_t{compared} - std::int64_t{ones(e)} - 1;
    const std::int64_t least = wrong_ == Wrong::u8_has_five && e == Encoding::u8 ? -5 : -4;
    if (negative >= least) {
      std::uint32_t state = static_cast<std::uint32_t>(-1 - negative) & 3;
      if (wrong_ == Wrong::u16_swaps_o_and_ut && e == Encoding::u16 && (state == 1 || state == 2)) state ^= 3;
      return {Meaning::Kind::special, 0, static_cast<State>(state)};
    }
    if (meaningless(code, e)) return {Meaning::Kind::unknown, 0, State::T};
    if (wrong_ == Wrong::through_binary32)
      return {Meaning::Kind::index,
              static_cast<std::uint32_t>(static_cast<double>(static_cast<float>(code)))};
    return {Meaning::Kind::index, code, State::T};
  }

 private:
  static std::uint32_t ones(Encoding e) {
    return e == Encoding::u8 ? 0xff : e == Encoding::u16 || e == Encoding::i16 ? 0xffff : 0xffffffff;
  }
  /// Of a code that is not special.
  bool meaningless(std::uint32_t code, Encoding e) const {
    switch (e) {
      case Encoding::u8:
        return wrong_ == Wrong::bytes_have_a_sign && code >= 0x80;
      case Encoding::i16:
        if (wrong_ == Wrong::i16_has_no_sign) return false;
        if (wrong_ == Wrong::last_i16_index && code == 0x7fff) return true;
        if (wrong_ == Wrong::i16_ends_at_minus_128) return code >= 0xff80;
        return code >= 0x8000;
      case Encoding::i32:
        if (wrong_ == Wrong::i32_ends_at_minus_32768) return code >= 0xffff8000;
        if (wrong_ == Wrong::last_i32_index && code == 0x7fffffff) return true;
        return code >= 0x80000000;
      case Encoding::u32:
        return wrong_ == Wrong::u32_has_a_sign && code >= 0x80000000;
      case Encoding::u16:
        break;
    }
    return false;
  }

  Wrong wrong_;
};

MicromapSubjectPtr codes_subject(Wrong wrong) {
  const Codes made(wrong);
  Functions functions;
  functions.special_code = [made](State s, Encoding e) { return made.special_code(s, e); };
  functions.meaning = [made](std::uint32_t code, Encoding e) { return made.meaning(code, e); };
  return std::make_shared<MicromapSubject>("foreign-codes", "special indices as signed numbers",
                                           std::move(functions));
}

// ---------------------------------------------------------------------------------------------------------------------
// Judges
// ---------------------------------------------------------------------------------------------------------------------

enum class Partial {
  nothing,
  last_one_unseen,
  ut_may_become_uo,
  uo_stays_unknown_alone,
  last_one_decides,
  counts_states,
  compares_bytes,
  all_four_changed,
  o_may_become_ut,
  first_byte_alone,
};

class Judges {
 public:
  explicit Judges(Partial wrong) : wrong_(wrong) {}

  Kept judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const {
    // The states that each may become, a bit each: the rows of the table of docs/MICROMAP.md.
    unsigned allowed[] = {0b1101, 0b1110, 0b1100, 0b1100};
    unsigned conservative[] = {0b1101, 0b1110, 0b0100, 0b1000};
    unsigned stable[] = {0b0101, 0b1010, 0b0100, 0b1000};
    if (wrong_ == Partial::ut_may_become_uo) stable[2] = 0b1100;
    if (wrong_ == Partial::uo_stays_unknown_alone) allowed[3] = 0b1000;
    if (wrong_ == Partial::o_may_become_ut) stable[1] = 0b1110;
    Kept kept{true, true, true};
    const std::uint64_t all = std::uint64_t{1} << 2 * n;
    const std::uint64_t count = wrong_ == Partial::first_byte_alone && all > 4 ? 4 : all;
    std::uint64_t changed = 0;
    int more_of[4] = {};
    for (std::uint64_t k = 0; k < count; ++k) {
      const unsigned from = at(was, k), to = at(is, k);
      changed += from != to;
      --more_of[from];
      ++more_of[to];
      if (wrong_ == Partial::last_one_decides) kept.conservative = true;
      kept.allowed &= (allowed[from] >> to & 1) != 0;
      if (wrong_ != Partial::last_one_unseen || k + 1 < count || count == 1)
        kept.conservative &= (conservative[from] >> to & 1) != 0;
      kept.force2_stable &= (stable[from] >> to & 1) != 0;
    }
    if (wrong_ == Partial::counts_states) kept.allowed = more_of[0] <= 0 && more_of[1] <= 0;
    if (wrong_ == Partial::compares_bytes && n == 0 && changed == 0) kept.force2_stable = was[0] == is[0];
    if (wrong_ == Partial::all_four_changed && changed == 4) kept.force2_stable = false;
    return kept;
  }

 private:
  static unsigned at(std::span<const std::uint8_t> packed, std::uint64_t k) {
    return packed[k / 4] >> 2 * (k % 4) & 3;
  }
  Partial wrong_;
};

MicromapSubjectPtr judging_subject(Partial wrong) {
  const Judges made(wrong);
  Functions functions;
  functions.judge = [made](Level n, auto was, auto is) { return made.judge(n, was, is); };
  return std::make_shared<MicromapSubject>("foreign-judge", "a table of rules by state",
                                           std::move(functions));
}

InsideFault code_row(const char* law, const char* name, const char* wrong, Wrong which) {
  return {law, name, wrong, codes_subject(which), {0, 0}};
}
InsideFault judge_row(const char* name, const char* wrong, Partial which, Levels levels) {
  return {"lossy.judges", name, wrong, judging_subject(which), levels};
}
constexpr char small[] = "micromap.special_indices";
constexpr char wide[] = "micromap.special_indices_32";

}  // namespace

InsideRows faults_of_codes() {
  return {
      code_row(small, "bytes_have_a_sign", "128 to 251 in a byte mean nothing", Wrong::bytes_have_a_sign),
      code_row(small, "i16_has_no_sign", "-32768 to -5 are indices", Wrong::i16_has_no_sign),
      code_row(small, "last_i16_index", "32767 is no index", Wrong::last_i16_index),
      code_row(small, "u16_swaps_o_and_ut", "read from 16 bits without sign, O and UT change places",
               Wrong::u16_swaps_o_and_ut),
      code_row(small, "i16_keeps_32_bits", "a special code of 16 bits with sign is written in 32",
               Wrong::i16_keeps_32_bits),
      code_row(small, "u8_has_five", "-5 in a byte is a special index", Wrong::u8_has_five),
      code_row(small, "i16_ends_at_minus_128", "below -128 a code of 16 bits is an index",
               Wrong::i16_ends_at_minus_128),
      code_row(wide, "u32_has_a_sign", "from 2^31 on, a code without sign means nothing",
               Wrong::u32_has_a_sign),
      code_row(wide, "i32_ends_at_minus_32768", "below -32768 a code is an index",
               Wrong::i32_ends_at_minus_32768),
      code_row(wide, "low_half_alone", "the low 16 bits alone tell a special code", Wrong::low_half_alone),
      code_row(wide, "last_i32_index", "2^31 - 1 is no index", Wrong::last_i32_index),
      code_row(wide, "through_binary32", "an index is rounded to binary32", Wrong::through_binary32),
      code_row(wide, "i32_code_of_uo", "UO is written as UT in 32 bits with sign", Wrong::i32_code_of_uo),
      judge_row("last_one_unseen", "conservative but for the last micro-triangle", Partial::last_one_unseen,
                {1, 1}),
      judge_row("ut_may_become_uo", "UT to UO is stable", Partial::ut_may_become_uo, {0, 0}),
      judge_row("o_may_become_ut", "O to UT is stable", Partial::o_may_become_ut, {1, 1}),
      judge_row("uo_stays_unknown_alone", "UO to UT is not allowed", Partial::uo_stays_unknown_alone, {0, 1}),
      judge_row("last_one_decides", "conservative by the last micro-triangle", Partial::last_one_decides,
                {1, 1}),
      judge_row("counts_states", "allowed where T and O are no more than they were, wherever they are",
                Partial::counts_states, {1, 1}),
      judge_row("all_four_changed", "not stable where all four micro-triangles changed",
                Partial::all_four_changed, {1, 1}),
      judge_row("first_byte_alone", "only the first four micro-triangles are judged",
                Partial::first_byte_alone, {0, 1}),
      judge_row("compares_bytes", "not stable where padding differs", Partial::compares_bytes, {0, 0}),
  };
}

InsideRows right_codes() {
  return {code_row(small, "codes", "", Wrong::nothing), code_row(wide, "codes", "", Wrong::nothing),
          judge_row("judges", "", Partial::nothing, {0, 1})};
}

namespace {

InsideRows together(InsideRows a, const InsideRows& b, const InsideRows& c) {
  a.insert(a.end(), b.begin(), b.end());
  a.insert(a.end(), c.begin(), c.end());
  return a;
}

}  // namespace

InsideRows inside_faults_of_micromap() {
  return together(faults_of_codes(), faults_of_builders(), faults_of_validators());
}
InsideRows inside_right_of_micromap() {
  return together(right_codes(), right_builders(), right_validators());
}

}  // namespace mmverify::tests::foreign
