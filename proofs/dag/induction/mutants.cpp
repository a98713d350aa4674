#include "proofs/dag/induction/lemmas.hpp"
#include "proofs/dag/induction/provable.hpp"
#include "proofs/dag/induction/rules.hpp"

namespace mmverify::proofs::dag::induction {
namespace {

/// Graphs built, and states found, by the rules.
template <class Rules>
Functions functions_by_rules() {
  using spec::dag::Dag;
  Functions f;
  f.encode = [](const Scene& scene) {
    spec::dag::BuilderBy<Rules> builder(scene.format);
    for (const Map& map : scene.maps) builder.add(map.level, states_of(map, scene.format));
    return coded(scene.format, builder.dag());
  };
  const auto state = [](const Dag& dag, std::uint64_t map, std::uint64_t index) {
    constexpr std::uint8_t nothing = 0xFF;
    try {
      return spec::micromap::code(spec::dag::at_index_by(
          [](const auto& store, auto& at, const auto& next) { return Rules::lookup_turn(store, at, next); },
          dag, map, index));
    } catch (const std::out_of_range&) {
      return nothing;  // wrong rules read beyond
    }
  };
  f.lookup = [state](const Code& c, Numbers map, Numbers index, std::span<std::uint8_t> states) {
    for (std::size_t k = 0; k < states.size(); ++k) states[k] = state(form_of<Dag>(c), map[k], index[k]);
  };
  f.decode = [state](const Code& c) {
    const Dag& dag = form_of<Dag>(c);
    Scene scene{c.format, {}};
    for (std::size_t m = 0; m < dag.maps.size(); ++m) {
      States states;
      for (std::uint64_t k = 0; k < spec::micromap::micro_triangles(dag.maps[m].level); ++k)
        states.push_back(static_cast<State>(state(dag, m, k) & 3));
      scene.maps.push_back({dag.maps[m].level, spec::micromap::pack(states, c.format)});
    }
    return scene;
  };
  f.bytes = [](const Code& c) { return spec::dag::container(form_of<Dag>(c)); };
  f.writes_container = true;
  return f;
}

/// Altered rules, run on maps and in the statements where they take the right ones' place.
template <class Rules>
class Wrong : public DagSubject, public Provable {
 public:
  explicit Wrong(const std::string& name)
      : DagSubject(name, "broken on purpose", functions_by_rules<Rules>()) {}
  std::vector<Statement> statements() const override { return all_levels_statements<Rules>(); }
};

template <class Rules>
Mutant wrong(const char* name) {
  return {name, std::make_shared<Wrong<Rules>>(name), {3, 4}};
}

struct LastChildNotLookedAt : Specified {
  template <class Part, class Stored>
  static Part parent(std::span<const Part> children, const Stored& stored) {
    const auto all = [&](std::span<const Part>) { return stored(children); };
    return Specified::parent(children.first(children.size() - 1), all);
  }
};

struct NothingMerges : Specified {
  template <class Part, class Stored>
  static Part parent(std::span<const Part> children, const Stored& stored) {
    return stored(children);
  }
};

struct MixedChildrenAreOne : Specified {
  template <class Part, class Stored>
  static Part parent(std::span<const Part> children, const Stored& stored) {
    for (const Part& child : children)
      if (!(child == children[0])) return stored(children);
    return children[0];
  }
};

struct NextDigitIsOneMore : Specified {
  template <class Store, class Part, class NextDigit>
  static bool lookup_turn(const Store& store, Part& at, const NextDigit& next_digit) {
    const auto one_more = [&] { return next_digit() + 1; };
    return Specified::lookup_turn(store, at, one_more);
  }
};

struct KeepsTwiceAsMuch : Specified {
  template <class Count>
  static bool kept(const Count& grown, const Count& flat) {
    return Specified::kept(grown, flat + flat);
  }
};

struct KeepsAWordMore : Specified {
  template <class Count>
  static bool kept(const Count& grown, const Count& flat) {
    return Specified::kept(grown, flat + 1);
  }
};

}  // namespace

std::vector<Statement> shipped_all_levels() { return all_levels_statements<Specified>(); }

std::vector<Mutant> mutants_of_all_levels() {
  return {wrong<LastChildNotLookedAt>("the last child is not looked at"),
          wrong<NothingMerges>("nothing is of one state"),
          wrong<MixedChildrenAreOne>("equal children that are mixed stand for their parent"),
          wrong<NextDigitIsOneMore>("the digit after the next is taken"),
          wrong<KeepsTwiceAsMuch>("nodes are kept up to twice the flat map"),
          wrong<KeepsAWordMore>("nodes are kept that take a word more than the flat map")};
}

DagSubjectPtr specified_by_rules() {
  return std::make_shared<DagSubject>("dag-spec-by-rules", "the specification's rules",
                                      functions_by_rules<Specified>());
}

}  // namespace mmverify::proofs::dag::induction
