#include "proofs/traverse/combinations.hpp"

#include <fmt/format.h>

#include <span>

#include "proofs/engine/law.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::traverse {
namespace {

using namespace spec::traverse;

constexpr const char* api_names[apis] = {"ext-pipeline", "ext-query",    "khr-pipeline",
                                         "khr-query",    "dxr-pipeline", "dxr-query"};
constexpr const char* held_names[] = {"nothing", "special", "2-state", "4-state"};

/// Numbers taken apart, the last digit first.
class Digits {
 public:
  explicit Digits(std::uint64_t k) : rest_(k) {}
  unsigned next(unsigned base) {
    const auto digit = static_cast<unsigned>(rest_ % base);
    rest_ /= base;
    return digit;
  }
  bool bit() { return next(2) == 1; }

 private:
  std::uint64_t rest_;
};

/// Who traces, and whether the trace is set up for micromaps.
struct Way {
  Api api;
  bool enabled;
};

std::vector<Way> all_ways() {
  std::vector<Way> all;
  for (unsigned api = 0; api < apis; ++api)
    for (const bool enabled : {true, false})
      if (enabled || has_switch(static_cast<Api>(api))) all.push_back({static_cast<Api>(api), enabled});
  return all;
}

std::vector<Candidate> all_held() {
  std::vector<Candidate> all{{}};
  for (const Held held : {Held::special, Held::two_state, Held::four_state})
    for (const State s : {State::T, State::O, State::UT, State::UO})
      if (const Candidate c{held, s, false}; exists(c)) all.push_back(c);
  return all;
}

/// A flag's name, and where it is kept.
template <class Flags>
struct Flag {
  const char* name;
  bool Flags::*is_set;
};
constexpr Flag<Instance> instance_flags[] = {{"force-opaque", &Instance::force_opaque},
                                             {"force-no-opaque", &Instance::force_no_opaque},
                                             {"2-state", &Instance::force_two_state},
                                             {"disabled", &Instance::disable_micromaps}};
constexpr Flag<Ray> ray_flags[] = {{"opaque", &Ray::opaque},
                                   {"no-opaque", &Ray::no_opaque},
                                   {"cull-opaque", &Ray::cull_opaque},
                                   {"cull-no-opaque", &Ray::cull_no_opaque},
                                   {"2-state", &Ray::force_two_state}};

template <class Flags>
std::string joined(const Flags& flags, std::span<const Flag<Flags>> known) {
  std::string text;
  for (const Flag<Flags>& f : known)
    if (flags.*f.is_set) text += (text.empty() ? "" : "+") + std::string(f.name);
  return text.empty() ? "none" : text;
}

[[noreturn]] void refuse(const std::string& text) {
  throw BadCase(fmt::format("'{:.60}': write {}", text, text_of(Combination{})));
}

/// Each flag once at most, in the order in which they are written.
template <class Flags>
Flags flags_from(const std::string& text, std::span<const Flag<Flags>> known, const std::string& all) {
  Flags flags;
  if (text == "none") return flags;
  std::size_t next = 0, from = 0;
  while (true) {
    const std::size_t to = text.find('+', from);
    const std::string name = text.substr(from, to == std::string::npos ? to : to - from);
    while (next < known.size() && name != known[next].name) ++next;
    if (next == known.size()) refuse(all);
    flags.*known[next++].is_set = true;
    if (to == std::string::npos) return flags;
    from = to + 1;
  }
}

}  // namespace

Combination combination(std::uint64_t k) {
  static const std::vector<Way> ways = all_ways();
  static const std::vector<Candidate> held = all_held();
  Digits digits(k);
  Combination c;
  for (const auto& f : ray_flags) c.ray.*f.is_set = digits.bit();
  for (const auto& f : instance_flags) c.instance.*f.is_set = digits.bit();
  const bool geometry_opaque = digits.bit();
  c.candidate = held[digits.next(static_cast<unsigned>(held.size()))];
  c.candidate.geometry_opaque = geometry_opaque;
  const Way way = ways[digits.next(static_cast<unsigned>(ways.size()))];
  c.api = way.api;
  c.enabled = way.enabled;
  return c;
}

const std::vector<Combination>& defined() {
  static const std::vector<Combination> all = [] {
    std::vector<Combination> found;
    for (std::uint64_t k = 0; k < all_combinations; ++k)
      if (const Combination c = combination(k); !undefined(c).any()) found.push_back(c);
    return found;
  }();
  return all;
}

std::string flags_of(const Instance& i) { return joined<Instance>(i, instance_flags); }
std::string flags_of(const Ray& r) { return joined<Ray>(r, ray_flags); }
const char* name_of(Api api) { return api_names[static_cast<unsigned>(api)]; }

std::string text_of_held(const Candidate& c) {
  const char* held = held_names[static_cast<unsigned>(c.held)];
  return c.held == Held::nothing ? held : fmt::format("{}:{}", held, spec::micromap::name_of(c.state));
}

std::string text_of(const Combination& c) {
  return fmt::format("{},{},{},{},instance={},ray={}", name_of(c.api), c.enabled ? "on" : "off",
                     text_of_held(c.candidate), c.candidate.geometry_opaque ? "opaque" : "not-opaque",
                     flags_of(c.instance), flags_of(c.ray));
}

Combination combination_of(const std::string& text) {
  const Groups g = groups_of(text,
                             "([a-z]+-[a-z]+),(on|off),(nothing|special|2-state|4-state)(:(T|O|UT|UO))?,("
                             "opaque|not-opaque),instance=([a-z0-9+-]+),ray=([a-z0-9+-]+)");
  if (!g) refuse(text);
  Combination c;
  unsigned api = 0, held = 0, state = 0;
  while (api < apis && (*g)[1] != api_names[api]) ++api;
  if (api == apis) refuse(text);
  while ((*g)[3] != held_names[held]) ++held;
  c.api = static_cast<Api>(api);
  c.enabled = (*g)[2] == "on";
  c.candidate.held = static_cast<Held>(held);
  if ((*g)[5].empty() != (c.candidate.held == Held::nothing)) refuse(text);
  if (!(*g)[5].empty())
    while ((*g)[5] != spec::micromap::name_of(static_cast<State>(state))) ++state;
  c.candidate.state = static_cast<State>(state);
  c.candidate.geometry_opaque = (*g)[6] == "opaque";
  if (!exists(c.candidate) || (!c.enabled && !has_switch(c.api))) refuse(text);
  c.instance = flags_from<Instance>((*g)[7], instance_flags, text);
  c.ray = flags_from<Ray>((*g)[8], ray_flags, text);
  return c;
}

}  // namespace mmverify::proofs::traverse
