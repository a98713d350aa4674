// Arrays of many triangles: a file read twice, or maps built, changed and written twice.
//
// Input: a byte.  If it is even, the rest is a file.  If it is odd, a byte of choices, an encoding, a base triangle, a
// bound, the number of maps that exist before, and maps: each a byte of level (two bits), format and "filled", then
// packed bytes, or the one byte that fills it.  Missing bytes are zeros.
//
// Covers: impl/array/api.hpp impl/array/build.* impl/array/change.* impl/array/container.*
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "impl/array/build.hpp"
#include "impl/array/change.hpp"
#include "impl/array/container.hpp"
#include "spec/array/build.hpp"
#include "spec/array/change.hpp"
#include "spec/array/container.hpp"
#include "spec/array/emulate.hpp"

namespace {

namespace fast = mmverify::impl::array;
namespace slow = mmverify::spec::array;
namespace maps = mmverify::spec::micromap;
using maps::Bytes;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "array_differential: %s\n", what.c_str());
  std::abort();
}

class Reader {
 public:
  Reader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  Bytes bytes(std::size_t count) {
    Bytes out(count);
    for (std::uint8_t& b : out) b = byte();
    return out;
  }
  bool empty() const { return left_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

slow::Bundle to_slow(const fast::Bundle& b) {
  slow::Bundle out;
  for (const auto& r : b.array.records) out.array.records.push_back({r.offset, r.level, r.format});
  out.array.data = b.array.data;
  for (const fast::Part& p : b.parts)
    out.parts.push_back({static_cast<maps::Encoding>(p.encoding), p.base, p.indices});
  return out;
}

void same(const slow::Bundle& right, const fast::Bundle& got, const char* what) {
  if (to_slow(got) != right) fail(std::string(what) + " gives another array");
}

void read_file(const Bytes& file) {
  const std::optional<slow::Bundle> right = slow::read(file);
  fast::Bundle got;
  try {
    got = fast::read(file);
  } catch (const std::invalid_argument& refused) {
    if (right) fail(std::string("a file is refused: ") + refused.what());
    if (!std::string(refused.what()).starts_with("byte ")) fail("a refusal without its place");
    return;
  }
  if (!right) fail("what is no file is read");
  same(*right, got, "reading");
  if (fast::written(got, file[8]) != file) fail("what is read is written as other bytes");
  // Records and indices may have any values: both sides change the file alike, or both refuse.
  for (const auto& [spec, impl] :
       {std::pair(&slow::compacted, &fast::compacted), std::pair(&slow::reordered, &fast::reordered)}) {
    std::optional<fast::Bundle> changed;
    try {
      changed = impl(got);
    } catch (const std::logic_error&) {
    }
    // The specification's domain is arrays whose references exist.
    bool sound = true;
    for (const slow::Part& p : right->parts)
      for (std::uint64_t t = 0; t < slow::triangles(p); ++t)
        sound = sound && slow::target(*right, p, t).kind != slow::Target::Kind::outside;
    if (!sound) {
      if (changed) fail("an index of no record is passed");
      continue;
    }
    std::optional<slow::Bundle> expected;
    try {
      expected = spec(*right);
    } catch (const std::logic_error&) {
    }
    if (expected.has_value() != changed.has_value()) fail("one of two changes refuses");
    if (expected) same(*expected, *changed, "a change");
  }
}

/// Options, and maps: the first ones exist before the build.
struct Given {
  slow::BuildOptions options;
  std::size_t first;
  std::vector<Bytes> packed;
  std::vector<maps::Map> all;
};

Given given(Reader& reader) {
  Given g;
  slow::BuildOptions& o = g.options;
  const std::uint8_t flags = reader.byte();
  o.api = slow::apis[flags / 4 % slow::api_count];
  o.special = (flags & 1) != 0;
  o.share = (flags & 2) != 0;
  o.encoding = maps::encodings[reader.byte() % 5];
  if (!slow::takes(o.api, o.encoding)) o.api = slow::Api::glTF;
  const std::uint8_t base = reader.byte();
  o.bound = reader.byte() % 8;
  const std::size_t before = reader.byte() % 4;
  while (!reader.empty() && g.all.size() < 300) {
    const std::uint8_t head = reader.byte();
    const mmverify::spec::Level level = head % 4;
    const maps::Format f = (head & 4) != 0 ? maps::Format::four_state : maps::Format::two_state;
    const std::uint64_t count = maps::micro_triangles(level);
    const std::size_t size = static_cast<std::size_t>(maps::packed_bytes(count, f));
    const bool filled = (head & 8) != 0;
    const Bytes bytes = filled ? Bytes(size, reader.byte()) : reader.bytes(size);
    g.all.push_back({level, f, maps::unpack(bytes, f, count)});
    g.packed.push_back(bytes);  // its padding as given
  }
  g.first = std::min(before, g.all.size());
  o.base = base % static_cast<std::uint32_t>(g.first + 1);
  return g;
}

std::optional<slow::Built> built_by_spec(const Given& g) try {
  return slow::build(std::span(g.all).first(g.first), std::span(g.all).subspan(g.first), g.options);
} catch (const std::length_error&) {
  return std::nullopt;
}

std::optional<fast::Built> built_by_impl(const Given& g) {
  const slow::BuildOptions& o = g.options;
  std::vector<fast::PackedMap> views;
  for (std::size_t t = 0; t < g.packed.size(); ++t)
    views.push_back({g.all[t].level, static_cast<fast::Format>(g.all[t].format), g.packed[t]});
  try {
    return fast::build(std::span(views).first(g.first), std::span(views).subspan(g.first),
                       {static_cast<fast::Api>(o.api), static_cast<fast::Encoding>(o.encoding), o.base,
                        o.special, o.share, o.bound});
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

void same_counts(const slow::Built& right, const fast::Built& got) {
  const auto same = [](const std::vector<fast::UsageCount>& x, const std::vector<maps::UsageCount>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& p, const auto& q) {
      return p.count == q.count && p.level == q.level && p.format == q.format;
    });
  };
  if (!same(got.array_counts, right.array_counts)) fail("another histogram of the array");
  if (got.geometry_counts.has_value() != right.geometry_counts.has_value() ||
      (right.geometry_counts && !same(*got.geometry_counts, *right.geometry_counts)))
    fail("another histogram of the geometry");
}

/// Checks that triangle t resolves to its baked map, or to one with more unknown states.
void check_resolved(const slow::Bundle& bundle, std::size_t t, const maps::Map& baked, std::uint64_t bound) {
  const slow::Target to = slow::target(bundle, bundle.parts[0], t);
  std::uint64_t changed = 0;
  if (to.kind != slow::Target::Kind::special && to.kind != slow::Target::Kind::record)
    fail("a triangle without a map");
  const maps::States is = to.kind == slow::Target::Kind::special
                              ? maps::States(baked.states.size(), to.state)
                              : slow::map_of(bundle.array, to.record).states;
  if (is.size() != baked.states.size()) fail("another level");
  for (std::size_t i = 0; i < is.size(); ++i) {
    changed += is[i] != baked.states[i] ? 1 : 0;
    if (is[i] != baked.states[i] && (maps::unknown(baked.states[i]) || !maps::unknown(is[i])))
      fail("a state is neither what was baked nor more unknown");
  }
  if (changed > bound) fail("more is changed than the bound says");
}

void build(Reader& reader) {
  const Given g = given(reader);
  const std::optional<slow::Built> right = built_by_spec(g);
  const std::optional<fast::Built> got = built_by_impl(g);
  if (right.has_value() != got.has_value()) fail("one of two builders refuses");
  if (!right) return;
  const slow::Bundle bundle{right->array, {right->part}};
  const fast::Bundle fast_bundle{got->array, {got->part}};
  same(bundle, fast_bundle, "building");
  same_counts(*right, *got);
  for (std::size_t t = 0; t + g.first < g.all.size(); ++t)
    check_resolved(bundle, t, g.all[g.first + t], g.options.bound);
  read_file(slow::written(bundle));
  same(slow::concatenated(bundle, bundle), fast::concatenated(fast_bundle, fast_bundle), "concatenating");
  std::vector<std::uint32_t> codes;
  for (std::uint64_t t = 0; t < slow::triangles(bundle.parts[0]); ++t)
    codes.push_back(slow::code(bundle.parts[0], t));
  if (slow::blocks(codes) != fast::blocks(codes)) fail("other blocks");
  for (std::size_t t = 0; t < g.all.size(); ++t) {
    const maps::Map& map = g.all[t];
    if (map.format != maps::Format::four_state || map.level == 0) continue;
    const maps::Map below = slow::emulated(map, map.level / 2);
    if (fast::emulated(g.packed[t], map.level, map.level / 2) != maps::pack(below.states, below.format))
      fail("another emulated map");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Reader reader(data, size);
  if (reader.byte() % 2 == 0)
    read_file(size == 0 ? Bytes() : Bytes(data + 1, data + size));
  else
    build(reader);
  return 0;
}
