#include <numeric>

#include "proofs/tree/subject.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::tree {
namespace {

using dock::Call;
using dock::Library;
using dock::LibraryPtr;
using spec::micromap::micro_triangles;

constexpr std::uint8_t no_state = 0xFF;

std::size_t map_bytes(Level n, Format f) {
  return static_cast<std::size_t>(spec::micromap::packed_bytes(micro_triangles(n), f));
}

dock::Answer ask_decoder(const Library& library, Level n, Format f, std::span<const std::uint8_t> code) {
  return dock::ask(library, {Call::tree_decode, n, bits(f), code, map_bytes(n, f)},
                   [&] { return "decoding " + dock::code_text(bits(f), code); });
}

/// The library's code of a map, or a code that it has read.
struct Held {
  Bytes code;
  std::optional<Bytes> map = {};  ///< the map of a code that was read
  bool gave_up = false;           ///< the encoder gave up, and there is no code
};

void look_up(const Library& library, const Code& c, Call call, std::vector<const void*> arrays,
             std::span<std::uint8_t> state, std::function<std::string(std::uint64_t)> element) {
  const Held& held = form_of<Held>(c);
  if (held.gave_up)
    std::fill(state.begin(), state.end(), no_state);
  else
    dock::look_up(library, {call, c.level, bits(c.format), held.code, std::move(arrays), std::move(element)},
                  state);
}

void look_up_indices(const Library& library, const Code& c, std::span<const std::uint32_t> index,
                     std::span<std::uint8_t> state) {
  look_up(library, c, Call::tree_lookup, {index.data()}, state,
          [&](std::uint64_t k) { return fmt::format("k={}", index[k]); });
}

void look_up_points(const Library& library, const Code& c, std::span<const float> u, std::span<const float> v,
                    std::span<std::uint8_t> state) {
  look_up(library, c, Call::tree_lookup_f32, {u.data(), v.data()}, state,
          [&](std::uint64_t k) { return fmt::format("u={:a},v={:a}", u[k], v[k]); });
}

/// The map of these states; empty if one is no state of the format.
Bytes map_of_states(std::span<const std::uint8_t> states, Format f) {
  States map;
  for (const std::uint8_t s : states) {
    if (s >> bits(f) != 0) return {};
    map.push_back(static_cast<State>(s));
  }
  return spec::micromap::pack(map, f);
}

Bytes decoded_by_indices(const Library& library, const Code& c) {
  std::vector<std::uint32_t> all(micro_triangles(c.level));
  std::iota(all.begin(), all.end(), 0u);
  Bytes states(all.size(), no_state);
  look_up_indices(library, c, all, states);
  return map_of_states(states, c.format);
}

/// Decodes by points, one inside each micro-triangle: one half of one corner and a quarter of each other.
Bytes decoded_by_points(const Library& library, const Code& c) {
  std::vector<float> u, v;
  const float quarter = 0.25f / static_cast<float>(spec::side(c.level));
  for (std::uint64_t k = 0; k < micro_triangles(c.level); ++k) {
    const auto p = spec::index::corners(static_cast<std::uint32_t>(k), c.level);
    u.push_back(static_cast<float>(2 * p[0].i + p[1].i + p[2].i) * quarter);
    v.push_back(static_cast<float>(2 * p[0].j + p[1].j + p[2].j) * quarter);
  }
  Bytes states(u.size(), no_state);
  look_up_points(library, c, u, v, states);
  return map_of_states(states, c.format);
}

Bytes decoded_as_specified(const Code& c) {
  const auto tree = spec::tree::from_bytes(form_of<Held>(c).code, c.format);
  const auto map = tree ? spec::tree::decode(*tree, c.level, c.format) : std::nullopt;
  return map ? spec::micromap::pack(*map, c.format) : Bytes{};
}

Bytes decoded(const Library& library, const Code& c) {
  const Held& held = form_of<Held>(c);
  if (held.gave_up) return {};
  if (held.map) return *held.map;
  if (library.offers(Call::tree_decode)) {
    dock::Answer answer = ask_decoder(library, c.level, c.format, held.code);
    return answer.taken ? std::move(answer.bytes) : Bytes{};
  }
  if (library.offers(Call::tree_lookup)) return decoded_by_indices(library, c);
  if (library.offers(Call::tree_lookup_f32)) return decoded_by_points(library, c);
  return decoded_as_specified(c);
}

Code encoded(const Library& library, const Map& map) {
  const Level n = map.level;
  const Format f = map.format;
  if (!library.offers(Call::tree_encode)) {
    const States states = spec::micromap::unpack(map.packed, f, micro_triangles(n));
    return coded(n, f, Held{spec::tree::bytes(spec::tree::encode(states, n), f)});
  }
  // Leaves room for a code several times larger than the map, so that most maps need one call only.
  dock::Answer answer =
      dock::ask(library, {Call::tree_encode, n, bits(f), map.packed, 64 + 2 * map.packed.size()},
                [&] { return "encoding " + dock::map_text(bits(f), micro_triangles(n), map.packed); });
  if (!answer.taken) return coded(n, f, Held{.code = {}, .gave_up = true});
  return coded(n, f, Held{std::move(answer.bytes)});
}

/// The functions of a library.  Those that the specification replaces are not judged as the library's.
Functions functions_of(const LibraryPtr& library) {
  const auto offers = [&](Call call) { return library->offers(call); };
  const bool stream = (library->description().flags & MMVERIFY_TREE_STREAM) != 0;
  Functions s;
  s.max_level = std::min<Level>(s.max_level, library->description().max_level);
  s.encode = [library](const Map& map) { return encoded(*library, map); };
  s.decode = [library](const Code& c) { return decoded(*library, c); };
  s.bytes = [](const Code& c) { return form_of<Held>(c).code; };
  if (offers(Call::tree_lookup))
    s.lookup = [library](const Code& c, std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
      look_up_indices(*library, c, index, state);
    };
  // Answers on floats decide no other points.
  if (offers(Call::tree_lookup_f32))
    s.point = [library](const Code& c, std::span<const float> u, std::span<const float> v,
                        std::span<std::uint8_t> state) { look_up_points(*library, c, u, v, state); };
  if (offers(Call::tree_decode))
    s.open = [library](Level n, Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
      dock::Answer answer = ask_decoder(*library, n, f, bytes);
      if (!answer.taken) return std::nullopt;
      return coded(n, f, Held{Bytes(bytes.begin(), bytes.end()), std::move(answer.bytes)});
    };
  s.writes_paper = stream && offers(Call::tree_encode);
  s.reads_paper = stream && offers(Call::tree_decode);
  return s;
}

}  // namespace

TreeSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::tree)) return nullptr;
  const bool encodes = library->offers(Call::tree_encode), decodes = library->offers(Call::tree_decode),
             looks_up = library->offers(Call::tree_lookup) || library->offers(Call::tree_lookup_f32),
             stream = (library->description().flags & MMVERIFY_TREE_STREAM) != 0;
  if (!stream && !encodes)
    throw dock::CannotLoad(
        fmt::format("{}: it decodes trees and has no tree_encode; set the flag MMVERIFY_TREE_STREAM if its "
                    "codes are the paper's",
                    library->path()));
  if (!stream && !decodes && !looks_up)
    throw dock::CannotLoad(
        fmt::format("{}: nothing leads from the codes of tree_encode back to the map; add tree_decode or "
                    "tree_lookup, or set the flag MMVERIFY_TREE_STREAM if they are the paper's",
                    library->path()));
  return std::make_shared<TreeSubject>(name, library->about(), functions_of(library), library->fingerprint());
}

}  // namespace mmverify::proofs::tree
