#include "proofs/attribute/packing/cases.hpp"

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {

constinit const Entry pack_entry{"codes -> bytes",
                                 [](const Functions& f) { return bool{f.compression.pack}; }};
constinit const Entry unpack_entry{"bytes -> codes",
                                   [](const Functions& f) { return bool{f.compression.unpack}; }};
constinit const Entry reader_entry{"bytes -> value",
                                   [](const Functions& f) { return bool{f.compression.reader}; }};

namespace {

constexpr std::array<const char*, 6> filling_names{"flat", "ramp", "waves", "noise", "extremes", "lone"};
constexpr std::uint64_t stream_of_shapes = 0x7368617065, stream_of_codes = 0x636f646573;

/// A value's place in the triangle, in 3 N-ths along u and v.
std::array<std::uint32_t, 2> place_of_value(const PackedShape& shape, std::uint32_t x) {
  if (shape.at == MapAt::vertices) {
    const Vertex v = spec::attribute::vertex_at(spec::attribute::VertexOrder::bird, x, shape.level);
    return {3 * v.i, 3 * v.j};
  }
  const auto t = spec::attribute::curve_triangle(x, shape.level);
  const std::uint32_t third = t.upper ? 2 : 1;
  return {3 * t.iu + third, 3 * t.iv + third};
}

}  // namespace

PackCase pack_case(Level n, std::uint64_t k, std::uint64_t seed, bool lossy) {
  PackCase one;
  one.seed = seed;
  one.number = k;
  one.filling = fillings[k / 2 % fillings.size()];
  Random random(seed, stream_of_shapes, k * 32 + n);
  PackedShape& shape = one.shape;
  shape.at = k % 2 == 0 ? MapAt::faces : MapAt::vertices;
  shape.level = n;
  shape.channels = static_cast<std::uint32_t>(1 + random.below(4));
  shape.maps = static_cast<std::uint32_t>(1 + random.below(n <= 2 ? 17 : 3));
  if (lossy)
    for (std::size_t c = 0; c < shape.channels; ++c)
      shape.error[c] = static_cast<std::uint8_t>(random.below(16) == 0 ? 127 : random.below(8));
  return one;
}

Bytes codes_of(const PackCase& one) {
  const PackedShape& shape = one.shape;
  const auto values = static_cast<std::uint32_t>(spec::attribute::values_of(shape.at, shape.level));
  Random random(one.seed, stream_of_codes, one.number * 32 + shape.level);
  Bytes codes;
  codes.reserve(std::size_t{shape.maps} * values * shape.channels);
  const std::uint64_t chosen = random.below(std::uint64_t{shape.maps} * values);
  for (std::uint32_t map = 0; map < shape.maps; ++map) {
    std::array<std::uint64_t, 8> draws{};
    for (auto& d : draws) d = random.below(256);
    for (std::uint32_t x = 0; x < values; ++x) {
      const auto [u, v] = place_of_value(shape, x);
      for (std::uint32_t c = 0; c < shape.channels; ++c) {
        const std::uint64_t N = spec::side(shape.level);
        std::uint64_t code = draws[c];
        if (one.filling == Filling::ramp) code = (draws[c] * (3 * N - u) + draws[c + 4] * u + v) / (3 * N);
        if (one.filling == Filling::waves) code += u * u * (1 + c) / (9 * N) + v + random.below(3);
        if (one.filling == Filling::noise) code = random.below(256);
        if (one.filling == Filling::extremes) code = random.below(2) * 255;
        if (one.filling == Filling::lone) code = std::uint64_t{map} * values + x == chosen ? 255 - c : 0;
        // Up and down again, so that waves do not jump.
        code %= 512;
        codes.push_back(static_cast<std::uint8_t>(code < 256 ? code : 511 - code));
      }
    }
  }
  return codes;
}

std::string text_of(const PackCase& one) {
  const PackedShape& s = one.shape;
  return fmt::format("{}:channels={},maps={},error={}/{}/{}/{},{},seed={},number={}",
                     s.at == MapAt::faces ? "faces" : "vertices", s.channels, s.maps, s.error[0], s.error[1],
                     s.error[2], s.error[3], filling_names[static_cast<std::size_t>(one.filling)], one.seed,
                     one.number);
}

PackCase pack_case_of(Level n, const std::string& text) {
  const Groups g = groups_of(text,
                             "(faces|vertices):channels=([1-4]),maps=(\\d{1,3}),error=(\\d{1,3})/(\\d{1,3})/"
                             "(\\d{1,3})/(\\d{1,3}),([a-z]+),seed=(\\d{1,18}),number=(\\d{1,12})");
  if (!g)
    throw BadCase(fmt::format(
        "'{:.80}': write faces:channels=1,maps=1,error=0/0/0/0,noise,seed=1,number=0 or vertices:...", text));
  const auto whole = [&](std::size_t k) { return std::stoull((*g)[k]); };
  PackCase one;
  one.shape.at = (*g)[1] == "faces" ? MapAt::faces : MapAt::vertices;
  one.shape.level = n;
  one.shape.channels = static_cast<std::uint32_t>(whole(2));
  one.shape.maps = static_cast<std::uint32_t>(whole(3));
  for (std::size_t c = 0; c < 4; ++c) {
    if (whole(4 + c) > (c < one.shape.channels ? 127u : 0u))
      throw BadCase(fmt::format("'{:.80}': errors are 0..127, of no channel 0", text));
    one.shape.error[c] = static_cast<std::uint8_t>(whole(4 + c));
  }
  const auto* const name = std::find((filling_names.begin)(), filling_names.end(), (*g)[8]);
  if (name == filling_names.end() || one.shape.maps == 0)
    throw BadCase(fmt::format("'{:.80}': a map or more of flat, ramp, waves, noise, extremes or lone", text));
  one.filling = fillings[static_cast<std::size_t>(name - filling_names.begin())];
  one.seed = whole(9);
  one.number = whole(10);
  return one;
}

Finding differ_at(ByteView expected, ByteView got, const char* what) {
  const auto sizes = [&](ByteView x) { return fmt::format("{} {}", x.size(), what); };
  if (expected.size() != got.size()) return wrong(sizes(expected), sizes(got));
  const auto [e, o] = std::mismatch(expected.begin(), expected.end(), got.begin());
  return wrong(fmt::format("{} of {} number {}", *e, what, e - expected.begin()), fmt::format("{}", *o));
}

Cases<PackCase> pack_cases(bool lossy,
                           std::function<Finding(const AttributeSubject&, Level, const PackCase&)> check) {
  Cases<PackCase> cases;
  cases.count = {48, 480};
  cases.number = [lossy](Level n, std::uint64_t k, std::uint64_t seed) {
    return pack_case(n, k, seed, lossy);
  };
  cases.text = [](Level, const PackCase& one) { return text_of(one); };
  cases.read = pack_case_of;
  cases.check = std::move(check);
  cases.chunk = 4;
  return cases;
}

std::function<void(Functions&)> packing(
    std::function<Bytes(const Packer&, const PackedShape&, ByteView)> by) {
  return [by](Functions& f) {
    f.compression.pack = [by, real = f.compression.pack](const PackedShape& shape, ByteView codes) {
      return by(real, shape, codes);
    };
  };
}

std::function<void(Functions&)> unpacking(
    std::function<std::optional<Bytes>(const Unpacker&, const PackedShape&, ByteView)> by) {
  return [by](Functions& f) {
    f.compression.unpack = [by, real = f.compression.unpack](const PackedShape& shape, ByteView bytes) {
      return by(real, shape, bytes);
    };
  };
}

}  // namespace mmverify::proofs::attribute
