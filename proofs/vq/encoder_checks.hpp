// Checks of an encoder's code of one map, and laws that run them over many maps.
#pragma once

#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/maps.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {

template <class Format>
Map<Format> meant(const BlockBytes<Format>& block) {
  return spec::vq::decode(spec::vq::from_bytes<Format>(block));
}

template <class Format>
std::string region_text(std::size_t k) {
  return fmt::format("region {},{}", k % (8 * Format::side), k / (8 * Format::side));
}

/// The number of substitutions between two maps as the answer; fails if one is not allowed.
template <class Format>
Finding substituted(const Map<Format>& was, const Map<Format>& is) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < was.size(); ++k) {
    if (is[k] == was[k]) continue;
    if (is[k] != State::C)
      return wrong(fmt::format("{} {}", region_text<Format>(k),
                               was[k] == State::C ? "C" : letters({&was[k], 1}) + " or C"),
                   letters({&is[k], 1}));
    ++count;
  }
  return {count};
}

template <class Format>
Finding conservative(const VqSubject& s, const Map<Format>& map) {
  const Encoded<Format> encoded = s.functions.codec<Format>().encode(map);
  Finding found = substituted<Format>(map, meant<Format>(encoded.block));
  if (!found.holds) return found;
  if (encoded.substitutions && *encoded.substitutions != found.answer)
    return wrong(fmt::format("substitutions {}", found.answer), fmt::format("{}", *encoded.substitutions));
  found.answer = hash_of(encoded.block);
  return found;
}

template <class Format>
Finding keeps(const VqSubject& s, const Map<Format>& map) {
  const Encoded<Format> encoded = s.functions.codec<Format>().encode(map);
  const Map<Format> got = meant<Format>(encoded.block);
  for (std::size_t k = 0; k < map.size(); ++k)
    if (got[k] != map[k])
      return wrong(region_text<Format>(k) + " " + letters({&map[k], 1}), letters({&got[k], 1}));
  return {hash_of(encoded.block)};
}

template <class Format>
Finding keeps_what_it_made(const VqSubject& s, const Map<Format>& map) {
  return keeps<Format>(s, meant<Format>(s.functions.codec<Format>().encode(map).block));
}

template <class Format>
Finding keeps_its_promise(const VqSubject& s, const Map<Format>& map) {
  const Codec<Format>& codec = s.functions.codec<Format>();
  const Finding found = substituted<Format>(map, meant<Format>(codec.encode(map).block));
  if (!found.holds) return found;
  if (codec.at_most)
    if (const std::uint32_t most = codec.at_most(map); found.answer > most)
      return wrong(fmt::format("substitutions, at most {}", most), fmt::format("{}", found.answer));
  if (codec.at_least)
    if (const std::uint32_t least = codec.at_least(map); found.answer < least)
      return wrong(fmt::format("substitutions, at least {}", least), fmt::format("{}", found.answer));
  return found;
}

inline Finding fewest(const VqSubject& s, const Map<Vq2>& map) {
  const Finding found = substituted<Vq2>(map, meant<Vq2>(s.functions.vq2.encode(map).block));
  if (!found.holds) return found;
  const std::uint32_t least = least_substitutions(map);
  return found.answer == least
             ? found
             : wrong(fmt::format("substitutions {}", least), fmt::format("{}", found.answer));
}

template <class Format>
std::optional<std::string> lacks_encoder(const VqSubject& s) {
  if (!s.functions.codec<Format>().encode)
    return fmt::format("{} has no encoder of VQ{}", s.name(), Format::side);
  return std::nullopt;
}

template <class Format>
std::optional<std::string> does_not_keep(const VqSubject& s) {
  if (auto lacks = lacks_encoder<Format>(s)) return lacks;
  if (!s.functions.codec<Format>().keeps_what_fits)
    return s.name() + " does not promise to keep what a block can hold";
  return std::nullopt;
}

template <class Format>
Law on_maps(Law law, CaseCount count, std::function<Map<Format>(std::uint64_t seed, std::uint64_t k)> number,
            std::function<Finding(const VqSubject&, const Map<Format>&)> check,
            const Lacks& lacks = lacks_encoder<Format>) {
  Cases<Map<Format>> cases;
  cases.count = std::move(count);
  cases.number = [=](Level, std::uint64_t k, std::uint64_t seed) { return number(seed, k); };
  cases.text = text_of_map<Format>;
  cases.read = [](Level n, const std::string& at) {
    const Map<Format> map = map_from_text<Format>(at);
    check_level<Format>(n);
    return map;
  };
  cases.check = std::move(check);
  cases.chunk = 4;
  law.tiers.fast = level_alone<Format>;
  return on_cases(std::move(law), lacks, cases);
}

template <class Format>
std::string sample_maps() {
  return fmt::format(
      "maps of {0}x{0} regions: shapes, O beside T, turned quadrants, few vectors, a block's but for up to "
      "three regions, uniform, one odd region, noise",
      8 * Format::side);
}

}  // namespace mmverify::proofs::vq
