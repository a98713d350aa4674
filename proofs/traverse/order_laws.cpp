// Laws of hits that blend, with accepted hits among them, in every order in which traversal may meet them.
#include <numeric>
#include <set>

#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/laws.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char fixed_functions[] =
    "Color and Attribute Micromaps, 4.3, figure 6; Vulkan, Ray Closest Hit Determination";

using spec::traverse::Colour;

/// How often traversal reports the hits of a scene.
enum class Reports { once, each_twice, all_again };
constexpr const char* reports_names[] = {"once", "each-twice", "all-again"};

/// The order of the values' codes by distance, and at one distance by the order of the hits: rising or falling.  With
/// `mixed` each channel has an order of its own, and for add every sum differs.
enum class Values { rising, falling, mixed };
constexpr const char* values_names[] = {"rising", "falling", "mixed"};

/// The payload before any hit.
enum class Before { neutral, coloured };
constexpr const char* before_names[] = {"neutral", "coloured"};

/// Hits in the order in which traversal meets them.  Each is a letter, A for accepted and B for blending, and a
/// distance, 1 to 4, which several may share.
struct Scene {
  Operation operation = Operation::max;
  std::string hits = {};
  Reports reports = Reports::once;
  Values values = Values::rising;
  Before before = Before::neutral;
  std::size_t count() const { return hits.size() / 2; }
  bool accepted(std::size_t k) const { return hits[2 * k] == 'A'; }
  std::uint32_t distance(std::size_t k) const {
    return distance_of(static_cast<float>(hits[2 * k + 1] - '0'));
  }
};

std::string text_of_scene(const Scene& s) {
  return fmt::format(
      "{},{},{},{},{}", name_of(s.operation), s.hits, reports_names[static_cast<unsigned>(s.reports)],
      values_names[static_cast<unsigned>(s.values)], before_names[static_cast<unsigned>(s.before)]);
}

Colour payload_of(const Scene& s) {
  const bool bright = s.operation == Operation::min || s.operation == Operation::multiply;
  if (s.before == Before::neutral) return bright ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 0};
  return bright ? Colour{254, 253, 252, 251} : Colour{9, 8, 7, 6};
}

/// The value of the k-th of `count` hits, sorted by distance and then by the order of the hits.
Colour value_of(const Scene& s, std::size_t k, std::size_t count) {
  constexpr std::array<std::array<std::uint32_t, 4>, 4> orders{
      {{0, 1, 2, 3}, {2, 0, 3, 1}, {1, 3, 0, 2}, {3, 2, 1, 0}}};
  Colour value{};
  for (std::size_t c = 0; c < value.size(); ++c) {
    std::uint32_t place = static_cast<std::uint32_t>(k);
    if (s.values == Values::falling) place = static_cast<std::uint32_t>(count - 1 - k);
    if (s.values == Values::mixed) place = orders[c][k];
    // No two sets of hits have the same sum, and no product or mean has a code twice.
    value[c] = s.operation == Operation::add ? (1u << (place + 1)) + (c == 3 ? 1 : 0)
                                             : 20 + 50 * place + static_cast<std::uint32_t>(c);
  }
  return value;
}

/// The hits of a scene, once each.
std::vector<Hit> hits_of(const Scene& s) {
  std::vector<std::size_t> nearest(s.count());
  std::iota(nearest.begin(), nearest.end(), std::size_t{0});
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&s](std::size_t a, std::size_t b) { return s.distance(a) < s.distance(b); });
  std::vector<Hit> hits(s.count());
  for (std::size_t place = 0; place < nearest.size(); ++place) {
    const std::size_t k = nearest[place];
    hits[k] = {s.distance(k), s.accepted(k), value_of(s, place, s.count())};
  }
  return hits;
}

/// The hits as traversal reports them.
std::vector<Hit> reported(const Scene& s, const std::vector<Hit>& hits) {
  std::vector<Hit> all;
  for (const Hit& hit : hits) {
    all.push_back(hit);
    if (s.reports == Reports::each_twice) all.push_back(hit);
  }
  if (s.reports == Reports::all_again) {
    const std::size_t count = all.size();
    for (std::size_t k = 0; k < count; ++k) all.push_back(all[k]);
  }
  return all;
}

constexpr Operation order_free_ones[] = {Operation::max, Operation::min, Operation::add};

