#include "proofs/micromap/subject.hpp"

#include "impl/micromap/append.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/validate.hpp"
#include "spec/micromap/lossy.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;
using slow::micro_triangles;
using slow::packed_bytes;

// ---- The specification

States states(Level n, std::span<const std::uint8_t> bytes) {
  return slow::unpack(bytes, Format::four_state, micro_triangles(n));
}

Functions specified() {
  Functions f;
  f.pack = [](Format format, const States& all) { return slow::pack(all, format); };
  f.unpack = [](Format format, std::uint64_t count, std::span<const std::uint8_t> bytes) {
    return slow::unpack(bytes, format, count);
  };
  f.force2 = [](Level n, std::span<const std::uint8_t> bytes) {
    return slow::pack(slow::force2(states(n, bytes)), Format::two_state);
  };
  f.widen = [](Level n, std::span<const std::uint8_t> bytes) {
    return slow::pack(slow::unpack(bytes, Format::two_state, micro_triangles(n)), Format::four_state);
  };
  f.up = [](Level n, Format format, std::span<const std::uint8_t> bytes) {
    return slow::pack(slow::up(slow::unpack(bytes, format, micro_triangles(n))), format);
  };
  f.down = [](Level n, Format format, std::span<const std::uint8_t> bytes) {
    const States s = slow::unpack(bytes, format, micro_triangles(n));
    return slow::pack(format == Format::two_state ? slow::down_two_state(s) : slow::down(s), format);
  };
  f.through = [](Level n, Mode mode, std::span<const std::uint8_t> bytes) {
    return slow::pack(slow::through(states(n, bytes), mode), Format::four_state);
  };
  f.special_code = slow::special_code;
  f.meaning = slow::meaning;
  f.judge = [](Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) -> LossyRules {
    const States a = states(n, was), b = states(n, is);
    return {slow::everywhere(a, b, slow::allowed), slow::everywhere(a, b, slow::conservative),
            slow::everywhere(a, b, slow::force2_stable)};
  };
  f.build = [](std::span<const PackedMap> before, std::span<const PackedMap> maps,
               const Options& options) -> Built {
    const auto unpacked = [](std::span<const PackedMap> some) {
      std::vector<slow::Map> out;
      for (const PackedMap& m : some)
        out.push_back({m.level, m.format, slow::unpack(m.bytes, m.format, micro_triangles(m.level))});
      return out;
    };
    slow::Array array;
    slow::append(array, unpacked(before), {Encoding::u32, 0, false, false});
    const slow::Geometry g = slow::append(array, unpacked(maps), options);
    return {slow::record_buffer(array.records), array.data, g.indices,
            slow::usage_counts(slow::array_histogram(array.records)), g.counts};
  };
  f.validate = slow::validate;
  return f;
}

// ---- impl

constexpr fast::Format to_fast(Format f) { return static_cast<fast::Format>(f); }

std::vector<fast::UsageCount> to_fast(std::span<const UsageCount> counts) {
  std::vector<fast::UsageCount> out;
  for (const UsageCount& c : counts) out.push_back({c.count, c.level, c.format});
  return out;
}

std::vector<UsageCount> to_slow(std::span<const fast::UsageCount> counts) {
  std::vector<UsageCount> out;
  for (const fast::UsageCount& c : counts) out.push_back({c.count, c.level, c.format});
  return out;
}

Bytes room(std::uint64_t count, Format f) { return Bytes(static_cast<std::size_t>(packed_bytes(count, f))); }

Built built(std::span<const PackedMap> before, std::span<const PackedMap> maps, const Options& options) {
  const auto views = [](std::span<const PackedMap> some) {
    std::vector<fast::PackedMap> out;
    for (const PackedMap& m : some) out.push_back({m.level, to_fast(m.format), m.bytes});
    return out;
  };
  fast::Array array;
  fast::append(array, views(before), {fast::Encoding::u32, 0, false, false});
  const fast::Geometry g = fast::append(array, views(maps),
                                        {static_cast<fast::Encoding>(options.encoding), options.base_triangle,
                                         options.deduplicate, options.special});
  return {fast::record_buffer(array.records), array.data, g.indices,
          to_slow(fast::usage_counts(array.records)), to_slow(g.counts)};
}

std::vector<Violation> violations(const Input& in) {
  fast::Input to;
  to.sets = in.sets;
  to.limits = {in.limits.two_state_level, in.limits.four_state_level, in.limits.lossy_four_state_level,
               in.limits.triangles};
  to.lossy = in.lossy;
  to.records = in.records;
  to.record_count = in.record_count;
  to.record_stride = in.record_stride;
  to.records_address = in.records_address;
  to.data = in.data;
  to.data_address = in.data_address;
  std::vector<fast::UsageCount> array_counts, geometry_counts;
  if (in.array_counts) to.array_counts = array_counts = to_fast(*in.array_counts);
  to.triangles = in.triangles;
  to.indexed = in.indexed;
  to.indices = in.indices;
  to.encoding = static_cast<fast::Encoding>(in.encoding);
  to.index_stride = in.index_stride;
  to.indices_address = in.indices_address;
  to.base_triangle = in.base_triangle;
  if (in.geometry_counts) to.geometry_counts = geometry_counts = to_fast(*in.geometry_counts);
  std::vector<Violation> out;
  for (const fast::Violation& v : fast::validate(to))
    out.push_back(
        {static_cast<slow::Rule>(v.rule), static_cast<slow::Place>(v.place), v.where, v.found, v.other});
  return out;
}

