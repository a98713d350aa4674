#include "proofs/micromap/subject.hpp"

#include "impl/micromap/array.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/validate.hpp"
#include "spec/micromap/lossy.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;
using slow::micro_triangles;
using slow::packed_bytes;

[[noreturn]] void missing(const char* entry) {
  throw std::logic_error(std::string("asked for an entry point that is not there: ") + entry);
}

// ---------------------------------------------------------------------------------------------------------------------
// The specification
// ---------------------------------------------------------------------------------------------------------------------

class Specified final : public MicromapSubject {
 public:
  Specified() : MicromapSubject("micromap-spec", "the specification, state by state") {}
  bool has(Entry e) const override { return e != Entry::substitute; }

  Bytes pack(Format f, const States& states) const override { return slow::pack(states, f); }
  States unpack(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes) const override {
    return slow::unpack(bytes, f, count);
  }
  Bytes force2(Level n, std::span<const std::uint8_t> bytes) const override {
    return slow::pack(slow::force2(states(n, bytes)), Format::two_state);
  }
  Bytes widen(Level n, std::span<const std::uint8_t> bytes) const override {
    return slow::pack(slow::unpack(bytes, Format::two_state, micro_triangles(n)), Format::four_state);
  }
  Bytes up(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    return slow::pack(slow::up(slow::unpack(bytes, f, micro_triangles(n))), f);
  }
  Bytes down(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    const States s = slow::unpack(bytes, f, micro_triangles(n));
    return slow::pack(f == Format::two_state ? slow::down_two_state(s) : slow::down(s), f);
  }
  Bytes through(Level n, Mode mode, std::span<const std::uint8_t> bytes) const override {
    return slow::pack(slow::through(states(n, bytes), mode), Format::four_state);
  }
  std::uint32_t special_code(State s, Encoding e) const override { return slow::special_code(s, e); }
  Meaning meaning(std::uint32_t code, Encoding e) const override { return slow::meaning(code, e); }
  Kept judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const override {
    const States a = states(n, was), b = states(n, is);
    return {slow::everywhere(a, b, slow::allowed), slow::everywhere(a, b, slow::conservative),
            slow::everywhere(a, b, slow::force2_stable)};
  }
  Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps,
              const Options& options) const override {
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
  }
  std::vector<Violation> validate(const Input& in) const override { return slow::validate(in); }

 private:
  static States states(Level n, std::span<const std::uint8_t> bytes) {
    return slow::unpack(bytes, Format::four_state, micro_triangles(n));
  }
};

// ---------------------------------------------------------------------------------------------------------------------
// impl
// ---------------------------------------------------------------------------------------------------------------------

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

class Fast final : public MicromapSubject {
 public:
  Fast() : MicromapSubject("micromap", "impl/micromap: many states to a word") {}
  bool has(Entry e) const override { return e != Entry::substitute; }

  Bytes pack(Format f, const States& states) const override {
    Bytes out = room(states.size(), f);
    fast::pack({reinterpret_cast<const fast::State*>(states.data()), states.size()}, to_fast(f), out);
    return out;
  }
  States unpack(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes) const override {
    States states(static_cast<std::size_t>(count));
    fast::unpack(bytes, to_fast(f), {reinterpret_cast<fast::State*>(states.data()), states.size()});
    return states;
  }
  Bytes force2(Level n, std::span<const std::uint8_t> bytes) const override {
    Bytes out = room(micro_triangles(n), Format::two_state);
    fast::force2(bytes, micro_triangles(n), out);
    return out;
  }
  Bytes widen(Level n, std::span<const std::uint8_t> bytes) const override {
    Bytes out = room(micro_triangles(n), Format::four_state);
    fast::widen(bytes, micro_triangles(n), out);
    return out;
  }
  Bytes up(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    Bytes out = room(micro_triangles(n + 1), f);
    fast::up(bytes, to_fast(f), micro_triangles(n), out);
    return out;
  }
  Bytes down(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    Bytes out = room(micro_triangles(n - 1), f);
    fast::down(bytes, to_fast(f), micro_triangles(n - 1), out);
    return out;
  }
  Bytes through(Level n, Mode mode, std::span<const std::uint8_t> bytes) const override {
    Bytes bits = room(micro_triangles(n), Format::two_state),
          out = room(micro_triangles(n), Format::four_state);
    fast::to_mode(bytes, micro_triangles(n), static_cast<fast::Mode>(mode), bits);
    fast::from_mode(bits, micro_triangles(n), static_cast<fast::Mode>(mode), out);
    return out;
  }
  std::uint32_t special_code(State s, Encoding e) const override {
    return fast::special_code(static_cast<fast::State>(s), static_cast<fast::Encoding>(e));
  }
  Meaning meaning(std::uint32_t code, Encoding e) const override {
    const auto encoding = static_cast<fast::Encoding>(e);
    if (const auto state = fast::special_state(code, encoding))
      return {Meaning::Kind::special, 0, static_cast<State>(*state)};
    return fast::is_index(code, encoding) ? Meaning{Meaning::Kind::index, code}
                                          : Meaning{Meaning::Kind::unknown};
  }
  Kept judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const override {
    const fast::Substitutions found = fast::substitutions(was, is, micro_triangles(n));
    return {found.allowed(), found.conservative(), found.force2_stable()};
  }
  Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps,
              const Options& options) const override {
    const auto views = [](std::span<const PackedMap> some) {
      std::vector<fast::PackedMap> out;
      for (const PackedMap& m : some) out.push_back({m.level, to_fast(m.format), m.bytes});
      return out;
    };
    fast::Array array;
    fast::append(array, views(before), {fast::Encoding::u32, 0, false, false});
    const fast::Geometry g = fast::append(array, views(maps),
                                          {static_cast<fast::Encoding>(options.encoding),
                                           options.base_triangle, options.deduplicate, options.special});
    return {fast::record_buffer(array.records), array.data, g.indices,
            to_slow(fast::usage_counts(array.records)), to_slow(g.counts)};
  }
  std::vector<Violation> validate(const Input& in) const override {
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
};

