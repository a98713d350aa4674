#include "proofs/array/answers.hpp"

#include <cstring>
#include <set>

#include "spec/micromap/level.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

States at_level(States states, Level from, Level to) {
  for (; from < to; ++from) states = maps::up(states);
  return states;
}

std::string text_of_counts(const maps::Histogram& h) {
  std::string line;
  for (const auto& [key, count] : h)
    line += fmt::format("{}{} of level {} format {}", line.empty() ? "" : ", ", count, key.first, key.second);
  return line.empty() ? "none" : line;
}

Finding answered(const Answer& a) { return {digest_of(a)}; }

Finding same_counts(const Answer& a, const maps::Histogram& expected, const std::vector<UsageCount>& got) {
  const maps::Histogram said = maps::histogram(got);
  return said == expected ? answered(a) : wrong(text_of_counts(expected), text_of_counts(said));
}

}  // namespace

std::string text_of(const Target& to) {
  switch (to.kind) {
    case Target::Kind::special: return fmt::format("special {}", maps::name_of(to.state));
    case Target::Kind::none: return "no micromap";
    case Target::Kind::record: return fmt::format("record {}", to.record);
    case Target::Kind::outside: return fmt::format("no record {}", to.record);
  }
  return fmt::format("kind {}", static_cast<unsigned>(to.kind));
}

Answer read_answer(std::span<const std::uint8_t> bytes) {
  Answer a;
  mmverify_array_answer_t head;
  if (bytes.size() < sizeof head) {
    a.malformed = fmt::format("{} bytes, fewer than the head has", bytes.size());
    return a;
  }
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::uint64_t counted =
      std::uint64_t{head.records} * maps::record_bytes +
      (std::uint64_t{head.array_counts} + head.geometry_counts) * sizeof(UsageCount) + head.index_bytes +
      head.data_bytes + sizeof head;
  if (counted != bytes.size()) {
    a.malformed = fmt::format("{} bytes, where the head has {}", bytes.size(), counted);
    return a;
  }
  std::size_t at = sizeof head;
  const auto take = [&](std::uint64_t count) {
    const auto part = bytes.subspan(at, static_cast<std::size_t>(count));
    at += part.size();
    return part;
  };
  const auto into_counts = [&](std::vector<UsageCount>& counts, std::uint32_t count) {
    const auto part = take(count * sizeof(UsageCount));
    counts.resize(count);
    if (count != 0) std::memcpy(counts.data(), part.data(), part.size());
  };
  const auto records = take(std::uint64_t{head.records} * maps::record_bytes);
  a.records.assign(records.begin(), records.end());
  into_counts(a.array_counts, head.array_counts);
  into_counts(a.geometry_counts, head.geometry_counts);
  const auto indices = take(head.index_bytes), data = take(head.data_bytes);
  a.indices.assign(indices.begin(), indices.end());
  a.data.assign(data.begin(), data.end());
  return a;
}

std::uint64_t record_count(const Answer& a) { return a.records.size() / maps::record_bytes; }

Target target_of(const Answer& a, const BuildCase& c, std::size_t t) {
  const Encoding e = c.options.encoding;
  return spec::array::target(maps::code_at(a.indices, e, maps::width(e) / 8, t), e, false, c.options.base,
                             static_cast<std::uint32_t>(record_count(a)));
}

ReadMap read_map(const Answer& a, std::uint64_t record) {
  ReadMap out;
  out.record = maps::record_at(a.records, record * maps::record_bytes);
  const Record& r = out.record;
  if ((r.format != 1 && r.format != 2) || r.level > 12) {
    out.unreadable = fmt::format("record {} of level {}, format {}", record, r.level, r.format);
    return out;
  }
  const Format f = static_cast<Format>(r.format);
  const std::uint64_t count = maps::micro_triangles(r.level), end = r.offset + maps::packed_bytes(count, f);
  if (end > a.data.size())
    out.unreadable = fmt::format("record {} ends at byte {} of {}", record, end, a.data.size());
  else
    out.states = maps::unpack(std::span(a.data).subspan(r.offset), f, count);
  return out;
}

