// Packed maps: what comes back, value by value as well, how far off it may be, and how large they are.
#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/packing/cases.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

constexpr char packed_source[] =
    "spec/attribute/compress.hpp; Color and Attribute Micromaps, 7, asks for one";

std::string packed_domain(const Subject&, Level) {
  return "drawn maps of faces and vertices: flat, ramps, waves, noise, extremes, one value alone";
}

/// The changed codes of a packer that alters what it packs.
std::function<void(Functions&)> altering(std::function<void(const PackedShape&, Bytes&)> change) {
  return packing([change](const Packer& real, const PackedShape& shape, ByteView codes) {
    Bytes other(codes.begin(), codes.end());
    change(shape, other);
    return real(shape, other);
  });
}

Finding comes_back(const AttributeSubject& s, Level, const PackCase& one) {
  const Bytes codes = codes_of(one), expected = slow::pack(one.shape, codes);
  const Bytes bytes = s.functions.compression.pack(one.shape, codes);
  if (bytes != expected) return differ_at(expected, bytes, "bytes");
  const auto back = s.functions.compression.unpack(one.shape, bytes);
  if (!back) return wrong("the codes", "bytes refused");
  if (*back != codes) return differ_at(codes, *back, "codes");
  return {hash_of(bytes)};
}

Law round_trip_law() {
  return on_cases(
      {.id = "attribute.packed_round_trip",
       .says = "without errors, packed maps are the bytes of the specification, and give back each code",
       .source = packed_source,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 8}, .seconds = 1},
       .domain = packed_domain,
       .mutants = {mutant("one code of level 5's vertices is one off", "attribute", {5, 5},
                          unpacking([](const Unpacker& real, const PackedShape& shape, ByteView bytes) {
                            auto codes = real(shape, bytes);
                            if (codes && shape.at == MapAt::vertices && shape.level == 5) (*codes)[500] ^= 1;
                            return codes;
                          }))}},
      needing({pack_entry, unpack_entry}), pack_cases(false, comes_back));
}

/// All values of all levels.
Finding reads_alike(const AttributeSubject& s, Level n, const PackCase& one) {
  const PackedShape& shape = one.shape;
  const Bytes bytes = slow::pack(shape, codes_of(one));
  const auto whole = s.functions.compression.unpack(shape, bytes);
  if (!whole) return wrong("the codes", "bytes refused");
  const ValueReader specified = built_in("attribute-spec")->functions.compression.reader(shape, bytes);
  const ValueReader value = s.functions.compression.reader(shape, bytes);
  const auto values = static_cast<std::uint32_t>(slow::values_of(shape.at, n));
  Hash hash;
  for (std::uint32_t map = 0; map < shape.maps; ++map)
    for (Level m = 0; m <= n; ++m)
      for (std::uint32_t x = 0; x < slow::values_of(shape.at, m); ++x) {
        auto expected = specified(map, m, x);
        if (m == n)
          for (std::size_t c = 0; c < shape.channels; ++c)
            expected[c] = (*whole)[(std::size_t{map} * values + x) * shape.channels + c];
        const auto got = value(map, m, x);
        hash.numbers(got);
        if (got != expected)
          return wrong(fmt::format("{} {} {} {} at value {} of level {}, map {}", expected[0], expected[1],
                                   expected[2], expected[3], x, m, map),
                       fmt::format("{} {} {} {}", got[0], got[1], got[2], got[3]));
      }
  return {hash.value()};
}

/// A subject that reads other values.
std::function<void(Functions&)> misreading(
    std::function<std::array<std::uint8_t, 4>(const PackedShape&, const ValueReader& real, std::uint32_t map,
                                              Level level, std::uint32_t index)>
        by) {
  return [by](Functions& f) {
    f.compression.reader = [by, make = f.compression.reader](const PackedShape& shape,
                                                             ByteView bytes) -> ValueReader {
      return [by, shape, real = make(shape, bytes)](std::uint32_t map, Level level, std::uint32_t index) {
        return by(shape, real, map, level, index);
      };
    };
  };
}