/// Lists of one to four hits in the order of traversal, each of either kind at a distance of 1 to their number: 2 +
/// 16 + 216 + 4096.  They contain every order of every such scene.
std::vector<std::string> make_lists() {
  std::vector<std::string> all;
  for (std::size_t hits = 1; hits <= 4; ++hits) {
    std::size_t count = 1;
    for (std::size_t k = 0; k < hits; ++k) count *= 2 * hits;
    for (std::size_t number = 0; number < count; ++number) {
      std::string list;
      std::size_t rest = number;
      for (std::size_t k = 0; k < hits; ++k, rest /= 2 * hits) {
        list += rest % 2 != 0 ? 'A' : 'B';
        list += static_cast<char>('1' + rest / 2 % hits);
      }
      all.push_back(list);
    }
  }
  return all;
}

const std::vector<std::string>& all_lists() {
  static const std::vector<std::string> all = make_lists();
  return all;
}

/// The lists sorted by distance that use every distance up to their last: one list for each scene.
const std::vector<std::string>& sorted_lists() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> some;
    for (const std::string& list : all_lists()) {
      bool sorted = list[1] == '1';
      for (std::size_t k = 3; k < list.size(); k += 2)
        sorted = sorted && (list[k] == list[k - 2] || list[k] == list[k - 2] + 1);
      if (sorted) some.push_back(list);
    }
    return some;
  }();
  return all;
}

/// The cases of each of the `frames` with each of the lists.
Cases<Scene> on_scenes(std::vector<Scene> frames, const std::vector<std::string>& (*lists)(),
                       std::function<Finding(const TraverseSubject&, const Scene&)> check) {
  const auto number = [frames, lists](std::uint64_t k) {
    Scene scene = frames[k / lists().size()];
    scene.hits = lists()[k % lists().size()];
    return scene;
  };
  const auto count = [frames, lists] { return std::uint64_t{frames.size()} * lists().size(); };
  Cases<Scene> cases;
  cases.count = count;
  cases.number = number;
  cases.text = text_of_scene;
  cases.read = [number, count](const std::string& at) {
    for (std::uint64_t k = 0; k < count(); ++k)
      if (const Scene s = number(k); at.find(s.hits) != std::string::npos && text_of_scene(s) == at) return s;
    throw BadCase(fmt::format("'{:.60}': write {}", at, text_of_scene(number(0))));
  };
  cases.check = std::move(check);
  cases.chunk = 256;
  return cases;
}

/// Whether a B lies behind the nearest A, or at its distance.
bool blends_behind_an_accepted(const Scene& s) {
  std::uint32_t nearest = ~0u;
  for (std::size_t k = 0; k < s.count(); ++k)
    if (s.accepted(k)) nearest = std::min(nearest, s.distance(k));
  for (std::size_t k = 0; k < s.count(); ++k)
    if (!s.accepted(k) && s.distance(k) >= nearest) return true;
  return false;
}

