#include "proofs/array/cases.hpp"

#include <charconv>

#include "proofs/engine/shape.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

PackedMap taken(const micromap::Map& map) { return {map.level, map.format, map.packed}; }

std::vector<PackedMap> make_all(Level n) {
  std::vector<PackedMap> all;
  for (Level level = 0; level <= n; ++level)
    for (std::uint64_t k = 0; k < micromap::map_count(level); ++k)
      all.push_back(taken(micromap::map_number(level, k)));
  return all;
}

std::vector<PackedMap> make_sorted(Level n) {
  std::vector<PackedMap> all = make_all(n);
  std::erase_if(all, [](const PackedMap& m) {
    const States s = states_of(m);
    return !std::is_sorted(s.begin(), s.end());
  });
  return all;
}

/// Who builds with indices of 8, 16 and 32 bits: with choice c another API, so that each has its turn.
constexpr std::pair<Api, Encoding> builders[][3] = {
    {{Api::KHR, Encoding::u8}, {Api::EXT, Encoding::u16}, {Api::OptiX, Encoding::u32}},
    {{Api::DXR, Encoding::u8}, {Api::NVAPI, Encoding::u16}, {Api::EXT, Encoding::u32}},
    {{Api::glTF, Encoding::u8}, {Api::KHR, Encoding::u16}, {Api::DXR, Encoding::u32}},
};
constexpr std::uint64_t widths = 3, choices = 8;

/// Choice 0 is special indices and sharing without a base triangle; of the other bits each turns one over.
void choose(BuildCase& c, std::uint64_t choice, std::uint64_t width) {
  const auto [api, encoding] = builders[choice % std::size(builders)][width];
  c.options.api = api;
  c.options.encoding = encoding;
  c.options.special = (choice & 1) == 0;
  c.options.share = (choice & 2) == 0;
  if ((choice & 4) != 0) {
    c.options.base = 1;
    c.before = {{1, Format::four_state, {0xe4}}};
  }
}

/// Arrays of exactly `count` of the maps, by number: the first triangle's is the highest digit.
std::uint64_t power(std::uint64_t base, unsigned count) {
  std::uint64_t out = 1;
  for (; count > 0; --count) out *= base;
  return out;
}
void fill(BuildCase& c, const std::vector<PackedMap>& from, unsigned count, std::uint64_t k) {
  for (unsigned t = 0; t < count; ++t)
    c.maps.push_back(from[k / power(from.size(), count - 1 - t) % from.size()]);
}

/// A group of cases: `count` triangles of the maps, with choices first .. last.
struct Group {
  const std::vector<PackedMap>& from;
  unsigned count;
  std::uint64_t first, last;
  std::uint64_t size() const { return power(from.size(), count) * (last - first) * widths; }
};

std::vector<Group> groups(Level n) {
  const auto &all = all_maps(n), &sorted = sorted_maps(n);
  if (n == 0) return {{all, 0, 0, choices}, {all, 1, 0, choices}, {all, 2, 0, choices}, {all, 3, 0, choices}};
  return {
      {all, 1, 0, 1}, {sorted, 1, 1, choices}, {all, 2, 0, 1}, {sorted, 2, 1, choices}, {sorted, 3, 0, 1}};
}

std::string text_of_map(const PackedMap& m) { return micromap::text_of_states({m.level, m.format, m.bytes}); }

PackedMap map_of_text(const std::string& text) {
  const std::string_view digits = micromap::format_and_rest(text).second;
  for (Level level = 0; level <= 4; ++level)
    if (digits.size() == maps::micro_triangles(level)) return taken(micromap::map_from_text(level, text));
  throw BadCase("'" + text.substr(0, 40) + "': a map has 1, 4, 16, 64 or 256 digits");
}

std::uint32_t number_of(const std::string& text, std::size_t from) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data() + from, end, value);
  if (error != std::errc() || at != end || value > 1000)
    throw BadCase("'" + text + "': a number up to 1000 is due");
  return value;
}

/// The map but for up to three states.
PackedMap nearly(PackedMap map, Random& random) {
  const std::uint64_t states = maps::micro_triangles(map.level), b = bits(map.format);
  for (std::uint64_t left = 1 + random.below(3); left > 0; --left) {
    const std::uint64_t bit =
        (random.below(2) == 0 ? states - 1 : random.below(states)) * b + random.below(b);
    map.bytes[bit / 8] = static_cast<std::uint8_t>(map.bytes[bit / 8] ^ 1u << bit % 8);
  }
  return map;
}

}  // namespace

PackedMap any_map(Level n, Random& random) {
  const Level level = static_cast<Level>(random.below(n + 1));
  if (random.below(6) == 0)
    return taken(micromap::map_of(
        level, micromap::chosen_apart(level, random.below(micromap::chosen_apart_count(level)))));
  const std::uint64_t kind = random.below(10);
  return taken(micromap::sample_map(level, random.next() >> 32, kind));
}

const char* name_of(Encoding e) {
  constexpr const char* names[] = {"u8", "u16", "u32", "i16", "i32"};
  return names[static_cast<std::size_t>(e)];
}

States states_of(const PackedMap& m) {
  return maps::unpack(m.bytes, m.format, maps::micro_triangles(m.level));
}

PackedMap packed(Level level, Format format, const States& states) {
  return {level, format, maps::pack(states, format)};
}

const std::vector<PackedMap>& all_maps(Level n) {
  static const std::vector<PackedMap> of_0 = make_all(0), of_1 = make_all(1);
  return n == 0 ? of_0 : of_1;
}

const std::vector<PackedMap>& sorted_maps(Level n) {
  static const std::vector<PackedMap> of_0 = make_sorted(0), of_1 = make_sorted(1);
  return n == 0 ? of_0 : of_1;
}

