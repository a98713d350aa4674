#include "proofs/bake/mesh/mesh_judges.hpp"

#include "proofs/array/answers.hpp"
#include "proofs/bake/diagnosis/diagnosis.hpp"
#include "proofs/bake/laws/relation_judges.hpp"
#include "spec/micromap/level.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace maps = spec::micromap;

/// A triangle's index leads to a map, or to the state of all of the triangle at the level that it asks for.
struct Led {
  array::Target to;
  Level level = 0;
  std::vector<State> states;

  bool special() const { return to.kind == array::Target::Kind::special; }
};

/// The subject's answer for a mesh, read as a traversal reads it.
class MeshAnswer {
 public:
  struct Unreadable {
    Finding finding;
  };

  /// Throws Declined, and Unreadable where the answer has no index for each triangle.
  MeshAnswer(const BakeSubject& s, const MeshCase& mesh)
      : mesh_(mesh), build_(build_case(mesh)), answer_(s.functions.bake_mesh(mesh)) {
    if (!answer_) throw Declined();
    if (auto found = array::shape(answer_, build_)) throw Unreadable{*found};
  }

  const array::Answer& answer() const { return *answer_; }
  const array::BuildCase& as_built() const { return build_; }
  Finding right() const { return {array::digest_of(*answer_)}; }

  array::Target target(std::size_t triangle) const { return array::target_of(*answer_, build_, triangle); }

  /// Throws Unreadable where the index leads nowhere.
  Led led(std::size_t triangle) const {
    Led led{target(triangle), mesh_.level_of(triangle), {}};
    std::string unreadable;
    if (led.special()) {
      led.states.assign(maps::micro_triangles(led.level), led.to.state);
    } else if (led.to.kind == array::Target::Kind::record) {
      array::ReadMap read = array::read_map(*answer_, led.to.record);
      unreadable = std::move(read.unreadable);
      led.level = read.record.level;
      led.states = std::move(read.states);
    } else {
      unreadable = array::text_of(led.to);
    }
    if (!unreadable.empty()) throw Unreadable{wrong(fmt::format("triangle {}: a map", triangle), unreadable)};
    return led;
  }

  /// "triangle 1 (0,0 1,0 0,1), record 0 of level 3, which triangle 0 has, too".
  std::string place(std::size_t triangle) const {
    std::string text = fmt::format("triangle {} (", triangle);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto& [u, v] = mesh_.vertices[mesh_.triangles[triangle][corner]];
      text += fmt::format("{}{},{}", corner == 0 ? "" : " ", u, v);
    }
    const array::Target to = target(triangle);
    text += "), " + array::text_of(to);
    if (to.kind != array::Target::Kind::record) return text;
    text += fmt::format(" of level {}", array::read_map(*answer_, to.record).record.level);
    for (std::size_t other = 0; other < mesh_.triangles.size(); ++other)
      if (other != triangle && target(other) == to)
        return text + fmt::format(", which triangle {} has, too", other);
    return text;
  }

 private:
  const MeshCase& mesh_;
  array::BuildCase build_;
  std::optional<array::Answer> answer_;
};

/// A triangle with a state that a law denies, the map that its index leads to, and where its states were compared.
struct DeniedTriangle {
  std::size_t triangle = 0;
  Case one;
  Led led;
  std::vector<std::uint32_t> at;
  Truth truth;

  Offender offender(Denies denies) const {
    return offender_of(one, led.level, led.states, at, truth, denies).value();
  }
};

/// The first triangle with a denied state.  A special index without a level of its own is judged on the whole triangle.
std::optional<DeniedTriangle> denied_triangle(const BakeSubject& s, const MeshCase& mesh,
                                              const MeshAnswer& asked, Denies denies) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    DeniedTriangle d{t, on_triangle(mesh, t), asked.led(t), {}, {}};
    if (d.led.special() && (!unknown(d.led.to.state) || s.functions.own_levels)) {
      d.led.level = 0;
      d.led.states.resize(1);
    }
    d.at = judged_at(d.one, d.led.level);
    d.truth = true_states(d.one, d.led.level);
    for (std::size_t k = 0; k < d.at.size(); ++k)
      if (denies(d.led.states[d.at[k]], d.truth.lower[k], d.truth.upper[k])) return d;
  }
  return std::nullopt;
}

/// Whether a law denies a state of some triangle's map.
Finding denied_on_mesh(const BakeSubject& s, const MeshCase& mesh, Denies denies) {
  const MeshAnswer asked(s, mesh);
  const auto denied = denied_triangle(s, mesh, asked, denies);
  if (!denied) return asked.right();
  return wrong([d = *denied, denies, place = asked.place(denied->triangle)] {
    const Words words = words_of(d.one, d.led.level, d.offender(denies));
    return Words{place + ": " + words.expected, words.got};
  });
}

std::vector<State> at_level(std::vector<State> states, Level from, Level to) {
  for (; from < to; ++from) states = maps::up(states);
  return states;
}

/// The states of two maps at the higher one of their levels.
std::pair<std::vector<State>, std::vector<State>> side_by_side(const Led& a, const Led& b) {
  const Level level = std::max(a.level, b.level);
  return {at_level(a.states, a.level, level), at_level(b.states, b.level, level)};
}