Law random_access_law() {
  return on_cases(
      {.id = "attribute.packed_random_access",
       .says = "a value read alone is the one that unpacking all gives, for each value of each map; of a "
               "lower level it is the parent of its four, or the vertex of the same number",
       .source = packed_source,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 7}, .seconds = 1.5},
       .domain = packed_domain,
       .mutants = {mutant("one vertex of level 5 is read at its level's middle", "attribute", {5, 5},
                          misreading([](const PackedShape& shape, const ValueReader& real, std::uint32_t map,
                                        Level level, std::uint32_t index) {
                            return real(
                                map, level,
                                shape.at == MapAt::vertices && level == 5 && index == 400 ? 5 : index);
                          }))}},
      needing({unpack_entry, reader_entry}), pack_cases(true, reads_alike));
}

Finding within_error(const AttributeSubject& s, Level, const PackCase& one) {
  const PackedShape& shape = one.shape;
  const Bytes codes = codes_of(one), bytes = s.functions.compression.pack(shape, codes);
  const auto back = s.functions.compression.unpack(shape, bytes);
  if (!back) return wrong("codes", "bytes refused");
  if (back->size() != codes.size()) return differ_at(codes, *back, "codes");
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const std::int32_t error = shape.error[k % shape.channels], off = (*back)[k] - codes[k];
    if (off > error || -off > error)
      return wrong(fmt::format("number {}: {} or up to {} off", k, codes[k], error),
                   fmt::format("{}", (*back)[k]));
  }
  const Bytes again = s.functions.compression.pack(shape, *back);
  if (again != bytes) return differ_at(bytes, again, "bytes");
  return {hash_of(*back)};
}

Law within_error_law() {
  return on_cases(
      {.id = "attribute.packed_within_error",
       .says = "each code that comes back is within its channel's error, none where that is 0; packing what "
               "came back gives the same bytes",
       .source = packed_source,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 8}, .seconds = 1},
       .domain = [](const Subject& s,
                    Level n) { return packed_domain(s, n) + "; errors 0..7 and 127, a channel each"; },
       .mutants = {mutant("beyond level 3 the last code is two errors off", "attribute", {4, 5},
                          altering([](const PackedShape& shape, Bytes& codes) {
                            const int error = shape.error[shape.channels - 1];
                            if (shape.level > 3)
                              codes.back() = static_cast<std::uint8_t>(codes.back() < 128
                                                                           ? codes.back() + 2 * error + 1
                                                                           : codes.back() - 2 * error - 1);
                          }))}},
      needing({pack_entry, unpack_entry}), pack_cases(true, within_error));
}

Finding is_sized(const AttributeSubject& s, Level, const PackCase& one) {
  const Bytes codes = codes_of(one);
  const auto widths = slow::widths_of(one.shape, slow::all_residuals(one.shape, codes));
  const std::uint64_t expected = slow::packed_size(one.shape, widths);
  const std::uint64_t got = s.functions.compression.pack(one.shape, codes).size();
  if (got != expected) return wrong(fmt::format("{} bytes", expected), fmt::format("{}", got));
  return {got};
}

Law size_law() {
  const auto appending =
      [](const char* name, Levels levels,
         std::function<std::size_t(const PackedShape&, const Bytes& bytes, ByteView codes)> more) {
        return mutant(name, "attribute", levels,
                      packing([more](const Packer& real, const PackedShape& shape, ByteView codes) {
                        Bytes bytes = real(shape, codes);
                        bytes.resize(bytes.size() + more(shape, bytes, codes));
                        return bytes;
                      }));
      };
  return on_cases(
      {.id = "attribute.packed_size",
       .says =
           "packed maps take M R C + 4 ceil(B/8) + ceil(B C / 2) + ceil(bits / 8) bytes: M maps of R roots "
           "and C channels, B blocks, each of three times its triples times the sum of its least widths",
       .source = packed_source,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 8}, .seconds = 1},
       .domain = packed_domain,
       .mutants = {appending("level 4's vertices end in a byte of padding", {4, 4},
                             [](const PackedShape& shape, const Bytes&, ByteView) -> std::size_t {
                               return shape.at == MapAt::vertices && shape.level == 4 ? 1 : 0;
                             })}},
      needing({pack_entry}), pack_cases(true, is_sized));
}

}  // namespace

std::vector<Law> compression_laws() {
  std::vector<Law> all{round_trip_law(), random_access_law(), within_error_law(), size_law()};
  const std::vector<Law> hostile = compression_hostile_laws();
  all.insert(all.end(), hostile.begin(), hostile.end());
  return all;
}

}  // namespace mmverify::proofs::attribute