std::optional<Finding> shape(const std::optional<Answer>& a, const BuildCase& c) {
  const std::uint64_t most = maps::index_limit(c.options.encoding);
  if (!a) {
    // The largest count of plain indices: one record a map, the base subtracted.
    const std::uint64_t indices = c.maps.size() + c.before.size() - c.options.base;
    if (indices <= most) return wrong("an array", "a refusal, though every index fits");
    if (!c.options.share && !c.options.special) return Finding{Hash().value()};
    Finding none;
    none.declined = true;
    return none;
  }
  if (!a->malformed.empty()) return wrong("an answer as the header has it", a->malformed);
  if (a->records.size() % maps::record_bytes != 0)
    return wrong("records of 8 bytes", fmt::format("{} bytes of them", a->records.size()));
  const std::uint64_t size = c.maps.size() * (maps::width(c.options.encoding) / 8);
  if (a->indices.size() != size)
    return wrong(fmt::format("{} bytes of indices", size), fmt::format("{}", a->indices.size()));
  return std::nullopt;
}

std::uint64_t digest_of(const Answer& a) {
  Hash hash;
  for (const Bytes* bytes : {&a.records, &a.data, &a.indices}) hash.numbers(*bytes);
  for (const auto* counts : {&a.array_counts, &a.geometry_counts})
    for (const UsageCount& u : *counts) {
      hash.number(u.count);
      hash.number(u.level << 2 | u.format);
    }
  return hash.value();
}

Finding resolves(const Answer& a, const BuildCase& c) {
  for (std::size_t t = 0; t < c.maps.size(); ++t) {
    const PackedMap& map = c.maps[t];
    const States baked = states_of(map);
    const Target to = target_of(a, c, t);
    States is = baked;
    Level level = map.level;
    if (to.kind == Target::Kind::special) {
      is.assign(baked.size(), to.state);
    } else if (to.kind == Target::Kind::record) {
      ReadMap read = read_map(a, to.record);
      if (!read.unreadable.empty()) return wrong(fmt::format("triangle {}: a map", t), read.unreadable);
      level = read.record.level;
      is = std::move(read.states);
    } else {
      return wrong(fmt::format("triangle {}: a map", t), text_of(to));
    }
    const Level finer = std::max(level, map.level);
    const States was = at_level(baked, map.level, finer);
    is = at_level(std::move(is), level, finer);
    std::uint64_t changed = 0;
    for (std::size_t i = 0; i < was.size(); ++i) {
      if (is[i] == was[i]) continue;
      // Merging may turn T and O into unknown states in 4-state maps, and changes nothing else.
      const bool allowed = c.options.bound > 0 && map.format == Format::four_state &&
                           !maps::unknown(was[i]) && maps::unknown(is[i]);
      if (!allowed)
        return wrong(fmt::format("triangle {} micro-triangle {}: {}{}", t, i, maps::name_of(was[i]),
                                 c.options.bound > 0 ? ", or more unknown" : ""),
                     maps::name_of(is[i]));
      ++changed;
    }
    if (changed > c.options.bound)
      return wrong(fmt::format("triangle {}: at most {} micro-triangles changed", t, c.options.bound),
                   fmt::format("{}", changed));
  }
  return answered(a);
}

Finding keeps_formats(const Answer& a, const BuildCase& c) {
  for (std::size_t t = 0; t < c.maps.size(); ++t) {
    const Target to = target_of(a, c, t);
    if (to.kind != Target::Kind::record) continue;
    const Record r = maps::record_at(a.records, to.record * maps::record_bytes);
    const PackedMap& map = c.maps[t];
    if (r.level != map.level || r.format != static_cast<std::uint16_t>(map.format))
      return wrong(
          fmt::format("triangle {}: level {}, format {}", t, map.level, static_cast<unsigned>(map.format)),
          fmt::format("level {}, format {}", r.level, r.format));
  }
  return answered(a);
}

