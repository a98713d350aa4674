// Hits that blend, with accepted hits among them, in every order in which traversal may meet them.
#include <algorithm>
#include <set>

#include "proofs/engine/shape.hpp"
#include "proofs/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/law_groups.hpp"
#include "proofs/traverse/law_parts.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char fixed_functions[] =
    "Color and Attribute Micromaps, 4.3, figure 6; Vulkan, Ray Closest Hit Determination";

using spec::traverse::Colour;

/// How often traversal reports the hits of a scene.
enum class Reports { once, each_twice, all_again };
constexpr const char* reports_names[] = {"once", "each-twice", "all-again"};

/// One hit at each of the distances 1 to kinds.size(): A accepted, B blends.  `order`: the places in which they are met.
struct Scene {
  Operation operation = Operation::max;
  std::string kinds = {}, order = {};
  Reports reports = Reports::once;
};

std::string text_of_scene(const Scene& s) {
  return fmt::format("{},{},{},{}", name_of(s.operation), s.kinds, s.order,
                     reports_names[static_cast<unsigned>(s.reports)]);
}

/// A payload that every value changes, and values that all show in what is blended: farther ones are greater for max and
/// smaller for min, and no two sets of them have one sum.
Colour payload_of(Operation o) {
  return o == Operation::min ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 0};
}
Colour value_at(Operation o, std::uint32_t distance) {
  const auto code = static_cast<std::uint32_t>(o == Operation::min   ? 250 - 10 * distance
                                               : o == Operation::add ? 1u << distance
                                                                     : 10 * distance);
  return {code, 2 * code / 3, code / 2, code};
}

/// The hits as they are met.
std::vector<Hit> met(const Scene& s) {
  std::vector<Hit> hits;
  for (const char place : s.order) {
    const auto distance = static_cast<std::uint32_t>(place - '0');
    const Hit hit{distance, s.kinds[distance - 1] == 'A', value_at(s.operation, distance)};
    hits.push_back(hit);
    if (s.reports == Reports::each_twice) hits.push_back(hit);
  }
  if (s.reports == Reports::all_again) {
    const std::size_t count = hits.size();
    for (std::size_t k = 0; k < count; ++k) hits.push_back(hits[k]);
  }
  return hits;
}

constexpr Operation order_free_ones[] = {Operation::max, Operation::min, Operation::add};

/// The kinds of one to four hits: 2 + 4 + 8 + 16.
std::vector<std::string> all_kinds() {
  std::vector<std::string> all;
  for (std::size_t hits = 1; hits <= 4; ++hits)
    for (unsigned set = 0; set < 1u << hits; ++set) {
      std::string kinds;
      for (std::size_t k = 0; k < hits; ++k) kinds += (set >> k & 1) != 0 ? 'A' : 'B';
      all.push_back(kinds);
    }
  return all;
}

std::vector<std::string> orders_of(std::size_t hits) {
  std::string order = std::string("1234").substr(0, hits);
  std::vector<std::string> all;
  do all.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return all;
}

Cases<Scene> on_scenes(std::vector<Scene> list,
                       std::function<Finding(const TraverseSubject&, const Scene&)> check) {
  const auto scenes = std::make_shared<const std::vector<Scene>>(std::move(list));
  Cases<Scene> cases;
  cases.count = [scenes] { return std::uint64_t{scenes->size()}; };
  cases.number = [scenes](std::uint64_t k) { return (*scenes)[k]; };
  cases.text = text_of_scene;
  cases.read = [scenes](const std::string& at) {
    for (const Scene& s : *scenes)
      if (text_of_scene(s) == at) return s;
    throw BadCase(fmt::format("'{:.60}': write {}", at, text_of_scene(scenes->front())));
  };
  cases.check = std::move(check);
  cases.chunk = 64;
  return cases;
}

std::string codes_of_colour(const Colour& c) { return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]); }

/// A mutant that changes the hits before it gathers them, and one that changes what it gathered.
std::function<void(Functions&)> gathering(void (*change)(std::vector<Hit>&)) {
  return [change](Functions& f) {
    f.gather = [change, real = f.gather](Operation o, const Colour& payload, std::span<const Hit> hits) {
      std::vector<Hit> others(hits.begin(), hits.end());
      change(others);
      return real(o, payload, others);
    };
  };
}
std::function<void(Functions&)> gathered(void (*change)(std::span<const Hit>, Colour&)) {
  return spoils(&Functions::gather, [change](Operation, const Colour&, std::span<const Hit> hits,
                                             Colour& out) { change(hits, out); });
}

// ---------------------------------------------------------------------------------------------------------------------
// As they are met
// ---------------------------------------------------------------------------------------------------------------------

/// Where the first A has a B behind it.
bool blends_behind_an_accepted(const Scene& s) {
  const auto accepted = s.kinds.find('A');
  return accepted != std::string::npos && s.kinds.find('B', accepted) != std::string::npos;
}

