#include "proofs/dag/law_parts.hpp"

#include "proofs/engine/spoils.hpp"

namespace mmverify::proofs::dag {
namespace {

Unfit needing(std::vector<Entry> entries, Levels within, const char* about) {
  return unless_of_topic<DagSubject>(lacking<DagSubject>(
      std::move(entries), [=](const DagSubject& s, Level n) -> std::optional<std::string> {
        if (auto why = above_its_levels(s, n)) return why;
        if (n < within.first || n > within.last) return about;
        return std::nullopt;
      }));
}

Law on_numbers(Law law, const Check& check, const std::function<std::uint64_t(Level)>& count,
               const std::function<Scene(Level, std::uint64_t)>& scene, std::uint64_t chunk) {
  return on_numbered_cases(
      std::move(law), {[=](Level n, const Run&) { return count(n); },
                       [=](const Subject& s, Level n, std::uint64_t k, const Run&) {
                         return check(subject_as<DagSubject>(s), scene(n, k));
                       },
                       [](const Subject&, Level, std::uint64_t k, const Run&) { return text_of_number(k); },
                       [=](const Subject& s, Level n, const std::string& at) {
                         return check(subject_as<DagSubject>(s), scene(n, number_from_text(at, count(n))));
                       },
                       chunk, Kind::interior});
}

using Sampled = Scene (*)(Level, std::uint64_t seed, std::uint64_t k);

Law on_sampled(Law law, std::vector<Entry> entries, CaseCount count, Sampled sampled, Check check) {
  law.method = Method::sample;
  if (!law.how) law.how = "sample, against the specification";
  law.unfit = needing(std::move(entries), {0, law.tiers.long_run.last}, "it is run up to a lower level");
  return on_numbered_cases(
      std::move(law),
      {std::move(count),
       [=](const Subject& s, Level n, std::uint64_t k, const Run& run) {
         return check(subject_as<DagSubject>(s), sampled(n, run.seed, k));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) { return text_of_sample(run.seed, k); },
       [=](const Subject& s, Level n, const std::string& at) {
         const auto [seed, k] = sample_from_text(at);
         return check(subject_as<DagSubject>(s), sampled(n, seed, k));
       },
       1, Kind::interior});
}

}  // namespace

Law on_small_scenes(Law law, std::vector<Entry> entries, Check check) {
  law.tiers.fast = law.tiers.long_run = {0, 4};
  law.domain = [](Level n) { return about_small_scenes(n); };
  law.unfit =
      needing(std::move(entries), {0, 4}, "its scenes are those of levels 0..4; dag.on_samples goes beyond");
  return on_numbers(std::move(law), check, small_scenes, small_scene, 256);
}

Law on_masks(Law law, std::vector<Entry> entries, Check check) {
  law.tiers.fast = {4, 6};
  law.tiers.long_run = {4, 7};
  law.domain = [](Level n) {
    return fmt::format("each of the 2^{} sets of children of the root at level {}, both formats",
                       spec::dag::children(n), n);
  };
  law.unfit = needing(std::move(entries), {4, 7}, "its maps are those of levels 4..7");
  return on_numbers(std::move(law), check, mask_scenes, mask_scene, 256);
}

Law on_samples(Law law, std::vector<Entry> entries, CaseCount count, Check check) {
  law.domain = [](Level n) {
    return fmt::format(
        "scenes of up to five maps of levels up to {}: noise, outlines, repeats, and maps nearly the same",
        n);
  };
  return on_sampled(std::move(law), std::move(entries), std::move(count), sample_scene, std::move(check));
}

Law on_many_maps(Law law, std::vector<Entry> entries, Check check) {
  law.tiers.fast = law.tiers.long_run = {0, 3};
  law.domain = [](Level n) {
    return fmt::format("scenes of 257 to 556 maps of levels up to {}{}; each state on its own", n,
                       n == 0 ? ", and of more than 2^16" : "");
  };
  return on_sampled(std::move(law), std::move(entries), 6, many_maps, std::move(check));
}

Change encodes_another(std::function<void(Scene&)> spoil) {
  return [=](Functions& functions) {
    functions.encode = [spoil, real = functions.encode](Scene scene) {
      spoil(scene);
      return real(scene);
    };
  };
}

Change decodes_wrongly(std::function<void(Scene&)> spoil) {
  return spoils(&Functions::decode, [spoil](const Code&, Scene& scene) { spoil(scene); });
}

Change finds_wrongly(std::function<void(const Scene&, std::uint32_t, std::uint32_t, std::uint8_t&)> spoil) {
  return [=](Functions& functions) {
    functions.lookup = [spoil, real = functions](const Code& code, Numbers map, Numbers index,
                                                 std::span<std::uint8_t> state) {
      real.lookup(code, map, index, state);
      const Scene scene = real.decode(code);
      for (std::size_t k = 0; k < state.size(); ++k) spoil(scene, map[k], index[k], state[k]);
    };
  };
}

Change writes_wrongly(std::function<void(const Scene&, Bytes&)> spoil) {
  return [=](Functions& functions) {
    functions.bytes = [spoil, real = functions](const Code& code) {
      Bytes bytes = real.bytes(code);
      spoil(real.decode(code), bytes);
      return bytes;
    };
  };
}

}  // namespace mmverify::proofs::dag