Functions library() {
  Functions f;
  f.pack = [](Format format, const States& all) {
    Bytes out = room(all.size(), format);
    fast::pack({reinterpret_cast<const fast::State*>(all.data()), all.size()}, to_fast(format), out);
    return out;
  };
  f.unpack = [](Format format, std::uint64_t count, std::span<const std::uint8_t> bytes) {
    States all(static_cast<std::size_t>(count));
    fast::unpack(bytes, to_fast(format), {reinterpret_cast<fast::State*>(all.data()), all.size()});
    return all;
  };
  f.force2 = [](Level n, std::span<const std::uint8_t> bytes) {
    Bytes out = room(micro_triangles(n), Format::two_state);
    fast::force2(bytes, micro_triangles(n), out);
    return out;
  };
  f.widen = [](Level n, std::span<const std::uint8_t> bytes) {
    Bytes out = room(micro_triangles(n), Format::four_state);
    fast::widen(bytes, micro_triangles(n), out);
    return out;
  };
  f.up = [](Level n, Format format, std::span<const std::uint8_t> bytes) {
    Bytes out = room(micro_triangles(n + 1), format);
    fast::up(bytes, to_fast(format), micro_triangles(n), out);
    return out;
  };
  f.down = [](Level n, Format format, std::span<const std::uint8_t> bytes) {
    Bytes out = room(micro_triangles(n - 1), format);
    fast::down(bytes, to_fast(format), micro_triangles(n - 1), out);
    return out;
  };
  f.through = [](Level n, Mode mode, std::span<const std::uint8_t> bytes) {
    Bytes bits = room(micro_triangles(n), Format::two_state),
          out = room(micro_triangles(n), Format::four_state);
    fast::to_mode(bytes, micro_triangles(n), static_cast<fast::Mode>(mode), bits);
    fast::from_mode(bits, micro_triangles(n), static_cast<fast::Mode>(mode), out);
    return out;
  };
  f.special_code = [](State s, Encoding e) {
    return fast::special_code(static_cast<fast::State>(s), static_cast<fast::Encoding>(e));
  };
  f.meaning = [](std::uint32_t code, Encoding e) -> Meaning {
    const auto encoding = static_cast<fast::Encoding>(e);
    if (const auto state = fast::special_state(code, encoding))
      return {Meaning::Kind::special, 0, static_cast<State>(*state)};
    return fast::is_index(code, encoding) ? Meaning{Meaning::Kind::index, code}
                                          : Meaning{Meaning::Kind::unknown};
  };
  f.judge = [](Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) -> LossyRules {
    const fast::Substitutions found = fast::substitutions(was, is, micro_triangles(n));
    return {found.allowed(), found.conservative(), found.force2_stable()};
  };
  f.build = built;
  f.validate = violations;
  return f;
}

// ---- Lossy codecs: what is left of a map when four siblings that differ become alike

using Merge = void (*)(std::span<State> siblings);

Functions lossy(Merge merge) {
  Functions f;
  f.substitute = [merge](Level n, std::span<const std::uint8_t> bytes) {
    States all = states(n, bytes);
    for (std::size_t k = 0; k + 4 <= all.size(); k += 4) {
      const std::span<State> siblings = std::span(all).subspan(k, 4);
      if (!slow::uniform(siblings)) merge(siblings);
    }
    return slow::pack(all, Format::four_state);
  };
  return f;
}

// Each state becomes the unknown one of its own side.
void own_unknown(std::span<State> siblings) {
  for (State& s : siblings) s = slow::as_unknown(s);
}

// T and O become the majority's unknown; what is unknown stays.
void majority_for_known(std::span<State> siblings) {
  const State one = slow::merged(siblings[0], siblings[1], siblings[2], siblings[3]);
  for (State& s : siblings)
    if (!slow::unknown(s)) s = one;
}

// All become the majority's unknown.
void majority_for_all(std::span<State> siblings) {
  const State one = slow::merged(siblings[0], siblings[1], siblings[2], siblings[3]);
  for (State& s : siblings) s = one;
}

MicromapSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<MicromapSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<MicromapSubjectPtr>& built_in_subjects() {
  static const std::vector<MicromapSubjectPtr> all{
      subject("micromap-spec", "the specification, state by state", specified()),
      subject("micromap", "impl/micromap: many states to a word", library()),
      subject("lossy-stable", "siblings that differ become unknown, each on its own side",
              lossy(own_unknown)),
      subject("lossy-conservative", "known siblings that differ become their majority's unknown",
              lossy(majority_for_known)),
      subject("lossy-merge", "siblings that differ all become their majority's unknown",
              lossy(majority_for_all))};
  return all;
}

}  // namespace mmverify::proofs::micromap
