// Laws of encoders: nothing but O and T become C, what fits is kept, more effort does not lose more.
#include "proofs/vq/encoder_mutants.hpp"
#include "proofs/vq/laws.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

constexpr char section_3[] = "Compressed Opacity Maps, 3";
constexpr char section_4_2[] = "Compressed Opacity Maps, 4.2, Algorithm 1; 6 (fewer substitutions)";
constexpr char section_5_2[] =
    "Compressed Opacity Maps, 5.2, 6 (fewer substitutions); this project's promise";
constexpr char section_6[] = "Compressed Opacity Maps, 6 (fewer substitutions); this project's promise";

constexpr std::array<State, 3> states{T, C, O};

/// A map of one state but for one vector of VQ2.
Map<Vq2> alone_number(std::uint64_t k) {
  Map<Vq2> map;
  map.fill(states[k % 3]);
  k /= 3;
  const auto place = static_cast<std::uint32_t>(k % 64);
  k /= 64;
  Vector<2> v;
  for (State& s : v) {
    s = states[k % 3];
    k /= 3;
  }
  put<Vq2>(map, place, v);
  return map;
}

/// A map of one state but for one region of VQ4.
Map<Vq4> odd_region_number(std::uint64_t k) {
  Map<Vq4> map;
  map.fill(states[k % 3]);
  map[k / 6] = states[(k % 3 + 1 + k / 3 % 2) % 3];
  return map;
}

constexpr char conservative_says[] =
    "encoding turns O and T into themselves or C, leaves C, and counts its substitutions right";

Law alone_law() {
  const auto one = [](State around, std::uint32_t place, Vector<2> v) {
    Map<Vq2> map;
    map.fill(around);
    put<Vq2>(map, place, v);
    return map;
  };
  return on_maps<Vq2>(
      {.id = "vq2.conservative",
       .says = conservative_says,
       .source = section_3,
       .subjects = {"vq2-optimal", "vq2-paper"},
       .tiers = {.seconds = 2},
       .domain = "each of the 81 vectors of 2x2, O beside T among them, alone at each place of a uniform "
                 "map",
       .mutants = {mutant("one C becomes T", "vq2-optimal", level_alone<Vq2>,
                          instead<Vq2>(one(T, 27, {T, C, T, T}), one(T, 27, {T, T, T, T})))}},
      3 * 64 * 81, [](std::uint64_t, std::uint64_t k) { return alone_number(k); }, conservative<Vq2>);
}

