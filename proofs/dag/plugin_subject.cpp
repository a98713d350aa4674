#include "proofs/dag/subject.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::dag {
namespace {

using dock::Call;
using dock::Library;
using dock::LibraryPtr;
using spec::micromap::micro_triangles;

constexpr std::uint8_t no_state = 0xFF;

Level highest_level(const Scene& scene) {
  Level n = 0;
  for (const Map& map : scene.maps) n = std::max(n, map.level);
  return n;
}

/// The scene in the C header's form.
Bytes bytes_of(const Scene& scene) {
  Bytes bytes;
  for (const Map& map : scene.maps) {
    bytes.push_back(static_cast<std::uint8_t>(map.level));
    bytes.insert(bytes.end(), map.packed.begin(), map.packed.end());
  }
  return bytes;
}

/// The scene of bytes in that form; without maps if they are malformed.
Scene scene_of(Format f, const Bytes& bytes) {
  Scene scene{f, {}};
  for (std::size_t at = 0; at < bytes.size();) {
    const Level n = bytes[at++];
    if (n > 12) return {f, {}};
    const std::size_t size = spec::micromap::packed_bytes(micro_triangles(n), f);
    if (bytes.size() - at < size) return {f, {}};
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    scene.maps.push_back({n, {from, from + static_cast<std::ptrdiff_t>(size)}});
    at += size;
  }
  return scene;
}

std::string text_of(const Scene& scene) {
  constexpr std::size_t most = 8;
  std::string levels;
  for (std::size_t m = 0; m < std::min(scene.maps.size(), most); ++m)
    levels += fmt::format("{}{}", levels.empty() ? "" : ", ", scene.maps[m].level);
  if (scene.maps.size() > most) levels += fmt::format(", ... of {} maps", scene.maps.size());
  return fmt::format("the {}-state scene of levels {}", 1u << bits(scene.format), levels);
}

/// The library's code of a scene, or a code that it has read.
struct Held {
  Bytes code;
  std::vector<Level> levels;        ///< the levels of the encoded scene
  std::optional<Scene> scene = {};  ///< the scene of a code that was read
  bool gave_up = false;             ///< the encoder gave up, and there is no code
};

/// Leaves room for a scene several times larger than its code, so that most codes need one call only.
dock::Answer ask_decoder(const Library& library, Level n, Format f, std::span<const std::uint8_t> code,
                         std::size_t room) {
  return dock::ask(library, {Call::dag_decode, n, bits(f), code, room},
                   [&] { return "decoding " + dock::code_text(bits(f), code); });
}

void look_up(const Library& library, const Code& c, Call call, std::vector<const void*> arrays,
             std::span<std::uint8_t> state, std::function<std::string(std::uint64_t)> element) {
  const Held& held = form_of<Held>(c);
  if (held.gave_up)
    std::fill(state.begin(), state.end(), no_state);
  else
    dock::look_up(library,
                  {call, held.levels.empty() ? 0 : *std::max_element(held.levels.begin(), held.levels.end()),
                   bits(c.format), held.code, std::move(arrays), std::move(element)},
                  state);
}

void look_up_indices(const Library& library, const Code& c, Numbers map, Numbers index,
                     std::span<std::uint8_t> state) {
  look_up(library, c, Call::dag_lookup, {map.data(), index.data()}, state,
          [&](std::uint64_t k) { return fmt::format("map={},k={}", map[k], index[k]); });
}

void look_up_points(const Library& library, const Code& c, Numbers map, std::span<const float> u,
                    std::span<const float> v, std::span<std::uint8_t> state) {
  look_up(library, c, Call::dag_lookup_f32, {map.data(), u.data(), v.data()}, state,
          [&](std::uint64_t k) { return fmt::format("map={},u={:a},v={:a}", map[k], u[k], v[k]); });
}

/// Decodes by lookups of all indices, or of a point inside each micro-triangle: one half of one corner and a quarter
/// of each other.
Scene decoded_by_lookups(const Library& library, const Code& c) {
  Scene scene{c.format, {}};
  const std::vector<Level>& levels = form_of<Held>(c).levels;
  for (std::uint32_t m = 0; m < levels.size(); ++m) {
    const std::uint64_t all = micro_triangles(levels[m]);
    std::vector<std::uint32_t> map(all, m), index;
    std::vector<float> u, v;
    const float quarter = 0.25f / static_cast<float>(spec::side(levels[m]));
    for (std::uint32_t k = 0; k < all; ++k) {
      index.push_back(k);
      const auto p = spec::index::corners(k, levels[m]);
      u.push_back(static_cast<float>(2 * p[0].i + p[1].i + p[2].i) * quarter);
      v.push_back(static_cast<float>(2 * p[0].j + p[1].j + p[2].j) * quarter);
    }
    Bytes states(all, no_state);
    if (library.offers(Call::dag_lookup))
      look_up_indices(library, c, map, index, states);
    else
      look_up_points(library, c, map, u, v, states);
    States packed;
    for (const std::uint8_t s : states) {
      if (s >> bits(c.format) != 0) return {c.format, {}};
      packed.push_back(static_cast<State>(s));
    }
    scene.maps.push_back({levels[m], spec::micromap::pack(packed, c.format)});
  }
  return scene;
}

Scene decoded(const Library& library, const Code& c) {
  const Held& held = form_of<Held>(c);
  if (held.gave_up) return {c.format, {}};
  if (held.scene) return *held.scene;
  if (!library.offers(Call::dag_decode)) return decoded_by_lookups(library, c);
  Level n = 0;
  std::size_t room = 0;
  for (const Level level : held.levels) {
    n = std::max(n, level);
    room += 1 + spec::micromap::packed_bytes(micro_triangles(level), c.format);
  }
  const dock::Answer answer = ask_decoder(library, n, c.format, held.code, room);
  return answer.taken ? scene_of(c.format, answer.bytes) : Scene{c.format, {}};
}

Code encoded(const Library& library, const Scene& scene) {
  const Bytes blob = bytes_of(scene);
  dock::Answer answer = dock::ask(
      library, {Call::dag_encode, highest_level(scene), bits(scene.format), blob, 256 + 2 * blob.size()},
      [&] { return "encoding " + text_of(scene); });
  if (!answer.taken) return coded(scene.format, Held{.code = {}, .levels = {}, .gave_up = true});
  std::vector<Level> levels;
  for (const Map& map : scene.maps) levels.push_back(map.level);
  return coded(scene.format, Held{std::move(answer.bytes), std::move(levels)});
}

Functions functions_of(const LibraryPtr& library) {
  const bool container = (library->description().flags & MMVERIFY_DAG_CONTAINER) != 0;
  Functions s;
  s.max_level = std::min<Level>(s.max_level, library->description().max_level);
  s.encode = [library](const Scene& scene) { return encoded(*library, scene); };
  s.decode = [library](const Code& c) { return decoded(*library, c); };
  s.bytes = [](const Code& c) { return form_of<Held>(c).code; };
  if (library->offers(Call::dag_lookup))
    s.lookup = [library](const Code& c, Numbers map, Numbers index, std::span<std::uint8_t> state) {
      look_up_indices(*library, c, map, index, state);
    };
  if (library->offers(Call::dag_lookup_f32))
    s.point = [library](const Code& c, Numbers map, std::span<const float> u, std::span<const float> v,
                        std::span<std::uint8_t> state) { look_up_points(*library, c, map, u, v, state); };
  if (library->offers(Call::dag_decode))
    s.open = [library](Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
      dock::Answer answer = ask_decoder(*library, 0, f, bytes, 4096 + 16 * bytes.size());
      if (!answer.taken) return std::nullopt;
      return coded(f, Held{Bytes(bytes.begin(), bytes.end()), {}, scene_of(f, answer.bytes)});
    };
  s.writes_container = container;
  s.reads_container = container && library->offers(Call::dag_decode);
  return s;
}

}  // namespace

DagSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::dag)) return nullptr;
  if (!library->offers(Call::dag_encode))
    throw dock::CannotLoad(
        fmt::format("{}: it has entry points of topic dag and no dag_encode", library->path()));
  if (!library->offers(Call::dag_decode) && !library->offers(Call::dag_lookup) &&
      !library->offers(Call::dag_lookup_f32))
    throw dock::CannotLoad(fmt::format(
        "{}: nothing leads from the codes of dag_encode back to the maps; add dag_decode or dag_lookup",
        library->path()));
  return std::make_shared<DagSubject>(name, library->about(), functions_of(library), library->fingerprint());
}

}  // namespace mmverify::proofs::dag