// ---------------------------------------------------------------------------------------------------------------------
// Lossy codecs: what is left of a map when four siblings that differ become alike
// ---------------------------------------------------------------------------------------------------------------------

using Merge = void (*)(std::span<State> siblings);

class Lossy final : public MicromapSubject {
 public:
  Lossy(std::string name, std::string about, Merge merge)
      : MicromapSubject(std::move(name), std::move(about)), merge_(merge) {}
  bool has(Entry e) const override { return e == Entry::substitute; }

  Bytes substitute(Level n, std::span<const std::uint8_t> bytes) const override {
    States states = slow::unpack(bytes, Format::four_state, micro_triangles(n));
    for (std::size_t k = 0; k + 4 <= states.size(); k += 4) {
      const std::span<State> siblings = std::span(states).subspan(k, 4);
      if (!slow::uniform(siblings)) merge_(siblings);
    }
    return slow::pack(states, Format::four_state);
  }

 private:
  Merge merge_;
};

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

}  // namespace

Bytes MicromapSubject::pack(Format, const States&) const { missing("pack"); }
States MicromapSubject::unpack(Format, std::uint64_t, std::span<const std::uint8_t>) const {
  missing("pack");
}
Bytes MicromapSubject::force2(Level, std::span<const std::uint8_t>) const { missing("force2"); }
Bytes MicromapSubject::widen(Level, std::span<const std::uint8_t>) const { missing("force2"); }
Bytes MicromapSubject::up(Level, Format, std::span<const std::uint8_t>) const { missing("levels"); }
Bytes MicromapSubject::down(Level, Format, std::span<const std::uint8_t>) const { missing("levels"); }
Bytes MicromapSubject::through(Level, Mode, std::span<const std::uint8_t>) const { missing("modes"); }
std::uint32_t MicromapSubject::special_code(State, Encoding) const { missing("special"); }
Meaning MicromapSubject::meaning(std::uint32_t, Encoding) const { missing("special"); }
Bytes MicromapSubject::substitute(Level, std::span<const std::uint8_t>) const { missing("substitute"); }
Kept MicromapSubject::judge(Level, std::span<const std::uint8_t>, std::span<const std::uint8_t>) const {
  missing("judge");
}
Built MicromapSubject::build(std::span<const PackedMap>, std::span<const PackedMap>, const Options&) const {
  missing("build");
}
std::vector<Violation> MicromapSubject::validate(const Input&) const { missing("validate"); }

const std::vector<MicromapSubjectPtr>& built_in_subjects() {
  static const std::vector<MicromapSubjectPtr> all{
      std::make_shared<Specified>(), std::make_shared<Fast>(),
      std::make_shared<Lossy>("lossy-stable", "siblings that differ become unknown, each on its own side",
                              own_unknown),
      std::make_shared<Lossy>("lossy-conservative",
                              "known siblings that differ become their majority's unknown",
                              majority_for_known),
      std::make_shared<Lossy>("lossy-merge", "siblings that differ all become their majority's unknown",
                              majority_for_all)};
  return all;
}

MicromapSubjectPtr the(const std::string& name) {
  for (const MicromapSubjectPtr& s : built_in_subjects())
    if (s->name() == name) return s;
  throw std::logic_error("no built-in subject of topic micromap named " + name);
}

}  // namespace mmverify::proofs::micromap