/// Two vectors of VQ2 in two quadrants of a map of T, at a place of their own each.
Map<Vq2> pair_number(std::uint64_t k) {
  constexpr std::array<std::uint32_t, 4> places{1 + 8 * 6, 6 + 8 * 5, 2 + 8 * 1, 5 + 8 * 2};
  constexpr std::array<std::array<std::size_t, 2>, 6> quadrants{
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  Map<Vq2> map;
  map.fill(T);
  const auto& where = quadrants[k % 6];
  k /= 6;
  for (const std::size_t q : where) {
    Vector<2> v;
    for (State& s : v) {
      s = states[k % 3];
      k /= 3;
    }
    put<Vq2>(map, places[q], v);
  }
  return map;
}

Law pairs_law() {
  const auto pair = [](std::uint64_t quadrants, std::uint64_t first, std::uint64_t second) {
    return pair_number(quadrants + 6 * (first + 81 * second));
  };
  return on_maps<Vq2>(
      {.id = "vq2.conservative_in_pairs",
       .says = conservative_says,
       .source = section_3,
       .subjects = {"vq2-optimal"},
       .tiers = {.seconds = 1},
       .domain = "every pair of the 81 vectors of 2x2 in every two quadrants of a map of T",
       .mutants = {mutant("the last pair is encoded as one that has O for C", "vq2-optimal", level_alone<Vq2>,
                          instead<Vq2>(pair(5, 40, 79), pair(5, 40, 80)))}},
      6 * 81 * 81, [](std::uint64_t, std::uint64_t k) { return pair_number(k); }, conservative<Vq2>);
}

Law odd_region_law() {
  const auto one = [](State around, std::size_t region, State odd) {
    Map<Vq4> map;
    map.fill(around);
    map[region] = odd;
    return map;
  };
  return on_maps<Vq4>(
      {.id = "vq4.conservative",
       .says = conservative_says,
       .source = section_3,
       .subjects = {"vq4-fast", "vq4-balanced", "vq4-thorough", "vq4-paper"},
       .tiers = {.seconds = 3},
       .domain = "each region, alone in each state of each uniform map",
       .mutants = {mutant("the last region, O in T, is T", "vq4-fast", level_alone<Vq4>,
                          instead<Vq4>(one(T, 1023, O), one(T, 1023, T)))}},
      6 * 1024, [](std::uint64_t, std::uint64_t k) { return odd_region_number(k); }, conservative<Vq4>);
}

template <class Format>
Law conservative_on_samples(const char* id, std::vector<std::string> subjects, std::uint64_t fast,
                            std::uint64_t long_run, std::vector<Mutant> mutants) {
  return on_maps<Format>({.id = id,
                          .says = conservative_says,
                          .source = section_3,
                          .method = Method::sample,
                          .subjects = std::move(subjects),
                          .tiers = {.seconds = 1},
                          .domain = sample_maps<Format>(),
                          .mutants = std::move(mutants)},
                         {fast, long_run}, sample_map<Format>, conservative<Format>);
}

template <class Format>
Law lossless_law(const char* id, const char* source, std::vector<std::string> subjects, std::uint64_t fast,
                 std::uint64_t long_run, std::vector<Mutant> mutants) {
  return on_maps<Format>(
      {.id = id,
       .says = "the map of a block is encoded without a substitution",
       .source = source,
       .method = Method::sample,
       .subjects = std::move(subjects),
       .tiers = {.seconds = 1},
       .domain = "maps of blocks under all 512 transform triples in turn, with few, uneven or all entries",
       .mutants = std::move(mutants)},
      {fast, long_run},
      [](std::uint64_t seed, std::uint64_t k) { return spec::vq::decode(sample_block<Format>(seed, k)); },
      keeps<Format>, does_not_keep<Format>);
}

template <class Format>
Law reencode_law(const char* id, const char* source, std::vector<std::string> subjects, std::uint64_t fast,
                 std::uint64_t long_run, std::vector<Mutant> mutants) {
  return on_maps<Format>({.id = id,
                          .says = "the map of an encoder's own block loses nothing more",
                          .source = source,
                          .method = Method::sample,
                          .subjects = std::move(subjects),
                          .tiers = {.seconds = 1},
                          .domain = sample_maps<Format>(),
                          .mutants = std::move(mutants)},
                         {fast, long_run}, sample_map<Format>, keeps_what_it_made<Format>,
                         does_not_keep<Format>);
}

template <class Format>
Law effort_law(const char* id, const char* says, const char* source, std::vector<std::string> subjects,
               std::uint64_t fast, std::uint64_t long_run, std::vector<Mutant> mutants) {
  return on_maps<Format>({.id = id,
                          .says = says,
                          .source = source,
                          .method = Method::sample,
                          .subjects = std::move(subjects),
                          .tiers = {.seconds = 1},
                          .domain = sample_maps<Format>(),
                          .mutants = std::move(mutants)},
                         {fast, long_run}, sample_map<Format>, keeps_its_promise<Format>,
                         [](const VqSubject& s) -> std::optional<std::string> {
                           const Codec<Format>& codec = s.functions.codec<Format>();
                           if (!codec.at_most && !codec.at_least)
                             return s.name() + " promises nothing of its substitutions";
                           return lacks_encoder<Format>(s);
                         });
}

Law optimum_law() {
  return on_maps<Vq2>({.id = "vq2.optimum",
                       .says = "no block needs fewer substitutions, by a solver that tries all",
                       .source = section_6,
                       .method = Method::sample,
                       .subjects = {"vq2-optimal"},
                       .tiers = {.seconds = 1},
                       .domain = sample_maps<Vq2>(),
                       .mutants = {mutant("gives up a vector under Rotate 90 in TR", "vq2-optimal",
                                          level_alone<Vq2>, gives_up_a_vector<Vq2>(1, 1)),
                                   mutant("gives up a vector under Rotate 90 in BR", "vq2-optimal",
                                          level_alone<Vq2>, gives_up_a_vector<Vq2>(3, 1)),
                                   mutant("gives up a vector of TL", "vq2-optimal", level_alone<Vq2>,
                                          gives_up_a_vector<Vq2>(0, 0))}},
                      {48, 10'000}, sample_map<Vq2>, fewest,
                      [](const VqSubject& s) -> std::optional<std::string> {
                        if (auto lacks = lacks_encoder<Vq2>(s)) return lacks;
                        if (!s.functions.vq2.fewest)
                          return s.name() + " does not promise the fewest substitutions";
                        return std::nullopt;
                      });
}

Law bound_law() {
  const auto vq4 = [](const char* name, const std::function<void(Functions&)>& change) {
    return mutant(name, "vq4-proved", level_alone<Vq4>, change);
  };
  return on_maps<Vq4>(
      {.id = "vq4.bound",
       .says = "no encoder is below the bound, and the one beside it is not worse than the most effort",
       .source = section_6,
       .method = Method::sample,
       .subjects = {"vq4-proved"},
       .tiers = {.seconds = 0.5},
       .domain = sample_maps<Vq4>(),
       .mutants = {vq4("gives up a vector of TL", gives_up_a_vector<Vq4>(0, 0)),
                   vq4("gives up a vector of BR where it is not turned", gives_up_a_vector<Vq4>(3, 0)),
                   vq4("a bound that is one too high",
                       [](Functions& functions) {
                         functions.vq4.at_least = [real = functions.vq4.at_least](const Map<Vq4>& map) {
                           return real(map) + 1;
                         };
                       })}},
      {12, 64}, sample_map<Vq4>, keeps_its_promise<Vq4>,
      [](const VqSubject& s) -> std::optional<std::string> {
        if (auto lacks = lacks_encoder<Vq4>(s)) return lacks;
        if (!s.functions.vq4.at_least) return s.name() + " gives no bound";
        return std::nullopt;
      });
}

}  // namespace

std::vector<Law> encoder_laws() {
  const auto vq2 = [](const char* name, const std::function<void(Functions&)>& change) {
    return mutant(name, "vq2-optimal", level_alone<Vq2>, change);
  };
  const auto vq4 = [](const char* name, const char* base, const std::function<void(Functions&)>& change) {
    return mutant(name, base, level_alone<Vq4>, change);
  };
  const std::vector<std::string> efforts{"vq4-fast", "vq4-balanced", "vq4-thorough"};
  return {
      alone_law(),
      pairs_law(),
      conservative_on_samples<Vq2>(
          "vq2.conservative_on_samples", {"vq2-optimal", "vq2-paper", "vq2-paper-highest-first"}, 240, 50'000,
          {vq2("counts one less where TR is rotated by 180", counts_one_less<Vq2>(1, 6))}),
      lossless_law<Vq2>("vq2.lossless_when_it_fits", section_6, {"vq2-optimal"}, 8'192, 80'000,
                        {vq2("uses no entry where two in all are of use", gives_up_two_entries())}),
      reencode_law<Vq2>("vq2.reencode", section_6, {"vq2-optimal"}, 160, 50'000,
                        {vq2("loses a C where BL is reflected at X=-Y", loses_a_check<Vq2>(2, 3))}),
      effort_law<Vq2>("vq2.effort", "the optimum needs no more substitutions than Algorithm 1", section_4_2,
                      {"vq2-optimal"}, 160, 20'000,
                      {vq2("gives up a vector where BR is rotated by 180", gives_up_a_vector<Vq2>(3, 6)),
                       vq2("gives up a vector where TR is reflected LR", gives_up_a_vector<Vq2>(1, 4)),
                       vq2("loses a C where BL is rotated by 90", loses_a_check<Vq2>(2, 1))}),
      optimum_law(),
      odd_region_law(),
      conservative_on_samples<Vq4>(
          "vq4.conservative_on_samples",
          {"vq4-fast", "vq4-balanced", "vq4-thorough", "vq4-paper", "vq4-paper-free-c"}, 64, 4'000,
          {vq4("counts one less where TR is rotated by 180", "vq4-balanced", counts_one_less<Vq4>(1, 6))}),
      lossless_law<Vq4>(
          "vq4.lossless_when_it_fits", section_6, efforts, 8'192, 50'000,
          {vq4("loses a C where TR is reflected at X=Y", "vq4-thorough", loses_a_check<Vq4>(1, 5))}),
      reencode_law<Vq4>(
          "vq4.reencode", section_6, efforts, 64, 4'000,
          {vq4("loses a C where BL is reflected at X=-Y", "vq4-balanced", loses_a_check<Vq4>(2, 3))}),
      effort_law<Vq4>(
          "vq4.effort", "more effort never needs more substitutions", section_5_2,
          {"vq4-balanced", "vq4-thorough"}, 64, 4'000,
          {vq4("gives up a vector where BR is rotated by 90", "vq4-balanced", gives_up_a_vector<Vq4>(3, 1)),
           vq4("gives up a vector where TR is reflected LR", "vq4-balanced", gives_up_a_vector<Vq4>(1, 4)),
           vq4("loses a C where BL is rotated by 90", "vq4-balanced", loses_a_check<Vq4>(2, 1))}),
      bound_law()};
}

}  // namespace mmverify::proofs::vq