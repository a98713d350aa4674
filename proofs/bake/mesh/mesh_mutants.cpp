#include "proofs/bake/mesh/mesh_mutants.hpp"

#include <cmath>

#include "proofs/array/answers.hpp"
#include "proofs/bake/mesh/mesh_baker.hpp"
#include "proofs/engine/spoils.hpp"
#include "spec/micromap/level.hpp"

namespace mmverify::proofs::bake {
namespace {

using UvCorner = std::array<float, 2>;
using UvCorners = std::array<UvCorner, 3>;

UvCorners corners_on(const MeshCase& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Whether a baker of meshes takes one triangle's map for another's.
using Likens = bool (*)(const MeshCase&, const UvCorners&, const UvCorners&);

/// The first triangle of the same level that is taken for this one; itself if none is.
std::size_t taken_for(const MeshCase& mesh, std::size_t triangle, Likens likens) {
  const UvCorners corners = corners_on(mesh, triangle);
  for (std::size_t other = 0; other < triangle; ++other)
    if (mesh.level_of(other) == mesh.level_of(triangle) && likens(mesh, corners_on(mesh, other), corners))
      return other;
  return triangle;
}

/// Whether a triangle's level is 4 or more, which a test of low levels misses.
bool is_fine(const MeshCase& mesh, std::size_t triangle) { return mesh.level_of(triangle) >= 4; }

/// This project's maps, in which `states` of a triangle, given its own ones, take its map's place.
using States =
    std::function<std::vector<State>(const StatesOfTriangle& own, const MeshCase&, std::size_t triangle)>;
Mutant with_states(const char* name, Levels levels, const States& states,
                   const array::BuildOptions& options = {}) {
  return mutant(name, "bake", levels, [&](Functions& functions) {
    functions.bake_mesh = [own = own_states(functions), states, options](const MeshCase& mesh) {
      return mesh_array(
          "array", mesh,
          [&](const MeshCase& of, std::size_t t) -> std::optional<std::vector<State>> {
            if (!own(of, t)) return std::nullopt;
            return states(own, of, t);
          },
          options);
    };
  });
}

/// A triangle has the map of the first one that it is taken for.
Mutant sharing(const char* name, Levels levels, Likens likens) {
  return with_states(name, levels,
                     [likens](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                       return own(mesh, taken_for(mesh, t, likens)).value();
                     });
}

/// An array of this project's, with something wrong.
Mutant with_answer(const char* name, Levels levels, void (*spoil)(const MeshCase&, array::Answer&)) {
  return mutant(name, "bake", levels,
                spoils(&Functions::bake_mesh, [spoil](const MeshCase& mesh, auto& answer) {
                  if (answer) spoil(mesh, *answer);
                }));
}

bool alike(const MeshCase&, const UvCorners& a, const UvCorners& b) { return a == b; }
/// Equal in steps of a quarter of a texel.
bool alike_in_quarters(const MeshCase& mesh, const UvCorners& a, const UvCorners& b) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto steps = 4 * static_cast<float>(axis == 0 ? mesh.surface.width : mesh.surface.height);
      if (std::round(a[corner][axis] * steps) != std::round(b[corner][axis] * steps)) return false;
    }
  return true;
}
/// The same three corners, begun at another.
bool alike_but_turned(const MeshCase&, const UvCorners& a, const UvCorners& b) {
  return a == b || a == UvCorners{b[1], b[2], b[0]} || a == UvCorners{b[2], b[0], b[1]};
}
/// The same three corners, two of them exchanged.
bool alike_but_rewound(const MeshCase&, const UvCorners& a, const UvCorners& b) {
  return a == b || a == UvCorners{b[0], b[2], b[1]} || a == UvCorners{b[1], b[0], b[2]};
}
/// Equal but for whole numbers, as if every texture repeated.
bool alike_in_repeats(const MeshCase&, const UvCorners& a, const UvCorners& b) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const float apart = a[corner][axis] - b[corner][axis];
      if (apart != std::floor(apart) || std::fabs(apart) > 4) return false;
    }
  return true;
}
bool alike_in_u(const MeshCase&, const UvCorners& a, const UvCorners& b) {
  return a[0][0] == b[0][0] && a[1][0] == b[1][0] && a[2][0] == b[2][0];
}
/// Equal but for a hair.
bool alike_in_half_precision(const MeshCase&, const UvCorners& a, const UvCorners& b) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (std::fabs(a[corner][axis] - b[corner][axis]) > 0x1p-10f) return false;
  return true;
}