Law accepted_hit() {
  std::vector<Scene> frames;
  // The hit behind must show: its codes are the greatest, or for min the least.
  for (const Operation o : order_free_ones)
    for (const Before before : {Before::neutral, Before::coloured})
      frames.push_back(
          {o, {}, Reports::once, o == Operation::min ? Values::falling : Values::rising, before});
  return on_cases(
      {.id = "paper.blend_with_accepted_hit",
       .says = "blended as they are met, hits depend on the order just where one lies behind an accepted "
               "hit, or at its distance, the paper's max as well as min and add: of scenes of different "
               "distances 1 of 4 of two hits, 4 of 8 of three, 11 of 16 of four; the smallest is a hit that "
               "blends behind one that is accepted",
       .source = fixed_functions,
       .subjects = {"traverse-as-met"},
       .tiers = {.seconds = 0.1},
       .domain = "3 operations, all 170 scenes of one to four hits, two or more at one distance among "
                 "them, each in all its orders; two payloads; values that show what lies behind",
       .mutants =
           {mutant("accepted hits hide nothing", "traverse-as-met", gathering([](std::vector<Hit>& hits) {
                     std::erase_if(hits, [](const Hit& h) { return h.accepted; });
                   })),
            mutant("hits are sorted first", "traverse-as-met", gathering([](std::vector<Hit>& hits) {
                     std::sort(hits.begin(), hits.end(),
                               [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
                   })),
            mutant("the first met is never blended", "traverse-as-met", gathering([](std::vector<Hit>& hits) {
                     if (!hits.front().accepted) hits.erase(hits.begin());
                   })),
            mutant("of hits at one distance those that blend come first", "traverse-as-met",
                   gathering([](std::vector<Hit>& hits) {
                     for (std::size_t a = 0; a < hits.size(); ++a)
                       for (std::size_t b = a + 1; b < hits.size(); ++b)
                         if (hits[a].distance == hits[b].distance && hits[a].accepted && !hits[b].accepted)
                           std::swap(hits[a], hits[b]);
                   }))},
       .general = false},
      {entry::gather},
      on_scenes(std::move(frames), sorted_lists, [](const TraverseSubject& s, const Scene& scene) {
        std::set<Colour> payloads;
        const std::vector<Hit> hits = hits_of(scene);
        std::vector<std::size_t> order(hits.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        do {
          std::vector<Hit> met;
          for (const std::size_t k : order) met.push_back(hits[k]);
          payloads.insert(s.functions.gather(scene.operation, payload_of(scene), met));
        } while (std::next_permutation(order.begin(), order.end()));
        const bool depends = blends_behind_an_accepted(scene);
        if ((payloads.size() > 1) == depends)
          return Finding{word_of(*payloads.begin()) + std::uint64_t{payloads.size()} + 1};
        std::vector<std::string> all;
        for (const Colour& c : payloads) all.push_back(text_of_colour(c));
        return wrong(depends ? "several payloads" : "one payload", fmt::format("{}", fmt::join(all, ", ")));
      }));
}

bool is_order_free(Operation o) { return o != Operation::multiply && o != Operation::over; }

/// The payload of the blends before the nearest A: for max, min and add by distance and each once, for multiply and
/// over in the order of the hits.
Colour expected_of(const Scene& s) {
  std::vector<Hit> hits = hits_of(s);
  if (is_order_free(s.operation))
    std::stable_sort(hits.begin(), hits.end(),
                     [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
  Colour payload = payload_of(s);
  for (const Hit& hit : hits) {
    const bool hidden = hit.accepted || std::any_of(hits.begin(), hits.end(), [&hit](const Hit& other) {
                          return other.accepted && other.distance <= hit.distance;
                        });
    if (!hidden) payload = spec::traverse::blend(s.operation, payload, hit.value);
  }
  return payload;
}

Law before_closest() {
  std::vector<Scene> frames;
  for (unsigned o = 0; o < spec::traverse::operations; ++o)
    for (const Reports reports : {Reports::once, Reports::each_twice, Reports::all_again})
      for (const Values values : {Values::rising, Values::falling, Values::mixed})
        for (const Before before : {Before::neutral, Before::coloured})
          // Only max and min treat a hit reported twice as one.
          if (o <= static_cast<unsigned>(Operation::min) || reports == Reports::once)
            frames.push_back({static_cast<Operation>(o), {}, reports, values, before});
  return on_cases(
      {.id = "traverse.blend_before_closest",
       .says = "where blending waits for the closest accepted hit, exactly the hits before it are blended: "
               "in any order to one payload for max, min and add, for max and min also where hits are "
               "reported twice; multiply and over as they are met",
       .source = fixed_functions,
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 1},
       .domain =
           "5 operations, all 4,330 lists of one to four hits at distances that may be the same, in every "
           "order; max and min reported in three ways; two payloads, distinct values in three orders",
       .mutants = {mutant("a hit at the accepted one's distance blends", "traverse-spec",
                          gathering([](std::vector<Hit>& hits) {
                            for (Hit& h : hits) h.distance += h.accepted ? 1 : 0;
                          }))}},
      {entry::gather},
      on_scenes(std::move(frames), all_lists, [](const TraverseSubject& s, const Scene& scene) {
        const Colour right = expected_of(scene), got = s.functions.gather(scene.operation, payload_of(scene),
                                                                          reported(scene, hits_of(scene)));
        if (got == right) return Finding{word_of(got) + std::uint64_t{1}};
        return wrong(text_of_colour(right), text_of_colour(got));
      }));
}

}  // namespace

std::vector<Law> order_laws() { return {accepted_hit(), before_closest()}; }

}  // namespace mmverify::proofs::traverse
