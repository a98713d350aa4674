// Topic micromap: special indices and judges of substitutions; the other parts' rows are added.
// Source: VkOpacityMicromapSpecialIndexKHR; docs/MICROMAP.md, "Lossy substitution".
#include "tests/foreign/inside/micromap.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "proofs/micromap/subject.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::micromap;
using proofs::Level;
using proofs::Levels;

// ---- Special indices

class Codes {
 public:
  explicit Codes(Fault wrong) : wrong_(wrong) {}

  std::uint32_t special_code(State s, Encoding e) const {
    std::uint32_t number = static_cast<std::uint32_t>(s);
    if (wrong_ == "i32_code_of_uo"_fault && e == Encoding::i32 && number == 3) number = 2;
    if (wrong_ == "i16_keeps_32_bits"_fault && e == Encoding::i16) return ~number;
    return ~number & ones(e);
  }

  Meaning meaning(std::uint32_t code, Encoding e) const {
    // The code as a number below 0 where it is above the encoding's middle, or among the last of one without sign.
    std::uint32_t compared = code;
    if (wrong_ == "low_half_alone"_fault && e == Encoding::u32) compared |= 0xffff0000;
    const std::int64_t negative = std::int64_t{compared} - std::int64_t{ones(e)} - 1;
    const std::int64_t least = wrong_ == "u8_has_five"_fault && e == Encoding::u8 ? -5 : -4;
    if (negative >= least) {
      std::uint32_t state = static_cast<std::uint32_t>(-1 - negative) & 3;
      if (wrong_ == "u16_swaps_o_and_ut"_fault && e == Encoding::u16 && (state == 1 || state == 2))
        state ^= 3;
      return {Meaning::Kind::special, 0, static_cast<State>(state)};
    }
    if (meaningless(code, e)) return {Meaning::Kind::unknown, 0, State::T};
    if (wrong_ == "through_binary32"_fault)
      return {Meaning::Kind::index,
              static_cast<std::uint32_t>(static_cast<double>(static_cast<float>(code)))};
    return {Meaning::Kind::index, code, State::T};
  }

 private:
  static std::uint32_t ones(Encoding e) {
    return e == Encoding::u8 ? 0xff : e == Encoding::u16 || e == Encoding::i16 ? 0xffff : 0xffffffff;
  }
  /// Whether a code that is not special is no index either.
  bool meaningless(std::uint32_t code, Encoding e) const {
    switch (e) {
      case Encoding::u8: return wrong_ == "bytes_have_a_sign"_fault && code >= 0x80;
      case Encoding::i16:
        if (wrong_ == "i16_has_no_sign"_fault) return false;
        if (wrong_ == "last_i16_index"_fault && code == 0x7fff) return true;
        if (wrong_ == "i16_ends_at_minus_128"_fault) return code >= 0xff80;
        return code >= 0x8000;
      case Encoding::i32:
        if (wrong_ == "i32_ends_at_minus_32768"_fault) return code >= 0xffff8000;
        if (wrong_ == "last_i32_index"_fault && code == 0x7fffffff) return true;
        return code >= 0x80000000;
      case Encoding::u32: return wrong_ == "u32_has_a_sign"_fault && code >= 0x80000000;
      case Encoding::u16: break;
    }
    return false;
  }

  Fault wrong_;
};

MicromapSubjectPtr codes_subject(Fault wrong) {
  const Codes made(wrong);
  Functions functions;
  functions.special_code = [made](State s, Encoding e) { return made.special_code(s, e); };
  functions.meaning = [made](std::uint32_t code, Encoding e) { return made.meaning(code, e); };
  return std::make_shared<MicromapSubject>("foreign-codes", "special indices as signed numbers",
                                           std::move(functions));
}

// ---- Judges

class Judges {
 public:
  explicit Judges(Fault wrong) : wrong_(wrong) {}