/// Words of the answer's records.
std::uint8_t* record_bytes_at(array::Answer& a, std::size_t record) {
  return a.records.data() + spec::micromap::record_bytes * record;
}

}  // namespace

std::vector<Mutant> conservative_mesh_mutants() {
  const Levels all{0, 4};
  return {
      sharing("coordinates that are equal in quarters of a texel share a map", all, alike_in_quarters),
      sharing("a triangle shares the map of the one that it is turned from", {1, 4}, alike_but_turned),
      sharing("a triangle shares the map of the one that it is rewound from", {1, 4}, alike_but_rewound),
      sharing("whole repeats away is the same, however it is addressed", all, alike_in_repeats),
      with_states("from level 4 on u alone is compared", {4, 4},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    return own(mesh, is_fine(mesh, t) ? taken_for(mesh, t, alike_in_u) : t).value();
                  }),
      with_states("a sharer has the special index of a map that was never baked", all,
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    if (taken_for(mesh, t, alike) != t) std::fill(states.begin(), states.end(), State::T);
                    return states;
                  }),
      with_states("an unknown triangle beside an opaque one is opaque", {0, 0},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    if (t > 0 && states.front() == State::UO && own(mesh, t - 1)->front() == State::O)
                      states.front() = State::O;
                    return states;
                  }),
  };
}

std::vector<Mutant> tight_mesh_mutants() {
  array::BuildOptions joining;
  joining.bound = 2;
  return {
      with_states(
          "maps that differ in two micro-triangles are joined", {1, 4},
          [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
            return own(mesh, t).value();
          },
          joining),
      with_states("from level 4 on maps are baked a level lower", {4, 4},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    if (!is_fine(mesh, t)) return own(mesh, t).value();
                    MeshCase lower = mesh;
                    lower.level = mesh.level_of(t) - 1;
                    lower.levels.clear();
                    return spec::micromap::up(own(lower, t).value());
                  }),
      with_states("a triangle that is turned from another is unknown", {0, 4},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    const std::size_t other = taken_for(mesh, t, alike_but_turned);
                    if (corners_on(mesh, other) != corners_on(mesh, t))
                      std::fill(states.begin(), states.end(), State::UO);
                    return states;
                  }),
      with_states("the ninth triangle's map is that of a special index, UT", {0, 4},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    if (t == 8) std::fill(states.begin(), states.end(), State::UT);
                    return states;
                  }),
  };
}

std::vector<Mutant> shared_mesh_mutants() {
  const Levels all{0, 4};
  return {
      sharing("coordinates that are equal but for a hair share a map", all, alike_in_half_precision),
      sharing("coordinates that are equal in quarters of a texel share a map", all, alike_in_quarters),
      sharing("a triangle shares the map of the one that it is rewound from", {1, 4}, alike_but_rewound),
      with_states("from level 4 on the sixth triangle has the fifth one's map", {4, 4},
                  [](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    const bool is_sixth = t == 5 && is_fine(mesh, t) && mesh.level_of(4) == mesh.level_of(5);
                    return own(mesh, is_sixth ? 4 : t).value();
                  }),
  };
}

std::vector<Mutant> two_state_mesh_mutants() {
  const auto in_two = [](const MeshCase& mesh) { return mesh.format == spec::micromap::Format::two_state; };
  return {
      with_states("in 2-state the last triangle's unknown states are T", {0, 4},
                  [in_two](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    if (!in_two(mesh) || t + 1 != mesh.triangles.size()) return states;
                    MeshCase four = mesh;
                    four.format = spec::micromap::Format::four_state;
                    const auto known = own(four, t).value();
                    for (std::size_t k = 0; k < states.size(); ++k)
                      if (unknown(known[k])) states[k] = State::T;
                    return states;
                  }),
      with_states("from level 4 on, in 2-state, coordinates in quarters of a texel share a map", {4, 4},
                  [in_two](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    const bool shares = in_two(mesh) && is_fine(mesh, t);
                    return own(mesh, shares ? taken_for(mesh, t, alike_in_quarters) : t).value();
                  }),
      with_states("in 2-state a sharer has a special index", {0, 4},
                  [in_two](const StatesOfTriangle& own, const MeshCase& mesh, std::size_t t) {
                    auto states = own(mesh, t).value();
                    if (in_two(mesh) && taken_for(mesh, t, alike) != t)
                      std::fill(states.begin(), states.end(), State::T);
                    return states;
                  }),
  };
}

