// States packed in bytes, and the special indices.
#include <set>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/micromap/micromap.hpp"

namespace mmverify::vectors::packing {
namespace {

using namespace spec::micromap;

Bytes codes(const States& states) {
  Bytes all;
  for (const State s : states) all.push_back(code(s));
  return all;
}

/// Calls each(about, states) for maps of a level and a format, each with the reason for it.
template <class Each>
void for_each_map(spec::Level n, Format f, Each each) {
  const std::uint64_t count = micro_triangles(n);
  const auto of = [&](auto state) {
    States states;
    for (std::uint64_t k = 0; k < count; ++k) states.push_back(State(state(k)));
    return states;
  };
  const unsigned all = f == Format::two_state ? 2 : 4;
  for (unsigned s = 0; s < all; ++s) each("one state", of([s](std::uint64_t) { return s; }));
  if (n == 0) return;
  each("states in turn: the order within a byte", of([all](std::uint64_t k) { return k % all; }));
  each("states in turn, a row each: the order of bytes", of([all](std::uint64_t k) { return k / 4 % all; }));
  each("first apart: the least significant bits",
       of([all](std::uint64_t k) { return k == 0 ? all - 1 : 0; }));
  each("last apart", of([all, count](std::uint64_t k) { return k + 1 == count ? 1 : all == 2 ? 0 : 2; }));
  Mixed mixed(n + all);
  each("mixed", of([&](std::uint64_t) { return mixed.bits(all == 2 ? 1 : 2); }));
}

void add_maps(Builder& out) {
  for (const Format f : {Format::two_state, Format::four_state})
    for (const spec::Level n : {0u, 1u, 2u, 3u, 4u, 5u})
      for_each_map(n, f, [&](const char* about, const States& states) {
        const auto same = uniform(states);
        out.add({about, n, f == Format::two_state ? 1u : 2u, codes(states), pack(states, f),
                 pack(force2(states), Format::two_state), same ? Optional(code(*same)) : none});
      });
}

/// Bytes with bits set after the last state: unpacking must ignore them.
void add_padded(Builder& out) {
  const auto add = [&](spec::Level n, Format f, std::uint8_t bytes) {
    out.add({"bits after the last state are set", n, f == Format::two_state ? 1u : 2u, Bytes{bytes},
             codes(unpack(Bytes{bytes}, f, micro_triangles(n)))});
  };
  for (unsigned low = 0; low < 2; ++low) add(0, Format::two_state, static_cast<std::uint8_t>(0xfe | low));
  for (unsigned low = 0; low < 4; ++low) add(0, Format::four_state, static_cast<std::uint8_t>(0xfc | low));
  for (unsigned low = 0; low < 16; ++low) add(1, Format::two_state, static_cast<std::uint8_t>(0xf0 | low));
}

void add_codes(Builder& out) {
  for (const Encoding e : encodings) {
    std::set<std::uint32_t> seen;
    const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << width(e)) - 1);
    const auto add = [&](const char* about, std::uint64_t value) {
      const auto c = static_cast<std::uint32_t>(value) & all;
      if (!seen.insert(c).second) return;
      const Meaning m = meaning(c, e);
      out.add({about, static_cast<std::uint32_t>(e), c, static_cast<std::uint32_t>(m.kind),
               m.kind == Meaning::Kind::index ? Optional(m.index) : none,
               m.kind == Meaning::Kind::special ? Optional(code(m.state)) : none});
    };
    for (const State s : {State::T, State::O, State::UT, State::UO})
      add("a special index", special_code(s, e));
    add("least and greatest plain index", 0);
    add("least and greatest plain index", index_limit(e) - 1);
    add("one beyond the plain indices", index_limit(e));
    add("-5: of clusters alone; here an index or nothing", static_cast<std::uint32_t>(-5));
    add("half of the codes", (all >> 1) + 1);
    add("half of the codes", all >> 1);
    for (const std::uint32_t narrow : {0xffu, 0xfffeu, 0xfffcu})
      add("special in a narrower encoding", narrow);
    if (e == Encoding::u8)
      for (std::uint32_t c = 0; c <= all; ++c) add("each code of 8 bits", c);
  }
}

}  // namespace

Family family() {
  Builder out("packing", 2, "states in bytes: 1 or 2 bits each, from the least significant bit of byte 0");
  const std::vector<Column> first{{"about", Kind::about, "why the vector is there"},
                                  {"level", Kind::number, "n; 4^n states"},
                                  {"format", Kind::number, "1: 2-state, 2: 4-state"}};
  std::vector<Column> columns = first;
  columns.insert(columns.end(),
                 {{"states", Kind::digits, "codes: T 0, O 1, UT 2, UO 3"},
                  {"bytes", Kind::bytes, "packed, zeros after the last state"},
                  {"forced", Kind::bytes, "under force-2-state, packed as 2-state"},
                  {"uniform", Kind::optional, "the one state of all; none where they differ"}});
  out.table("maps", "Maps, packed; each way round.", columns);
  add_maps(out);
  columns = first;
  columns.insert(columns.end(),
                 {{"bytes", Kind::bytes, "packed"},
                  {"states", Kind::digits, "what is read; bits after the last state are ignored"}});
  out.table("padded", "Bytes that are to be read, and would not be written.", columns);
  add_padded(out);
  return out.take();
}

Family special_family() {
  Builder out("special", 2,
              "what an index of a triangle means: a record, a state of the whole triangle, or nothing");
  out.table("codes", "Codes of index buffers, read as numbers of the encoding's width without a sign.",
            {{"about", Kind::about, "why the vector is there"},
             {"encoding", Kind::name, "how the buffer stores it", {"u8", "u16", "u32", "i16", "i32"}},
             {"code", Kind::number, "its bits"},
             {"kind", Kind::name, "what it means", {"index", "special", "unknown"}},
             {"index", Kind::optional, "of a plain index, before baseTriangle is added"},
             {"state", Kind::optional, "of a special one: T 0, O 1, UT 2, UO 3"}});
  add_codes(out);
  return out.take();
}

}  // namespace mmverify::vectors::packing
