#include "proofs/micromap/subject.hpp"
#include "subjects/dock/codec.hpp"

namespace mmverify::proofs::micromap {
namespace {

using dock::Call;
using dock::LibraryPtr;
using spec::micromap::micro_triangles;

constexpr std::uint32_t two = 1, four = 2;

std::uint32_t number(Format f) { return spec::micromap::bits(f); }

std::size_t packed_bytes(std::uint64_t states, std::uint32_t format) {
  return static_cast<std::size_t>((states * format + 7) / 8);
}

/// The level of a map with that many states; for messages.
Level level_of(std::uint64_t states) { return static_cast<Level>(std::countr_zero(states) / 2); }

Bytes packed(Format f, const States& states) { return spec::micromap::pack(states, f); }

Bytes ask(const dock::Library& library, const std::string& doing, const dock::Question& question,
          const std::function<std::string()>& map) {
  return dock::ask(library, question, [&] { return doing + " " + map(); }).bytes;
}

Bytes of_map(const dock::Library& library, const char* doing, Call call, Level n, std::uint32_t format,
             std::span<const std::uint8_t> map, std::size_t room) {
  return ask(library, doing, {call, n, format, map, room},
             [&] { return dock::map_text(format, micro_triangles(n), map); });
}

Functions functions_of(const LibraryPtr& library) {
  const auto offers = [&](Call call) { return library->offers(call); };
  Functions f;
  if (offers(Call::micromap_pack) && offers(Call::micromap_unpack)) {
    f.pack = [library](Format format, const States& states) {
      Bytes codes;
      for (const State s : states) codes.push_back(spec::micromap::code(s));
      return ask(*library, "packing",
                 {Call::micromap_pack, level_of(states.size()), number(format), codes,
                  packed_bytes(states.size(), number(format))},
                 [&] { return dock::map_text(number(format), states.size(), packed(format, states)); });
    };
    f.unpack = [library](Format format, std::uint64_t count, std::span<const std::uint8_t> bytes) {
      States states;
      for (const std::uint8_t code : ask(*library, "unpacking",
                                         {Call::micromap_unpack, level_of(count), number(format), bytes,
                                          static_cast<std::size_t>(count)},
                                         [&] { return dock::map_text(number(format), count, bytes); }))
        states.push_back(static_cast<State>(code));
      return states;
    };
  }
  if (offers(Call::micromap_force2)) {
    f.force2 = [library](Level n, std::span<const std::uint8_t> map) {
      return of_map(*library, "force-2-state of", Call::micromap_force2, n, four, map,
                    packed_bytes(micro_triangles(n), two));
    };
    // The specification's widening, for a subject that only forces.
    f.widen = [](Level n, std::span<const std::uint8_t> map) {
      return packed(Format::four_state, spec::micromap::unpack(map, Format::two_state, micro_triangles(n)));
    };
    if (offers(Call::micromap_widen))
      f.widen = [library](Level n, std::span<const std::uint8_t> map) {
        return of_map(*library, "widening", Call::micromap_widen, n, two, map,
                      packed_bytes(micro_triangles(n), four));
      };
  }
  if (offers(Call::micromap_up))
    f.up = [library](Level n, Format format, std::span<const std::uint8_t> map) {
      return of_map(*library, "one level up from", Call::micromap_up, n, number(format), map,
                    packed_bytes(micro_triangles(n + 1), number(format)));
    };
  if (offers(Call::micromap_down))
    f.down = [library](Level n, Format format, std::span<const std::uint8_t> map) {
      return of_map(*library, "one level down from", Call::micromap_down, n, number(format), map,
                    packed_bytes(micro_triangles(n - 1), number(format)));
    };
  if (offers(Call::micromap_through))
    f.through = [library](Level n, Mode mode, std::span<const std::uint8_t> map) {
      const auto number_of_mode = static_cast<std::uint32_t>(mode);
      return ask(*library, "through mode " + std::to_string(number_of_mode),
                 {Call::micromap_through, n, number_of_mode, map, map.size()},
                 [&] { return dock::map_text(four, micro_triangles(n), map); });
    };
  if (offers(Call::micromap_substitute))
    f.substitute = [library](Level n, std::span<const std::uint8_t> map) {
      return of_map(*library, "substituting in", Call::micromap_substitute, n, four, map, map.size());
    };
  return f;
}

}  // namespace

MicromapSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::micromap)) return nullptr;
  return std::make_shared<MicromapSubject>(name, library->about(), functions_of(library),
                                           library->fingerprint());
}

}  // namespace mmverify::proofs::micromap