Finding uses_special_indices(const Answer& a, const BuildCase& c) {
  for (std::size_t t = 0; t < c.maps.size(); ++t) {
    const auto state = maps::uniform(states_of(c.maps[t]));
    const Target to = target_of(a, c, t);
    if (state && c.options.special) {
      if (to != Target{Target::Kind::special, *state})
        return wrong(fmt::format("triangle {}: special {}", t, maps::name_of(*state)), text_of(to));
    } else if (to.kind == Target::Kind::special) {
      return wrong(fmt::format("triangle {}: a record", t), text_of(to));
    }
  }
  return answered(a);
}

Finding stays_in_range(const Answer& a, const BuildCase& c) {
  for (std::size_t t = 0; t < c.maps.size(); ++t)
    if (const Target to = target_of(a, c, t);
        to.kind == Target::Kind::outside || to.kind == Target::Kind::none)
      return wrong(
          fmt::format("triangle {}: index + {} below the {} records", t, c.options.base, record_count(a)),
          text_of(to));
  return answered(a);
}

Finding counts_records(const Answer& a, const BuildCase&) {
  maps::Histogram is;
  for (std::uint64_t r = 0; r < record_count(a); ++r) {
    const Record record = maps::record_at(a.records, r * maps::record_bytes);
    ++is[{record.level, record.format}];
  }
  return same_counts(a, is, a.array_counts);
}

Finding counts_references(const Answer& a, const BuildCase& c) {
  maps::Histogram is;
  if (spec::array::requirements(c.options.api).counts_geometry)
    for (std::size_t t = 0; t < c.maps.size(); ++t)
      if (const Target to = target_of(a, c, t); to.kind == Target::Kind::record) {
        const Record record = maps::record_at(a.records, to.record * maps::record_bytes);
        ++is[{record.level, record.format}];
      }
  return same_counts(a, is, a.geometry_counts);
}

Finding shares(const Answer& a, const BuildCase& c) {
  // Maps are equal if level, format and bytes are.
  using Key = std::tuple<Level, Format, Bytes>;
  std::set<Key> different;
  std::set<std::uint64_t> used;
  std::uint64_t plain = 0;
  for (std::size_t t = 0; t < c.maps.size(); ++t) {
    const Target to = target_of(a, c, t);
    if (to.kind != Target::Kind::record) continue;
    different.insert({c.maps[t].level, c.maps[t].format, c.maps[t].bytes});
    used.insert(to.record);
    ++plain;
  }
  const std::uint64_t expected = c.options.share ? different.size() : plain;
  if (used.size() != expected)
    return wrong(fmt::format("{} records in use", expected), fmt::format("{}", used.size()));
  // Every record that was not there before is in use.
  std::uint64_t added = 0;
  for (const std::uint64_t r : used) added += r >= c.before.size() ? 1 : 0;
  if (record_count(a) != c.before.size() + added)
    return wrong(fmt::format("{} records", c.before.size() + added), fmt::format("{}", record_count(a)));
  return answered(a);
}

Finding keeps_what_was_there(const Answer& a, const BuildCase& c) {
  for (std::size_t r = 0; r < c.before.size(); ++r) {
    const PackedMap& map = c.before[r];
    if (r >= record_count(a)) return wrong(fmt::format("record {} as before", r), "none");
    const ReadMap read = read_map(a, r);
    if (!read.unreadable.empty() || read.record.level != map.level ||
        read.record.format != static_cast<std::uint16_t>(map.format) || read.states != states_of(map))
      return wrong(fmt::format("record {} as before", r),
                   read.unreadable.empty() ? "another map" : read.unreadable);
  }
  return answered(a);
}

}  // namespace mmverify::proofs::array