  LossyRules judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const {
    // The states that each may become, a bit each: the rows of the table of docs/MICROMAP.md.
    unsigned allowed[] = {0b1101, 0b1110, 0b1100, 0b1100};
    unsigned conservative[] = {0b1101, 0b1110, 0b0100, 0b1000};
    unsigned stable[] = {0b0101, 0b1010, 0b0100, 0b1000};
    if (wrong_ == "ut_may_become_uo"_fault) stable[2] = 0b1100;
    if (wrong_ == "uo_stays_unknown_alone"_fault) allowed[3] = 0b1000;
    if (wrong_ == "o_may_become_ut"_fault) stable[1] = 0b1110;
    LossyRules kept{true, true, true};
    const std::uint64_t all = std::uint64_t{1} << 2 * n;
    const std::uint64_t count = wrong_ == "first_byte_alone"_fault && all > 4 ? 4 : all;
    std::uint64_t changed = 0;
    int more_of[4] = {};
    for (std::uint64_t k = 0; k < count; ++k) {
      const unsigned from = at(was, k), to = at(is, k);
      changed += from != to;
      --more_of[from];
      ++more_of[to];
      if (wrong_ == "last_one_decides"_fault) kept.conservative = true;
      kept.allowed &= (allowed[from] >> to & 1) != 0;
      if (wrong_ != "last_one_unseen"_fault || k + 1 < count || count == 1)
        kept.conservative &= (conservative[from] >> to & 1) != 0;
      kept.force2_stable &= (stable[from] >> to & 1) != 0;
    }
    if (wrong_ == "counts_states"_fault) kept.allowed = more_of[0] <= 0 && more_of[1] <= 0;
    if (wrong_ == "compares_bytes"_fault && n == 0 && changed == 0) kept.force2_stable = was[0] == is[0];
    if (wrong_ == "all_four_changed"_fault && changed == 4) kept.force2_stable = false;
    return kept;
  }

 private:
  static unsigned at(std::span<const std::uint8_t> packed, std::uint64_t k) {
    return packed[k / 4] >> 2 * (k % 4) & 3;
  }
  Fault wrong_;
};

MicromapSubjectPtr judging_subject(Fault wrong) {
  const Judges made(wrong);
  Functions functions;
  functions.judge = [made](Level n, auto was, auto is) { return made.judge(n, was, is); };
  return std::make_shared<MicromapSubject>("foreign-judge", "a table of rules by state",
                                           std::move(functions));
}

InsideFault code_row(const char* law, const char* name, const char* wrong) {
  return {law, name, wrong, codes_subject(named(name)), {0, 0}};
}
InsideFault judge_row(const char* name, const char* wrong, Levels levels) {
  return {"lossy.judges", name, wrong, judging_subject(named(name)), levels};
}
constexpr char small[] = "micromap.special_indices";
constexpr char wide[] = "micromap.special_indices_32";

}  // namespace

InsideRows faults_of_codes() {
  return {
      code_row(small, "bytes_have_a_sign", "128 to 251 in a byte mean nothing"),
      code_row(small, "i16_has_no_sign", "-32768 to -5 are indices"),
      code_row(small, "last_i16_index", "32767 is no index"),
      code_row(small, "u16_swaps_o_and_ut", "read from 16 bits without sign, O and UT change places"),
      code_row(small, "i16_keeps_32_bits", "a special code of 16 bits with sign is written in 32"),
      code_row(small, "u8_has_five", "-5 in a byte is a special index"),
      code_row(small, "i16_ends_at_minus_128", "below -128 a code of 16 bits is an index"),
      code_row(wide, "u32_has_a_sign", "from 2^31 on, a code without sign means nothing"),
      code_row(wide, "i32_ends_at_minus_32768", "below -32768 a code is an index"),
      code_row(wide, "low_half_alone", "the low 16 bits alone tell a special code"),
      code_row(wide, "last_i32_index", "2^31 - 1 is no index"),
      code_row(wide, "through_binary32", "an index is rounded to binary32"),
      code_row(wide, "i32_code_of_uo", "UO is written as UT in 32 bits with sign"),
      judge_row("last_one_unseen", "conservative but for the last micro-triangle", {1, 1}),
      judge_row("ut_may_become_uo", "UT to UO is stable", {0, 0}),
      judge_row("o_may_become_ut", "O to UT is stable", {1, 1}),
      judge_row("uo_stays_unknown_alone", "UO to UT is not allowed", {0, 1}),
      judge_row("last_one_decides", "conservative by the last micro-triangle", {1, 1}),
      judge_row("counts_states", "allowed where T and O are no more than they were, wherever they are",
                {1, 1}),
      judge_row("all_four_changed", "not stable where all four micro-triangles changed", {1, 1}),
      judge_row("first_byte_alone", "only the first four micro-triangles are judged", {0, 1}),
      judge_row("compares_bytes", "not stable where padding differs", {0, 0}),
  };
}

InsideRows right_codes() {
  return {code_row(small, "codes", ""), code_row(wide, "codes", ""), judge_row("judges", "", {0, 1})};
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
