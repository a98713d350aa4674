#include "proofs/micromap/plugin_subject.hpp"

#include <bit>

#include "dock/codec.hpp"

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

/// Of a map with that many states; for messages.
Level level_of(std::uint64_t states) { return static_cast<Level>(std::countr_zero(states) / 2); }

class PluginMicromap : public MicromapSubject {
 public:
  PluginMicromap(std::string name, LibraryPtr library)
      : MicromapSubject(std::move(name), library->about()), library_(std::move(library)) {}

  std::string fingerprint() const override { return library_->fingerprint(); }

  bool has(Entry e) const override {
    switch (e) {
      case Entry::pack:
        return offers(Call::micromap_pack) && offers(Call::micromap_unpack);
      case Entry::force2:
        return offers(Call::micromap_force2);
      case Entry::up:
        return offers(Call::micromap_up);
      case Entry::down:
        return offers(Call::micromap_down);
      case Entry::modes:
        return offers(Call::micromap_through);
      case Entry::substitute:
        return offers(Call::micromap_substitute);
      case Entry::special:
      case Entry::judge:
      case Entry::build:
      case Entry::validate:
        return false;
    }
    return false;
  }

  Bytes pack(Format f, const States& states) const override {
    Bytes codes;
    for (const State s : states) codes.push_back(spec::micromap::code(s));
    return ask("packing",
               {Call::micromap_pack, level_of(states.size()), number(f), codes,
                packed_bytes(states.size(), number(f))},
               [&] { return dock::map_text(number(f), states.size(), packed(f, states)); });
  }
  States unpack(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes) const override {
    States states;
    for (const std::uint8_t code :
         ask("unpacking",
             {Call::micromap_unpack, level_of(count), number(f), bytes, static_cast<std::size_t>(count)},
             [&] { return dock::map_text(number(f), count, bytes); }))
      states.push_back(static_cast<State>(code));
    return states;
  }
  Bytes force2(Level n, std::span<const std::uint8_t> map) const override {
    return of_map("force-2-state of", Call::micromap_force2, n, four, map,
                  packed_bytes(micro_triangles(n), two));
  }
  /// The specification's for a subject that forces only.
  Bytes widen(Level n, std::span<const std::uint8_t> map) const override {
    if (!offers(Call::micromap_widen)) return packed(Format::four_state, states_of(n, map));
    return of_map("widening", Call::micromap_widen, n, two, map, packed_bytes(micro_triangles(n), four));
  }
  Bytes up(Level n, Format f, std::span<const std::uint8_t> map) const override {
    return of_map("one level up from", Call::micromap_up, n, number(f), map,
                  packed_bytes(micro_triangles(n + 1), number(f)));
  }
  /// Domain: n is 1 or more.
  Bytes down(Level n, Format f, std::span<const std::uint8_t> map) const override {
    return of_map("one level down from", Call::micromap_down, n, number(f), map,
                  packed_bytes(micro_triangles(n - 1), number(f)));
  }
  Bytes through(Level n, Mode mode, std::span<const std::uint8_t> map) const override {
    const auto number_of_mode = static_cast<std::uint32_t>(mode);
    return ask("through mode " + std::to_string(number_of_mode),
               {Call::micromap_through, n, number_of_mode, map, map.size()},
               [&] { return dock::map_text(four, micro_triangles(n), map); });
  }
  Bytes substitute(Level n, std::span<const std::uint8_t> map) const override {
    return of_map("substituting in", Call::micromap_substitute, n, four, map, map.size());
  }

 private:
  bool offers(Call call) const { return library_->offers(call); }

  static Bytes packed(Format f, const States& states) { return spec::micromap::pack(states, f); }
  static States states_of(Level n, std::span<const std::uint8_t> two_state) {
    return spec::micromap::unpack(two_state, Format::two_state, micro_triangles(n));
  }

  Bytes ask(const std::string& doing, const dock::Question& question,
            const std::function<std::string()>& map) const {
    return dock::ask(*library_, question, [&] { return doing + " " + map(); }).bytes;
  }

  Bytes of_map(const char* doing, Call call, Level n, std::uint32_t format, std::span<const std::uint8_t> map,
               std::size_t room) const {
    return ask(doing, {call, n, format, map, room},
               [&] { return dock::map_text(format, micro_triangles(n), map); });
  }

  LibraryPtr library_;
};

}  // namespace

MicromapSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::micromap)) return nullptr;
  return std::make_shared<PluginMicromap>(name, library);
}

}  // namespace mmverify::proofs::micromap
