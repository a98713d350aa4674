#include "bench/dag/csm_figures.hpp"

#include <map>
#include <random>
#include <stdexcept>
#include <string_view>

#include "bench/timing.hpp"

namespace mmverify::bench {
namespace {

using CsmMap = std::vector<std::uint8_t>;
constexpr std::size_t csm_rounds = 5;
constexpr std::uint64_t csm_record_bytes = 8;

/// A map of noise in which no 16 states in a row are transparent: neither form leaves out or finds anything.
CsmMap noise_map(std::uint32_t level, std::uint32_t bits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  CsmMap map(((std::uint64_t{bits} << 2 * level) + 7) / 8);
  const std::size_t sixteen_states = 2 * bits;
  for (std::size_t k = 0; k < map.size(); ++k)
    map[k] = static_cast<std::uint8_t>(random() | (k % sixteen_states == 0 ? 1 : 0));
  return map;
}

/// The growth of a form by one map of noise, over the map's bytes.
template <class Form>
double worst_case(const Form& form, std::uint64_t before, const CsmMap& noise) {
  return (static_cast<double>(form.bits() - before) / 8 - csm_record_bytes) /
         static_cast<double>(noise.size());
}

/// The bytes of the distinct maps, and where each map begins.
struct OnceArray {
  CsmMap bytes;
  std::vector<std::uint64_t> begins;

  explicit OnceArray(std::span<const CsmMap> maps) {
    std::map<std::string_view, std::uint64_t> known;
    for (const CsmMap& map : maps) {
      const std::string_view content(reinterpret_cast<const char*>(map.data()), map.size());
      const auto [found, is_new] = known.try_emplace(content, bytes.size());
      if (is_new) bytes.insert(bytes.end(), map.begin(), map.end());
      begins.push_back(found->second);
    }
  }
};

void expect_the_maps(const CommonSubtrees& csm, const CsmInput& in) {
  CsmMap again(in.maps[0].size());
  for (std::uint32_t k = 0; k < csm.maps(); ++k) {
    csm.decode(k, again);
    if (again != in.maps[k]) throw std::runtime_error("dag bench: csm does not give the map again");
  }
}

class CsmLookups {
 public:
  CsmLookups(const CsmInput& in, const OnceArray& once) : in_(in), once_(once) {
    std::mt19937_64 random(in.seed * 64 + in.level * 2 + in.bits);
    for (std::uint64_t k = 0; k < in.lookups; ++k) {
      which_.push_back(static_cast<std::uint32_t>(random() % in.maps.size()));
      index_.push_back(static_cast<std::uint32_t>(random() >> 32) &
                       static_cast<std::uint32_t>((std::uint64_t{1} << 2 * in.level) - 1));
    }
  }

  void measure(const impl::dag::Dag& dag, const CommonSubtrees& csm, CsmFigures& f) const {
    CsmMap state[3] = {CsmMap(which_.size()), CsmMap(which_.size()), CsmMap(which_.size())};
    std::vector<double> ns[3], dag_over_once, csm_over_once, dag_over_csm;
    for (std::size_t round = 0; round < csm_rounds; ++round) {
      if (in_.stop) in_.stop();
      ns[0].push_back(once_ns([&] { look_up_once(state[0]); }));
      ns[1].push_back(once_ns([&] { dag.lookup(which_, index_, state[1]); }));
      ns[2].push_back(once_ns([&] { csm.lookup(which_, index_, state[2]); }));
      dag_over_once.push_back(ns[1].back() / ns[0].back());
      csm_over_once.push_back(ns[2].back() / ns[0].back());
      dag_over_csm.push_back(ns[1].back() / ns[2].back());
    }
    if (state[0] != state[1] || state[0] != state[2])
      throw std::runtime_error("dag bench: csm gives other states");
    const auto each = static_cast<double>(which_.size());
    f.once_ns = median(ns[0]) / each;
    f.dag_ns = median(ns[1]) / each;
    f.csm_ns = median(ns[2]) / each;
    f.dag_over_once = median(dag_over_once);
    f.csm_over_once = median(csm_over_once);
    f.dag_over_csm = median(dag_over_csm);
  }

 private:
  void look_up_once(CsmMap& state) const {
    const std::uint32_t mask = (1u << in_.bits) - 1;
    for (std::size_t k = 0; k < state.size(); ++k) {
      const std::uint64_t bit = std::uint64_t{index_[k]} * in_.bits;
      state[k] = static_cast<std::uint8_t>(once_.bytes[once_.begins[which_[k]] + bit / 8] >> bit % 8 & mask);
    }
  }

  const CsmInput& in_;
  const OnceArray& once_;
  std::vector<std::uint32_t> which_, index_;
};

}  // namespace

CsmFigures csm_figures(const CsmInput& in, const impl::dag::Dag& dag) {
  if (in.maps.empty() || in.lookups == 0)
    throw std::invalid_argument("dag bench: a map and a lookup at least");
  CsmFigures f{.level = in.level, .bits = in.bits, .maps = in.maps.size(), .flat_bytes = in.flat_bytes};
  const OnceArray once(in.maps);
  f.once_bytes = csm_record_bytes * in.maps.size() + once.bytes.size();
  f.dag_bytes = dag.bits() / 8;
  CommonSubtrees csm(true), plain(false);
  const double ns = once_ns([&] {
    for (const CsmMap& map : in.maps) csm.add(in.level, in.bits, map);
  });
  f.csm_build_rate = 1e3 * static_cast<double>(in.maps.size() << 2 * in.level) / ns;
  f.csm_bytes = csm.bits() / 8;
  expect_the_maps(csm, in);
  for (const CsmMap& map : in.maps) plain.add(in.level, in.bits, map);
  f.csm_plain_bytes = plain.bits() / 8;
  CsmLookups(in, once).measure(dag, csm, f);
  const CsmMap noise = noise_map(in.level, in.bits, in.seed);
  CommonSubtrees alone(true);
  impl::dag::Dag graph_alone(impl::dag::Format{in.bits});
  const std::uint64_t empty = alone.bits();
  alone.add(in.level, in.bits, noise);
  graph_alone.add(in.level, noise);
  f.csm_worst = worst_case(alone, empty, noise);
  f.dag_worst = worst_case(graph_alone, 0, noise);
  return f;
}

void MergedLevels::add(std::uint32_t level, std::uint32_t bits, std::span<const CsmMap> maps) {
  for (const CsmMap& map : maps) {
    dag_[bits - 1].add(level, map);
    csm_.add(level, bits, map);
  }
}

}  // namespace mmverify::bench
