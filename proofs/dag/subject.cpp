#include "proofs/dag/subject.hpp"

#include "impl/dag/container.hpp"
#include "proofs/points/exact_float.hpp"

namespace mmverify::proofs::dag {
namespace {

namespace fast = impl::dag;

// ---- The specification

Functions specified() {
  using spec::dag::Dag;
  Functions s;
  s.encode = [](const Scene& scene) {
    spec::dag::Builder builder(scene.format);
    for (const Map& map : scene.maps) builder.add(map.level, states_of(map, scene.format));
    return coded(scene.format, builder.dag());
  };
  s.decode = [](const Code& c) {
    const Dag& dag = form_of<Dag>(c);
    Scene scene{c.format, {}};
    for (std::size_t k = 0; k < dag.maps.size(); ++k)
      scene.maps.push_back({dag.maps[k].level, spec::micromap::pack(spec::dag::decode(dag, k), c.format)});
    return scene;
  };
  s.lookup = [](const Code& c, Numbers map, Numbers index, std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < state.size(); ++k)
      state[k] = spec::micromap::code(spec::dag::at_index(form_of<Dag>(c), map[k], index[k]));
  };
  s.point = [](const Code& c, Numbers map, std::span<const float> u, std::span<const float> v,
               std::span<std::uint8_t> state) {
    const Dag& dag = form_of<Dag>(c);
    for (std::size_t k = 0; k < state.size(); ++k) {
      const std::uint32_t index = points::on_exact(
          u[k], v[k], [&](const auto& p) { return spec::index::reference(p, dag.maps[map[k]].level); });
      state[k] = spec::micromap::code(spec::dag::at_index(dag, map[k], index));
    }
  };
  s.bytes = [](const Code& c) { return spec::dag::container(form_of<Dag>(c)); };
  s.open = [](Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    auto dag = spec::dag::from_container(bytes);
    if (!dag || dag->format != f) return std::nullopt;
    return coded(f, std::move(*dag));
  };
  s.writes_container = s.reads_container = true;
  return s;
}

// ---- The library

fast::Dag graph_of(const Scene& scene) {
  fast::Dag dag(static_cast<fast::Format>(bits(scene.format)));
  for (const Map& map : scene.maps) dag.add(map.level, map.packed);
  return dag;
}

Functions of_library() {
  using fast::Dag;
  Functions s;
  s.encode = [](const Scene& scene) { return coded(scene.format, graph_of(scene)); };
  s.decode = [](const Code& c) {
    const Dag& dag = form_of<Dag>(c);
    Scene scene{c.format, {}};
    for (std::uint32_t k = 0; k < dag.maps(); ++k) {
      const Level n = dag.level(k);
      Bytes map(spec::micromap::packed_bytes(spec::micromap::micro_triangles(n), c.format), 0xFF);
      dag.decode(k, map);
      scene.maps.push_back({n, std::move(map)});
    }
    return scene;
  };
  // One at a time and all at once must be the same.
  s.lookup = [](const Code& c, Numbers map, Numbers index, std::span<std::uint8_t> state) {
    const Dag& dag = form_of<Dag>(c);
    dag.lookup(map, index, state);
    for (std::size_t k = 0; k < state.size(); ++k)
      if (dag.at(map[k], index[k]) != state[k]) throw SubjectBroken("answers otherwise in a batch");
  };
  s.point = [](const Code& c, Numbers map, std::span<const float> u, std::span<const float> v,
               std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < state.size(); ++k) state[k] = form_of<Dag>(c).at_point(map[k], u[k], v[k]);
  };
  s.bytes = [](const Code& c) {
    Bytes bytes = fast::save(form_of<Dag>(c));
    if (8 * (bytes.size() - fast::container_header) != form_of<Dag>(c).bits())
      throw SubjectBroken("saves more or less than it says that it takes");
    return bytes;
  };
  s.open = [](Format f, std::span<const std::uint8_t> bytes) -> std::optional<Code> {
    try {
      Dag dag = fast::load(bytes);
      if (static_cast<std::uint32_t>(dag.format()) != bits(f)) return std::nullopt;
      return coded(f, std::move(dag));
    } catch (const fast::BadContainer&) {
      return std::nullopt;
    }
  };
  s.writes_container = s.reads_container = true;
  return s;
}

/// Saved and loaded after each map, so that each is added to what was loaded.
Functions loaded() {
  Functions s = of_library();
  s.encode = [](const Scene& scene) {
    fast::Dag dag(static_cast<fast::Format>(bits(scene.format)));
    for (const Map& map : scene.maps) {
      dag.add(map.level, map.packed);
      dag = fast::load(fast::save(dag));
    }
    return coded(scene.format, std::move(dag));
  };
  return s;
}

DagSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<DagSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<DagSubjectPtr>& built_in_subjects() {
  static const std::vector<DagSubjectPtr> all{
      subject("dag-spec", "the specification", specified()),
      subject("dag", "this project's library", of_library()),
      subject("dag-loaded", "this project's library, saved and loaded after each map", loaded())};
  return all;
}

}  // namespace mmverify::proofs::dag
