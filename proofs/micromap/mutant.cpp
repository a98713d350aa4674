#include "proofs/micromap/mutant.hpp"

#include "proofs/engine/functions.hpp"

namespace mmverify::proofs::micromap {
namespace {

/// A change that is told the format of what a function of one format is asked for.
template <Format format>
std::function<void(Level, Functions::Packed, Bytes&)> of_format(const Change::OnBytes& change) {
  if (!change) return {};
  return [change](Level n, Functions::Packed in, Bytes& out) { change(n, format, in, out); };
}

Functions changed(Functions functions, const Change& change) {
  alter(functions.pack, change.pack);
  if (change.unpack)
    alter(functions.unpack, [unpack = change.unpack](Format f, std::uint64_t, Functions::Packed,
                                                     States& out) { unpack(f, out); });
  alter(functions.force2, of_format<Format::four_state>(change.force2));
  alter(functions.widen, of_format<Format::two_state>(change.widen));
  alter(functions.substitute, of_format<Format::four_state>(change.substitute));
  alter(functions.up, change.up);
  alter(functions.down, change.down);
  alter(functions.through, change.through);
  alter(functions.special_code, change.special_code);
  alter(functions.meaning, change.meaning);
  alter(functions.judge, change.judge);
  if (change.build_input)
    functions.build = [build = functions.build, input = change.build_input](std::span<const PackedMap> before,
                                                                            std::span<const PackedMap> maps,
                                                                            const Options& options) {
      Options taken = options;
      input(maps, taken);
      return build(before, maps, taken);
    };
  if (change.build)
    alter(functions.build,
          [build = change.build](std::span<const PackedMap>, std::span<const PackedMap> maps,
                                 const Options& options, Built& built) { build(maps, options, built); });
  alter(functions.validate, change.validate);
  return functions;
}

}  // namespace

Mutant mutant(std::string name, const std::string& base, Levels levels, const Change& change) {
  auto subject = std::make_shared<const MicromapSubject>(name, base + ", altered",
                                                         changed(built_in(base)->functions, change));
  return {std::move(name), std::move(subject), levels};
}

}  // namespace mmverify::proofs::micromap