Law accepted_hit() {
  std::vector<Scene> scenes;
  for (const Operation o : order_free_ones)
    for (const std::string& kinds : all_kinds())
      scenes.push_back({o, kinds, orders_of(kinds.size()).front(), Reports::once});
  return on_cases(
      {.id = "paper.blend_with_accepted_hit",
       .topic = "traverse",
       .says = "blended as they are met, hits depend on the order just where one lies behind an accepted "
               "hit, the paper's max "
               "as well as min and add: 1 of 4 scenes of two hits, 4 of 8 of three, 11 of 16 of four; the "
               "smallest is a "
               "hit that blends behind one that is accepted",
       .source = fixed_functions,
       .subjects = {"traverse-as-met"},
       .fast_seconds = 0.1,
       .domain = named_domain(
           "3 operations, all 30 kinds of one to four hits, each in all its orders; one payload, one value a "
           "distance"),
       .mutants = {mutant("accepted hits hide nothing", "traverse-as-met",
                          gathering([](std::vector<Hit>& hits) {
                            std::erase_if(hits, [](const Hit& h) { return h.accepted; });
                          })),
                   mutant("hits are sorted first", "traverse-as-met", gathering([](std::vector<Hit>& hits) {
                            std::sort(hits.begin(), hits.end(),
                                      [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
                          })),
                   mutant("the first met is never blended", "traverse-as-met",
                          gathering([](std::vector<Hit>& hits) {
                            if (!hits.front().accepted) hits.erase(hits.begin());
                          }))},
       .general = false},
      {entry::gather}, on_scenes(std::move(scenes), [](const TraverseSubject& s, const Scene& scene) {
        std::set<Colour> payloads;
        for (const std::string& order : orders_of(scene.kinds.size()))
          payloads.insert(s.functions.gather(scene.operation, payload_of(scene.operation),
                                             met({scene.operation, scene.kinds, order, scene.reports})));
        const bool depends = blends_behind_an_accepted(scene);
        if ((payloads.size() > 1) == depends)
          return Finding{word_of(*payloads.begin()) + std::uint64_t{payloads.size()} + 1};
        std::vector<std::string> all;
        for (const Colour& c : payloads) all.push_back(codes_of_colour(c));
        return wrong(depends ? "several payloads" : "one payload", fmt::format("{}", fmt::join(all, ", ")));
      }));
}

// ---------------------------------------------------------------------------------------------------------------------
// Before the closest
// ---------------------------------------------------------------------------------------------------------------------

/// The blends before the first A, by distance, one at a time.
Colour expected_of(const Scene& s) {
  Colour payload = payload_of(s.operation);
  for (std::uint32_t distance = 1; distance <= s.kinds.size() && s.kinds[distance - 1] == 'B'; ++distance)
    payload = spec::traverse::blend(s.operation, payload, value_at(s.operation, distance));
  return payload;
}

Law before_closest() {
  std::vector<Scene> scenes;
  for (const Operation o : order_free_ones)
    for (const std::string& kinds : all_kinds())
      for (const std::string& order : orders_of(kinds.size()))
        for (const Reports reports : {Reports::once, Reports::each_twice, Reports::all_again})
          if (o != Operation::add || reports == Reports::once) scenes.push_back({o, kinds, order, reports});
  return on_cases(
      {.id = "traverse.blend_before_closest",
       .topic = "traverse",
       .says = "where blending waits for the closest accepted hit, exactly the hits before it are blended, "
               "in any order: one "
               "payload for max, min and add; for max and min also where hits are reported twice",
       .source = fixed_functions,
       .subjects = {"traverse-spec", "traverse"},
       .fast_seconds = 0.1,
       .domain = named_domain("all kinds and orders of one to four hits, 442; max and min reported in three "
                              "ways, add in one; one "
                              "payload, one value a distance"),
       .mutants = {mutant("a blend at the far end stays where it is met first", "traverse",
                          gathered([](std::span<const Hit> hits, Colour& out) {
                            if (hits.size() == 4 && hits[0].distance == 4 && !hits[0].accepted)
                              out = spec::traverse::blend(Operation::max, out, hits[0].value);
                          })),
                   mutant("the farthest accepted hit is taken for the closest", "traverse-spec",
                          gathering([](std::vector<Hit>& hits) {
                            std::uint32_t farthest = 0;
                            for (const Hit& h : hits)
                              if (h.accepted) farthest = std::max(farthest, h.distance);
                            std::erase_if(hits,
                                          [&](const Hit& h) { return h.accepted && h.distance < farthest; });
                          })),
                   mutant("a hit met third is lost", "traverse", gathering([](std::vector<Hit>& hits) {
                            if (hits.size() > 2) hits.erase(hits.begin() + 2);
                          }))}},
      {entry::gather}, on_scenes(std::move(scenes), [](const TraverseSubject& s, const Scene& scene) {
        const Colour right = expected_of(scene),
                     got = s.functions.gather(scene.operation, payload_of(scene.operation), met(scene));
        if (got == right) return Finding{word_of(got) + std::uint64_t{1}};
        return wrong(codes_of_colour(right), codes_of_colour(got));
      }));
}

}  // namespace

std::vector<Law> order_laws() { return {accepted_hit(), before_closest()}; }

}  // namespace mmverify::proofs::traverse
