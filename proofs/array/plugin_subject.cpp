#include <cstring>

#include "proofs/array/answers.hpp"
#include "proofs/array/small_answers.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/dock/elements.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;
using dock::Call;
using dock::Library;
using dock::LibraryPtr;

static_assert(static_cast<std::uint32_t>(Api::EXT) == MMVERIFY_ARRAY_EXT);
static_assert(static_cast<std::uint32_t>(Api::glTF) == MMVERIFY_ARRAY_GLTF);
static_assert(static_cast<std::uint32_t>(Encoding::i32) == MMVERIFY_INDEX_I32);
static_assert(static_cast<std::uint32_t>(Target::Kind::outside) == MMVERIFY_TARGET_OUTSIDE);

/// The triangles of a case, and the bytes that their maps lie in.
struct LaidOut {
  std::vector<mmverify_array_triangle_t> triangles;
  Bytes bytes;
};

LaidOut laid_out(const BuildCase& c) {
  LaidOut out;
  std::vector<const Bytes*> all;
  for (const auto* some : {&c.before, &c.maps})
    for (const PackedMap& m : *some) {
      out.triangles.push_back({m.level, static_cast<std::uint32_t>(m.format), 0});
      all.push_back(&m.bytes);
    }
  constexpr std::uint8_t between = 0xa5;
  std::map<Bytes, std::uint32_t> places;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t t = c.scattered ? all.size() - 1 - k : k;
    const Bytes& map = *all[t];
    const auto end = static_cast<std::uint32_t>(out.bytes.size());
    const auto [place, is_new] = places.try_emplace(map, end);
    out.triangles[t].map = c.scattered ? place->second : end;
    if (c.scattered && !is_new) continue;
    out.bytes.insert(out.bytes.end(), map.begin(), map.end());
    if (c.scattered) out.bytes.push_back(between);
  }
  return out;
}

std::vector<std::uint8_t> blob_of(const BuildCase& c) {
  const BuildOptions& o = c.options;
  const auto [triangles, bytes] = laid_out(c);
  mmverify_array_case_t what{};
  what.size = sizeof what;
  what.api = static_cast<std::uint32_t>(o.api);
  what.index_type = static_cast<std::uint32_t>(o.encoding);
  what.base_triangle = o.base;
  what.flags = (o.special ? MMVERIFY_ARRAY_SPECIAL : 0) | (o.share ? MMVERIFY_ARRAY_SHARE : 0);
  what.bound = o.bound;
  what.before = static_cast<std::uint32_t>(c.before.size());
  what.count = static_cast<std::uint32_t>(triangles.size());
  const std::size_t of_triangles = triangles.size() * sizeof(mmverify_array_triangle_t);
  std::vector<std::uint8_t> blob(sizeof what + of_triangles);
  std::memcpy(blob.data(), &what, sizeof what);
  if (of_triangles != 0) std::memcpy(blob.data() + sizeof what, triangles.data(), of_triangles);
  blob.insert(blob.end(), bytes.begin(), bytes.end());
  return blob;
}

/// A case as a message names it: its text, where that is short.
std::string doing(const BuildCase& c) {
  std::size_t bytes = 0;
  for (const auto* some : {&c.before, &c.maps})
    for (const PackedMap& m : *some) bytes += m.bytes.size();
  constexpr std::size_t most = 24;
  return bytes <= most ? text_of(c)
                       : fmt::format("{}, and {} triangles", text_of({{}, {}, c.options}), c.maps.size());
}

std::optional<Answer> build(const Library& library, const BuildCase& c) {
  const std::vector<std::uint8_t> blob = blob_of(c);
  const dock::Answer answer =
      dock::ask(library, {Call::array_build, 0, 0, blob, 4096}, [&] { return "building " + doing(c); });
  if (!answer.taken) return std::nullopt;
  return read_answer(answer.bytes);
}

std::vector<Target> targets(const Library& library, const Reading& r, std::span<const Reference> references) {
  std::vector<std::uint32_t> codes, bases, records;
  for (const Reference& of : references) {
    codes.push_back(of.code);
    bases.push_back(of.base);
    records.push_back(of.records);
  }
  std::vector<std::uint32_t> out(2 * codes.size());
  dock::ask_all(library,
                {Call::array_resolve,
                 0,
                 static_cast<std::uint32_t>(r.encoding) | (r.cluster ? MMVERIFY_INDEX_IN_CLUSTER : 0),
                 {codes.data(), bases.data(), records.data()},
                 [&](std::size_t k) {
                   return fmt::format("code {:#x} with base {}, {} records", codes[k], bases[k], records[k]);
                 }},
                codes.size(), out.data());
  std::vector<Target> all;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    Target to{static_cast<Target::Kind>(std::min(out[2 * k], 255u))};
    // A state that is none makes it a kind that is none.
    if (to.kind == Target::Kind::special && out[2 * k + 1] > 3)
      to.kind = static_cast<Target::Kind>(255);
    else if (to.kind == Target::Kind::special)
      to.state = static_cast<State>(out[2 * k + 1]);
    else if (to.kind == Target::Kind::record)
      to.record = out[2 * k + 1];
    all.push_back(to);
  }
  return all;
}