std::uint64_t small_arrays(Level n) {
  std::uint64_t count = 0;
  for (const Group& g : groups(n)) count += g.size();
  return count;
}

BuildCase small_array(Level n, std::uint64_t k) {
  BuildCase c;
  for (const Group& g : groups(n)) {
    if (k < g.size()) {
      const std::uint64_t each = (g.last - g.first) * widths;
      choose(c, g.first + k % each / widths, k % widths);
      fill(c, g.from, g.count, k / each);
      return c;
    }
    k -= g.size();
  }
  throw std::logic_error("array: no such case");
}

std::uint64_t whole_small_arrays() { return power(all_maps(1).size(), 3) * widths; }

BuildCase whole_small_array(std::uint64_t k) {
  BuildCase c;
  choose(c, 0, k % widths);
  fill(c, all_maps(1), 3, k / widths);
  return c;
}

namespace {

/// About as many records as 8 bits can name: one each, with any base.
BuildCase array_at_the_limit(Level n, Random& random) {
  constexpr Api with_8_bits[] = {Api::KHR, Api::DXR, Api::glTF};
  BuildCase c;
  for (std::uint64_t left = random.below(6); left > 0; --left) c.before.push_back(any_map(n, random));
  const std::uint64_t count = maps::index_limit(Encoding::u8) - 4 + random.below(9);
  for (std::uint64_t left = count; left > 0; --left) c.maps.push_back(any_map(std::min<Level>(n, 2), random));
  c.options.api = with_8_bits[random.below(3)];
  c.options.encoding = Encoding::u8;
  c.options.base = static_cast<std::uint32_t>(random.below(c.before.size() + 1));
  c.options.special = c.options.share = false;
  return c;
}

constexpr std::uint64_t one_in_at_the_limit = 50;

}  // namespace

BuildCase sample_array(Level n, std::uint64_t seed, std::uint64_t k, std::uint32_t bound) {
  Random random(seed, 211 + n + 100 * bound, k);
  if (k % one_in_at_the_limit == one_in_at_the_limit - 1) return array_at_the_limit(n, random);
  BuildCase c;
  std::vector<PackedMap> all;
  const auto add = [&](std::vector<PackedMap>& to) {
    const std::uint64_t way = all.empty() ? 5 : random.below(6);
    all.push_back(way > 3    ? any_map(n, random)
                  : way == 3 ? all[random.below(all.size())]
                             : nearly(all[random.below(all.size())], random));
    to.push_back(all.back());
  };
  if (random.below(2) == 0)
    for (std::uint64_t left = random.below(6); left > 0; --left) add(c.before);
  for (std::uint64_t left = random.below(41); left > 0; --left) add(c.maps);
  BuildOptions& o = c.options;
  do {
    o.api = spec::array::apis[random.below(spec::array::api_count)];
    o.encoding = maps::encodings[random.below(5)];
  } while (!spec::array::takes(o.api, o.encoding));
  o.base = static_cast<std::uint32_t>(random.below(c.before.size() + 1));
  o.special = random.below(4) != 0;
  o.share = random.below(3) != 0;
  o.bound = bound == 0 ? 0 : 1 + static_cast<std::uint32_t>(random.below(bound));
  return c;
}

std::string text_of(const BuildCase& c) {
  const BuildOptions& o = c.options;
  std::string text = fmt::format("{},{}", spec::array::requirements(o.api).name, name_of(o.encoding));
  if (o.special) text += ",special";
  if (o.share) text += ",share";
  if (o.base != 0) text += fmt::format(",base={}", o.base);
  if (o.bound != 0) text += fmt::format(",bound={}", o.bound);
  for (const PackedMap& m : c.before) text += ",before:" + text_of_map(m);
  for (const PackedMap& m : c.maps) text += "," + text_of_map(m);
  return text;
}

BuildCase case_of(const std::string& text) {
  BuildCase c;
  c.options.special = c.options.share = false;
  bool of_api = false, of_encoding = false;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, to - from);
    from = to + 1;
    bool taken = false;
    for (const Api api : spec::array::apis)
      if (part == spec::array::requirements(api).name) {
        c.options.api = api;
        taken = of_api = true;
      }
    for (const Encoding e : maps::encodings)
      if (part == name_of(e)) {
        c.options.encoding = e;
        taken = of_encoding = true;
      }
    if (taken) continue;
    if (part == "special")
      c.options.special = true;
    else if (part == "share")
      c.options.share = true;
    else if (part.starts_with("base="))
      c.options.base = number_of(part, 5);
    else if (part.starts_with("bound="))
      c.options.bound = number_of(part, 6);
    else if (part.starts_with("before:"))
      c.before.push_back(map_of_text(part.substr(7)));
    else
      c.maps.push_back(map_of_text(part));
  }
  if (!of_api || !of_encoding || !spec::array::takes(c.options.api, c.options.encoding))
    throw BadCase("'" + text.substr(0, 60) + "': begin with an API and an encoding that it takes, khr,u8");
  if (c.options.base > c.before.size()) throw BadCase("a base triangle beyond the records before");
  return c;
}

std::string text_of_sample(std::uint64_t seed, std::uint64_t k) {
  return fmt::format("sample:{}:{}", seed, k);
}

std::pair<std::uint64_t, std::uint64_t> sample_of(const std::string& text) {
  const Groups parts = groups_of(text, "sample:([0-9]{1,19}):([0-9]{1,19})");
  if (!parts) throw BadCase("'" + text.substr(0, 60) + "': write sample:SEED:K");
  return {std::stoull((*parts)[1]), std::stoull((*parts)[2])};
}

}  // namespace mmverify::proofs::array
