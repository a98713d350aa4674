#include "proofs/array/subject.hpp"

#include "impl/array/build.hpp"
#include "impl/array/change.hpp"
#include "impl/array/container.hpp"
#include "proofs/array/small_answers.hpp"

namespace mmverify::proofs::array {
namespace {

namespace fast = mmverify::impl::array;
namespace slow = mmverify::spec::array;
namespace maps = mmverify::spec::micromap;

std::vector<maps::Map> unpacked(std::span<const PackedMap> some) {
  std::vector<maps::Map> all;
  for (const PackedMap& m : some)
    all.push_back({m.level, m.format, maps::unpack(m.bytes, m.format, maps::micro_triangles(m.level))});
  return all;
}

Functions specified() {
  Functions f;
  f.build = [](const BuildCase& c) -> std::optional<Answer> {
    try {
      const slow::Built b = slow::build(unpacked(c.before), unpacked(c.maps), c.options);
      return Answer{maps::record_buffer(b.array.records),
                    b.array.data,
                    b.part.indices,
                    b.array_counts,
                    b.geometry_counts.value_or(std::vector<UsageCount>{}),
                    {}};
    } catch (const std::length_error&) {
      return std::nullopt;
    }
  };
  f.targets = [](const Reading& r, std::span<const Reference> references) {
    std::vector<Target> all;
    for (const Reference& of : references)
      all.push_back(slow::target(of.code, r.encoding, r.cluster, of.base, of.records));
    return all;
  };
  f.compact = slow::compacted;
  f.reorder = slow::reordered;
  f.concatenate = slow::concatenated;
  f.write = slow::written;
  f.read = slow::read;
  f.emulate = [](Level n, Level most, std::span<const std::uint8_t> bytes) {
    const States states = maps::unpack(bytes, Format::four_state, maps::micro_triangles(n));
    return maps::pack(slow::emulated({n, Format::four_state, states}, most).states, Format::four_state);
  };
  f.blocks = [](std::span<const std::uint32_t> codes) { return slow::blocks(codes); };
  f.small_arrays = small_arrays_of_subject();
  return f;
}

// ---- impl

fast::Encoding of(Encoding e) { return static_cast<fast::Encoding>(e); }

std::vector<fast::PackedMap> viewed(std::span<const PackedMap> some) {
  std::vector<fast::PackedMap> all;
  for (const PackedMap& m : some) all.push_back({m.level, static_cast<fast::Format>(m.format), m.bytes});
  return all;
}

std::vector<UsageCount> counts_of(const std::vector<fast::UsageCount>& counts) {
  std::vector<UsageCount> all;
  for (const fast::UsageCount& c : counts) all.push_back({c.count, c.level, c.format});
  return all;
}

fast::Bundle to_fast(const Bundle& b) {
  fast::Bundle out;
  for (const Record& r : b.array.records) out.array.records.push_back({r.offset, r.level, r.format});
  out.array.data = b.array.data;
  for (const Part& p : b.parts) out.parts.push_back({of(p.encoding), p.base, p.indices});
  return out;
}

Bundle to_slow(const fast::Bundle& b) {
  Bundle out;
  for (const auto& r : b.array.records) out.array.records.push_back({r.offset, r.level, r.format});
  out.array.data = b.array.data;
  for (const fast::Part& p : b.parts)
    out.parts.push_back({static_cast<Encoding>(p.encoding), p.base, p.indices});
  return out;
}

Functions library() {
  Functions f;
  f.build = [](const BuildCase& c) -> std::optional<Answer> {
    const BuildOptions& o = c.options;
    try {
      const fast::Built b =
          fast::build(viewed(c.before), viewed(c.maps),
                      {static_cast<fast::Api>(o.api), of(o.encoding), o.base, o.special, o.share, o.bound});
      return Answer{impl::micromap::record_buffer(b.array.records),
                    b.array.data,
                    b.part.indices,
                    counts_of(b.array_counts),
                    b.geometry_counts ? counts_of(*b.geometry_counts) : std::vector<UsageCount>{},
                    {}};
    } catch (const std::length_error&) {
      return std::nullopt;
    }
  };
  f.targets = [](const Reading& r, std::span<const Reference> references) {
    std::vector<Target> all;
    for (const Reference& one : references) {
      const fast::Target to = fast::target(one.code, of(r.encoding), r.cluster, one.base, one.records);
      all.push_back({static_cast<Target::Kind>(to.kind), static_cast<State>(to.state), to.record});
    }
    return all;
  };
  f.compact = [](const Bundle& b) { return to_slow(fast::compacted(to_fast(b))); };
  f.reorder = [](const Bundle& b) { return to_slow(fast::reordered(to_fast(b))); };
  f.concatenate = [](const Bundle& a, const Bundle& b) {
    return to_slow(fast::concatenated(to_fast(a), to_fast(b)));
  };
  f.write = [](const Bundle& b, std::uint32_t version) { return fast::written(to_fast(b), version); };
  f.read = [](std::span<const std::uint8_t> file) -> std::optional<Bundle> {
    try {
      return to_slow(fast::read(file));
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  };
  f.emulate = [](Level n, Level most, std::span<const std::uint8_t> bytes) {
    return fast::emulated(bytes, n, most);
  };
  f.blocks = [](std::span<const std::uint32_t> codes) { return fast::blocks(codes); };
  f.small_arrays = small_arrays_of_subject();
  return f;
}

}  // namespace

const std::vector<ArraySubjectPtr>& built_in_subjects() {
  static const std::vector<ArraySubjectPtr> all{
      std::make_shared<const ArraySubject>("array-spec", "spec/array: state by state", specified()),
      std::make_shared<const ArraySubject>("array", "impl/array", library())};
  return all;
}

}  // namespace mmverify::proofs::array