std::vector<Mutant> record_mesh_mutants() {
  const Levels all{0, 4};
  return {
      with_answer("the bits behind the states of level 0 are set", {0, 4},
                  [](const MeshCase& mesh, array::Answer& a) {
                    for (std::uint64_t r = 0; r < array::record_count(a); ++r) {
                      const array::Record record = array::read_map(a, r).record;
                      const unsigned bits = static_cast<unsigned>(mesh.format) << 2 * record.level;
                      if (bits < 8) a.data[record.offset] |= static_cast<std::uint8_t>(0xff << bits);
                    }
                  }),
      with_answer("from level 4 on the data lacks its last byte", {4, 4},
                  [](const MeshCase& mesh, array::Answer& a) {
                    if (!a.data.empty() && is_fine(mesh, mesh.triangles.size() - 1)) a.data.pop_back();
                  }),
      with_answer("the second record begins a byte early", {2, 4},
                  [](const MeshCase&, array::Answer& a) {
                    if (array::record_count(a) > 1) --*record_bytes_at(a, 1);
                  }),
      with_answer("the last record says 4-state", all,
                  [](const MeshCase& mesh, array::Answer& a) {
                    if (mesh.format == spec::micromap::Format::two_state && !a.records.empty())
                      *(record_bytes_at(a, array::record_count(a)) - 2) = 2;
                  }),
      mutant("all triangles have the first one's level", "bake", {1, 4},
             [](Functions& functions) {
               functions.bake_mesh = [real = functions.bake_mesh](const MeshCase& mesh) {
                 MeshCase other = mesh;
                 if (!mesh.levels.empty()) other.levels.assign(mesh.levels.size(), mesh.levels.front());
                 return real(other);
               };
             }),
      with_answer("the last index is one too high", all,
                  [](const MeshCase& mesh, array::Answer& a) {
                    const array::BuildCase c = build_case(mesh);
                    const std::size_t last = mesh.triangles.size() - 1;
                    if (array::target_of(a, c, last).kind != array::Target::Kind::record) return;
                    ++a.indices[a.indices.size() - spec::micromap::width(mesh.encoding) / 8];
                  }),
  };
}

std::vector<Mutant> count_mesh_mutants() {
  const Levels all{0, 4};
  return {
      with_answer("the array's counts are the geometry's", all,
                  [](const MeshCase&, array::Answer& a) {
                    if (!a.geometry_counts.empty()) a.array_counts = a.geometry_counts;
                  }),
      with_answer("the geometry's counts are the array's", all,
                  [](const MeshCase&, array::Answer& a) {
                    if (!a.geometry_counts.empty()) a.geometry_counts = a.array_counts;
                  }),
      with_answer("special indices count as references", all,
                  [](const MeshCase& mesh, array::Answer& a) {
                    const array::BuildCase c = build_case(mesh);
                    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                      if (!a.geometry_counts.empty() &&
                          array::target_of(a, c, t).kind == array::Target::Kind::special)
                        ++a.geometry_counts.front().count;
                  }),
      with_answer("there are counts of the geometry for DXR", all,
                  [](const MeshCase& mesh, array::Answer& a) {
                    if (mesh.api == array::Api::DXR) a.geometry_counts = a.array_counts;
                  }),
      with_answer("all records of level 4 count for the first one's level", {4, 4},
                  [](const MeshCase&, array::Answer& a) {
                    for (auto& one : a.array_counts)
                      if (one.level == 4) one.level = a.array_counts[0].level;
                  }),
  };
}

}  // namespace mmverify::proofs::bake