// Arrays as mmverify_array_parts has them: what a file of version 2 has between its name and its sum.
constexpr std::uint32_t parts_version = 2;
constexpr std::size_t before_parts = 12, behind_parts = 4;

Bytes parts_of(const Bundle& b) {
  const Bytes file = spec::array::written(b, parts_version);
  return {file.begin() + before_parts, file.end() - behind_parts};
}

/// None where the bytes are no array.
std::optional<Bundle> bundle_of_parts(const Bytes& parts) {
  Bytes file = spec::array::written({}, parts_version);
  file.resize(before_parts);
  file.insert(file.end(), parts.begin(), parts.end());
  const std::uint32_t sum = spec::array::checksum(file);
  for (unsigned j = 0; j < behind_parts; ++j) file.push_back(static_cast<std::uint8_t>(sum >> 8 * j));
  return spec::array::read(file);
}

std::string doing(const char* what, const Bundle& b) {
  return fmt::format("{} an array of {} records and {} bytes of data, of {} geometries", what,
                     b.array.records.size(), b.array.data.size(), b.parts.size());
}

dock::Answer ask(const Library& library, Call call, std::uint32_t version, const Bytes& blob,
                 const char* what, const Bundle& about) {
  return dock::ask(library, {call, 0, version, blob, 4096}, [&] { return doing(what, about); });
}

/// An answer that is no array: an odd number of bytes of indices of 16 bits, which no array has.
Bundle no_array() {
  Bundle b;
  b.parts.push_back({Encoding::u16, 0, {0}});
  return b;
}

/// An array without geometries where it refuses, which is never right.
Bundle changed(const Library& library, Call call, const Bytes& arrays, const char* what,
               const Bundle& about) {
  const dock::Answer answer = ask(library, call, 0, arrays, what, about);
  return answer.taken ? bundle_of_parts(answer.bytes).value_or(no_array()) : Bundle{};
}

Bundle concatenated(const Library& library, const Bundle& first, const Bundle& second) {
  Bytes both = parts_of(first);
  const Bytes behind = parts_of(second);
  both.insert(both.end(), behind.begin(), behind.end());
  return changed(library, Call::array_concatenate, both, "concatenating another to", first);
}

Bytes saved(const Library& library, const Bundle& b, std::uint32_t version) {
  const dock::Answer answer = ask(library, Call::array_save, version, parts_of(b), "saving", b);
  return answer.taken ? answer.bytes : Bytes{};
}

std::optional<Bundle> loaded(const Library& library, std::span<const std::uint8_t> file) {
  const dock::Answer answer = dock::ask(library, {Call::array_load, 0, 0, file, 4096}, [&] {
    return fmt::format("loading a file of {} bytes", file.size());
  });
  if (!answer.taken) return std::nullopt;
  return bundle_of_parts(answer.bytes).value_or(no_array());
}

Bytes emulated(const Library& library, Level n, Level most, std::span<const std::uint8_t> map) {
  const std::uint64_t room = maps::packed_bytes(maps::micro_triangles(most), Format::four_state);
  const dock::Answer answer = dock::ask(library, {Call::array_emulate, n, most, map, room}, [&] {
    return fmt::format("emulating at level {} the map {}", most,
                       dock::map_text(2, maps::micro_triangles(n), map));
  });
  return answer.taken ? answer.bytes : Bytes{};
}

Functions functions_of(const LibraryPtr& library) {
  Functions f;
  f.gets_places = true;
  if (library->offers(Call::array_build)) {
    f.build = [library](const BuildCase& c) { return build(*library, c); };
    f.small_arrays = small_arrays_of_subject();
  }
  if (library->offers(Call::array_resolve))
    f.targets = [library](const Reading& r, std::span<const Reference> references) {
      return targets(*library, r, references);
    };
  if (library->offers(Call::array_compact))
    f.compact = [library](const Bundle& b) {
      return changed(*library, Call::array_compact, parts_of(b), "compacting", b);
    };
  if (library->offers(Call::array_reorder))
    f.reorder = [library](const Bundle& b) {
      return changed(*library, Call::array_reorder, parts_of(b), "reordering", b);
    };
  if (library->offers(Call::array_concatenate))
    f.concatenate = [library](const Bundle& a, const Bundle& b) { return concatenated(*library, a, b); };
  if (library->offers(Call::array_save))
    f.write = [library](const Bundle& b, std::uint32_t version) { return saved(*library, b, version); };
  if (library->offers(Call::array_load))
    f.read = [library](std::span<const std::uint8_t> file) { return loaded(*library, file); };
  f.files_are_ours = (library->description().flags & MMVERIFY_ARRAY_FILES) != 0;
  if (library->offers(Call::array_emulate))
    f.emulate = [library](Level n, Level most, std::span<const std::uint8_t> map) {
      return emulated(*library, n, most, map);
    };
  return f;
}

}  // namespace

ArraySubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::array)) return nullptr;
  return std::make_shared<ArraySubject>(name, library->about(), functions_of(library),
                                        library->fingerprint());
}

}  // namespace mmverify::proofs::array