/// Whether one micro-triangle cannot have both states, apart from the side of unknown ones.
bool exclude_each_other(const BakeSubject& s, State a, State b) {
  if (s.functions.tight && !s.functions.own_levels && unknown(a) != unknown(b)) return true;
  return a != b && !unknown(a) && !unknown(b);
}

/// The check, or what ends it.
template <class Check>
Finding on_answers(Check check) {
  try {
    return check();
  } catch (const Declined&) {
    return unsupported();
  } catch (const MeshAnswer::Unreadable& unreadable) {
    return unreadable.finding;
  }
}

/// Whether the bits behind the last state are zeros.
bool is_padded(const array::Answer& a, const array::Record& r) {
  const auto format = static_cast<maps::Format>(r.format);
  const std::uint64_t count = maps::micro_triangles(r.level), bits = count * maps::bits(format);
  return bits % 8 == 0 || a.data[r.offset + bits / 8] >> bits % 8 == 0;
}

/// A record that no array has, or one that overlaps an earlier one of other bytes, level or format.
std::optional<Finding> wrong_record(const array::Answer& a, const MeshCase& mesh) {
  struct Placed {
    array::Record record;
    std::uint64_t end;
  };
  std::vector<Placed> before;
  for (std::uint64_t r = 0; r < array::record_count(a); ++r) {
    const array::ReadMap map = array::read_map(a, r);
    if (!map.unreadable.empty()) return wrong("a record of a map in the data", map.unreadable);
    const auto format = static_cast<unsigned>(mesh.format);
    if (map.record.format != format)
      return wrong(fmt::format("record {} of format {}", r, format), fmt::format("{}", map.record.format));
    if (!is_padded(a, map.record))
      return wrong(fmt::format("record {}: zeros after the last state", r), "others");
    const std::uint64_t end =
        map.record.offset + maps::packed_bytes(maps::micro_triangles(map.record.level), mesh.format);
    for (std::size_t k = 0; k < before.size(); ++k)
      if (map.record != before[k].record && map.record.offset < before[k].end &&
          before[k].record.offset < end)
        return wrong(fmt::format("record {} apart from record {}, bytes {} to {}", r, k,
                                 before[k].record.offset, before[k].end),
                     fmt::format("bytes {} to {}", map.record.offset, end));
    before.push_back({map.record, end});
  }
  return std::nullopt;
}

}  // namespace

Finding mesh_is_conservative(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] { return denied_on_mesh(s, mesh, not_conservative); });
}

Finding mesh_is_tight(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] { return denied_on_mesh(s, mesh, not_tight); });
}

std::string drawn_mesh(const BakeSubject& s, const MeshCase& mesh, Denies denies) {
  try {
    const MeshAnswer asked(s, mesh);
    if (const auto denied = denied_triangle(s, mesh, asked, denies))
      return picture(denied->one, denied->led.level, denied->offender(denies));
    return picture(on_triangle(mesh, 0), mesh.level_of(0), std::nullopt);
  } catch (const Declined&) {
    return {};
  } catch (const MeshAnswer::Unreadable&) {
    return {};
  }
}

Finding mesh_is_as_alone(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] {
    const MeshAnswer asked(s, mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const MeshCase one = alone(mesh, t);
      const MeshAnswer by_itself(s, one);
      const auto [is, was] = side_by_side(asked.led(t), by_itself.led(0));
      for (std::size_t k = 0; k < is.size(); ++k)
        if (exclude_each_other(s, is[k], was[k]))
          return wrong(fmt::format("{}: micro-triangle {} {} as in a mesh of itself alone", asked.place(t), k,
                                   name_of(was[k])),
                       name_of(is[k]));
    }
    return asked.right();
  });
}

Finding mesh_in_both_formats(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] {
    MeshCase in_four = mesh, in_two = mesh;
    in_four.format = maps::Format::four_state;
    in_two.format = maps::Format::two_state;
    const MeshAnswer four(s, in_four), two(s, in_two);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [was, is] = side_by_side(four.led(t), two.led(t));
      for (std::size_t k = 0; k < is.size(); ++k)
        if (maps::force2(is[k]) != maps::force2(was[k]))
          return wrong(fmt::format("{}: micro-triangle {} {}, force-2-state of 4-state's {}", two.place(t), k,
                                   name_of(maps::force2(was[k])), name_of(was[k])),
                       name_of(is[k]));
    }
    return two.right();
  });
}

Finding mesh_has_records(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] {
    const MeshAnswer asked(s, mesh);
    if (auto found = wrong_record(asked.answer(), mesh)) return *found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Led led = asked.led(t);
      const Level wanted = mesh.level_of(t);
      if (led.level != wanted && !(s.functions.own_levels && led.level < wanted))
        return wrong(fmt::format("triangle {}: level {}", t, wanted), fmt::format("level {}", led.level));
    }
    return asked.right();
  });
}

Finding mesh_has_counts(const BakeSubject& s, const MeshCase& mesh) {
  return on_answers([&] {
    const MeshAnswer asked(s, mesh);
    for (const auto check : {array::counts_records, array::counts_references})
      if (Finding found = check(asked.answer(), asked.as_built()); !found.holds) return found;
    return asked.right();
  });
}

}  // namespace mmverify::proofs::bake
