#include "proofs/codecs/laws.hpp"

#include <algorithm>
#include <bit>

namespace mmverify::proofs::codecs {
namespace {

using dock::Call;
using Sizes = std::vector<std::uint64_t>;

std::uint64_t states(Level n) { return std::uint64_t{1} << 2 * n; }

/// Bytes of the longest code in the paper's form, with a leaf for each state.
std::uint64_t longest_code(Level n, unsigned format) {
  const std::uint64_t nodes = (4 * states(n) - 1) / 3;
  return (nodes + 7) / 8 + (states(n) * format + 7) / 8;
}

// ---- sizes

Sizes no_size(const Facts&, Level, unsigned) { return {0}; }

/// Room for a code: of the paper's form, or of the codec's own, which may be longer.
Sizes room(const Facts& facts, Level n, unsigned format) {
  const std::uint64_t longest = longest_code(n, format);
  return {(facts.flags & MMVERIFY_TREE_STREAM) != 0 ? longest : 2 * longest + 16};
}

Sizes hostile(const Facts&, Level n, unsigned format) {
  Sizes all;
  for (std::uint64_t size = 0; size <= longest_code(n, format) + 1; ++size) all.push_back(size);
  return all;
}

Sizes counts(const Facts&, Level, unsigned) { return {1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33}; }

/// Records of an array, 1 to 3, with indices of 8 bits; and 2 with each other type.
Sizes bundles(const Facts&, Level, unsigned) { return {1, 2, 3, 6, 10, 14, 18}; }

/// A code of the example of a scene has 12 bytes before its first map.
Sizes short_codes(const Facts&, Level, unsigned) { return {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}; }

Sizes index_types(const Facts&, Level, unsigned) { return {0, 1, 2, 3, 4, 8, 9, 10, 11, 12}; }

/// The same at level 1 alone.
Sizes room_at_level_1(const Facts& facts, Level n, unsigned format) {
  return n == 1 ? room(facts, n, format) : Sizes{};
}

// ---- choices

std::vector<Chosen> map(Level n, unsigned format, std::uint64_t) {
  return {{"", Written::digits, format, states(n)}};
}

std::vector<Chosen> padded(Level, unsigned format, std::uint64_t count) {
  std::vector<Chosen> all{{"", Written::digits, format, count}};
  if (const std::uint64_t used = count * format % 8; used != 0)
    all.push_back({"padding", Written::number, static_cast<unsigned>(8 - used), 1});
  return all;
}
std::vector<Chosen> padded_map(Level n, unsigned format, std::uint64_t) {
  return padded(n, format, states(n));
}

std::vector<Chosen> map_and_buffer(Level n, unsigned format, std::uint64_t size) {
  return {{"", Written::digits, format, states(n)},
          {"before", Written::number, 8, 1},
          {"capacity", Written::number, static_cast<unsigned>(std::bit_width(size)), 1}};
}

std::vector<Chosen> map_and_index(Level n, unsigned format, std::uint64_t) {
  std::vector<Chosen> all{{"", Written::digits, format, states(n)}};
  if (n != 0) all.push_back({"index", Written::number, 2 * n, 1});
  return all;
}

/// Numbers of so many bits, four of each name.
void add_four(std::vector<Chosen>& all, const std::vector<std::string>& names, unsigned bits) {
  for (unsigned k = 1; k <= 4; ++k)
    for (const std::string& name : names) all.push_back({name + std::to_string(k), Written::number, bits, 1});
}

std::vector<Chosen> map_and_indices(Level n, unsigned format, std::uint64_t) {
  std::vector<Chosen> all{{"", Written::digits, format, states(n)}};
  add_four(all, {"index"}, 2 * n);
  return all;
}

std::vector<Chosen> code(Level, unsigned, std::uint64_t size) { return {{"code", Written::bytes, 8, size}}; }

/// A block of VQ2 at level 4, of VQ4 at level 5.
std::vector<Chosen> block(Level n, unsigned, std::uint64_t) {
  return {{"", Written::bytes, 8, n == 4 ? 32u : 64u}};
}
std::vector<Chosen> block_and_region(Level n, unsigned, std::uint64_t) {
  return {{"", Written::bytes, 8, n == 4 ? 32u : 64u},
          {"x", Written::number, n, 1},
          {"y", Written::number, n, 1}};
}
std::vector<Chosen> block_and_regions(Level n, unsigned format, std::uint64_t size) {
  std::vector<Chosen> all = block(n, format, size);
  add_four(all, {"x", "y"}, n);
  return all;
}
std::vector<Chosen> regions(Level n, unsigned, std::uint64_t) {
  return {{"", Written::digits, 2, states(n)}};
}

std::vector<Chosen> two_codes(Level, unsigned, std::uint64_t type) {
  constexpr unsigned widths[] = {8, 16, 32, 16, 32};
  const unsigned width = widths[type & 7];
  std::vector<Chosen> all;
  for (const char* which : {"", "2"})
    for (const auto& [name, bits] :
         {std::pair("code", width), std::pair("base", 32u), std::pair("records", 32u)})
      all.push_back({std::string(name) + which, Written::number, bits, 1});
  all.front().name += type >= 8 ? "_in_cluster" : "";
  all.front().name += std::to_string(type & 7);
  return all;
}

/// Arrays of proofs/codecs/bundle.c, each a byte for the base, one for each of two triangles and two for each record.
std::vector<Chosen> bundle(Level, unsigned, std::uint64_t size) {
  return {{"type" + std::to_string(size / 4), Written::bytes, 8, 3 + 2 * (size & 3)}};
}
std::vector<Chosen> two_bundles(Level, unsigned, std::uint64_t size) {
  return {{"type" + std::to_string(size / 4), Written::bytes, 8, 2 * (3 + 2 * (size & 3))}};
}

std::vector<Chosen> code_and_bytes_before(Level, unsigned, std::uint64_t size) {
  return {{"code", Written::bytes, 8, size}, {"before", Written::number, 8, 1}};
}

// ---- domains

std::string every_map(Level n, unsigned format) {
  return "every map, " + std::to_string(1u << format) + "^" + std::to_string(states(n));
}
std::string every_code(Level n, unsigned format) {
  return "any bytes, 0 to " + std::to_string(longest_code(n, format) + 1) + " of them";
}
std::string every_block(Level n, unsigned) { return n == 4 ? "every block, 2^256" : "every block, 2^512"; }
std::string every_square_map(Level n, unsigned) { return "every map, 3^" + std::to_string(states(n)); }

// ---- the laws

const std::vector<unsigned> both{1, 2}, four{2}, none{0};

Harness of_maps(const char* file, const char* function, std::vector<Call> needs,
                std::vector<unsigned> formats = both) {
  return {file, function, std::move(needs), 0, std::move(formats), no_size, padded_map};
}

/// A law on packed maps at levels from `first`.
CodecLaw on_maps(const char* id, Level first, const char* sampled, std::vector<Harness> harnesses) {
  std::vector<unsigned> formats;
  for (const unsigned format : both)
    if (std::any_of(harnesses.begin(), harnesses.end(), [&](const Harness& h) {
          return std::find(h.formats.begin(), h.formats.end(), format) != h.formats.end();
        }))
      formats.push_back(format);
  return {id, {first, 4}, {first, 6}, false, formats, every_map, sampled, std::move(harnesses)};
}

void add_tree_laws(std::vector<CodecLaw>& all) {
  const auto add = [&](const char* id, Level fast, decltype(CodecLaw::domain) domain, const char* sampled,
                       std::vector<Harness> harnesses) {
    all.push_back({id, {0, fast}, {0, 3}, false, both, std::move(domain), sampled, std::move(harnesses)});
  };
  add("tree.round_trip", 2, every_map, "tree.on_samples",
      {{"tree.c", "round_trip", {Call::tree_encode, Call::tree_decode}, 0, both, room, map},
       {"tree.c", "exact_size", {Call::tree_encode}, 0, both, room, map_and_buffer}});
  add("tree.lookup_is_decode", 2, every_map, "tree.on_samples",
      {{"tree.c", "lookup", {Call::tree_encode, Call::tree_lookup}, 0, both, room, map_and_index},
       {"tree.c",
        "lookups",
        {Call::tree_encode, Call::tree_lookup},
        0,
        both,
        room_at_level_1,
        map_and_indices}});
  add("tree.equals_spec", 2, every_map, "tree.on_samples",
      {{"tree.c", "equals_spec", {Call::tree_encode}, MMVERIFY_TREE_STREAM, both, no_size, map}});
  add("tree.malformed", 2, every_code, "tree.malformed_on_samples",
      {{"tree.c", "malformed", {Call::tree_decode}, 0, both, hostile, code}});
  add("tree.canonical", 2, every_code, "tree.malformed_on_samples",
      {{"tree.c",
        "canonical",
        {Call::tree_encode, Call::tree_decode},
        MMVERIFY_TREE_STREAM,
        both,
        hostile,
        code}});
  const auto from = [&](std::size_t law, const char* file, std::vector<const char*> steps,
                        std::vector<const char*> wholes) {
    all[law].by_contract.push_back({"mmverify_contract_v1", file, std::move(steps), std::move(wholes)});
  };
  from(0, "contract.c", {"step_of_skip", "step_of_read"}, {"encode_by_contract", "decode_by_contract"});
  from(1, "contract.c", {"step_of_skip", "step_of_find"}, {"lookup_by_contract"});
  from(2, "contract.c", {"step_of_spec"}, {"spec_by_contract"});
  from(3, "contract_any.c", {"step_of_any_bits"}, {"decode_any_bytes"});
  from(4, "contract_any.c", {"step_of_any_bits"}, {"decode_any_bytes"});
  // Four sibling leaves, or sixteen states, are no step of the library's own: it writes and reads them at once.
  const auto own = [&](std::size_t law, std::vector<const char*> steps, std::vector<const char*> wholes) {
    wholes.insert(wholes.begin(), {"step_of_put", "step_of_bits", "step_of_pass", "step_of_count"});
    all[law].by_contract.push_back({"_ZN8mmverify4impl4tree6detail10write_nodeERNS2_14SequenceWriterEjm",
                                    "impl_tree.cc", std::move(steps), std::move(wholes), 2, true});
  };
  own(0, {"step_of_read"}, {"encode_by_contract", "decode_by_contract"});
  own(1, {"step_of_find"}, {"lookup_by_contract"});
  own(2, {"step_of_spec"}, {"spec_by_contract"});
}

void add_micromap_laws(std::vector<CodecLaw>& all) {
  constexpr const char* samples = "micromap.on_samples";
  const std::vector<Call> packing{Call::micromap_pack, Call::micromap_unpack};
  all.push_back(on_maps("micromap.packing", 0, samples, {of_maps("micromap.c", "packing", packing)}));
  all.push_back(
      {"micromap.packing_any_count",
       {0, 0},
       {0, 0},
       true,
       both,
       [](Level, unsigned) { return std::string("any states, 1 to 5, 7 to 9, 15 to 17, 31 or 33 of them"); },
       "micromap.packing_any_count_on_samples",
       {{"micromap.c", "packing_any_count", packing, 0, both, counts, padded}}});
  all.push_back(
      on_maps("micromap.force2", 0, samples,
              {of_maps("micromap.c", "force2", {Call::micromap_force2}, four),
               of_maps("micromap.c", "widen", {Call::micromap_widen, Call::micromap_force2}, {1})}));
  all.push_back(on_maps("micromap.up", 0, samples, {of_maps("micromap.c", "up", {Call::micromap_up})}));
  Harness down_up = of_maps("micromap.c", "down_up", {Call::micromap_up, Call::micromap_down});
  down_up.chosen = map;
  all.push_back(on_maps("micromap.down_up", 0, samples, {down_up}));
  all.push_back(on_maps("micromap.down", 1, samples, {of_maps("micromap.c", "down", {Call::micromap_down})}));
  Harness forced = of_maps("micromap.c", "down_force2", {Call::micromap_down, Call::micromap_force2}, four);
  forced.chosen = map;
  all.push_back(on_maps("micromap.down_force2", 1, samples, {forced}));
  all.push_back(on_maps("micromap.modes", 0, samples,
                        {of_maps("micromap.c", "modes", {Call::micromap_through}, four)}));
}

void add_lossy_laws(std::vector<CodecLaw>& all) {
  const auto add = [&](const char* id, const char* function, const char* sampled) {
    all.push_back(on_maps(id, 0, sampled, {of_maps("lossy.c", function, {Call::micromap_substitute}, four)}));
    all.back().long_run.last = 5;
  };
  add("lossy.allowed", "allowed", "lossy.allowed_on_samples");
  add("lossy.conservative", "conservative", "lossy.conservative_on_samples");
  add("lossy.force2_stable", "force2_stable", "lossy.force2_stable_on_samples");
}

/// The calls of VQ2 or VQ4, and the names of their laws.
struct Vq {
  Level level;
  Call decode, region, encode;
  const char *is_map, *random, *conservative, *conservative_samples, *lossless;
};

void add_vq_laws(std::vector<CodecLaw>& all) {
  for (const Vq& vq : {Vq{4, Call::vq2_decode, Call::vq2_region, Call::vq2_encode, "vq2.region_is_map",
                          "vq2.on_random_blocks", "vq2.conservative", "vq2.conservative_on_samples",
                          "vq2.lossless_when_it_fits"},
                       Vq{5, Call::vq4_decode, Call::vq4_region, Call::vq4_encode, "vq4.region_is_map",
                          "vq4.on_random_blocks", "vq4.conservative", "vq4.conservative_on_samples",
                          "vq4.lossless_when_it_fits"}}) {
    const Levels level{vq.level, vq.level};
    all.push_back({vq.is_map,
                   level,
                   level,
                   true,
                   none,
                   every_block,
                   vq.random,
                   {{"vq.c", "any_region", {vq.region}, 0, none, no_size, block_and_region, "block"},
                    {"vq.c", "any_four_regions", {vq.region}, 0, none, no_size, block_and_regions, "block"},
                    {"vq.c", "whole_map", {vq.decode}, 0, none, no_size, block, "block"}}});
    all.push_back({vq.conservative,
                   level,
                   level,
                   true,
                   none,
                   every_square_map,
                   vq.conservative_samples,
                   {{"vq.c", "conservative", {vq.encode}, 0, none, no_size, regions, "map"}}});
    all.push_back({vq.lossless,
                   level,
                   level,
                   true,
                   none,
                   every_block,
                   vq.lossless,
                   {{"vq.c", "lossless", {vq.encode}, MMVERIFY_VQ_KEEPS, none, no_size, block, "block"}}});
  }
}

void add_array_laws(std::vector<CodecLaw>& all) {
  all.push_back({"array.codes",
                 {0, 0},
                 {0, 0},
                 true,
                 none,
                 [](Level, unsigned) {
                   return std::string("two codes of each type, each with any base and number of records");
                 },
                 "array.codes_on_samples",
                 {{"array.c", "codes", {Call::array_resolve}, 0, none, index_types, two_codes, "codes"}}});
  Harness emulates = of_maps("array.c", "emulates", {Call::array_emulate}, four);
  emulates.chosen = map;
  all.push_back(on_maps("array.emulates", 1, "array.emulates_on_samples", {emulates}));
}

void add_bundle_laws(std::vector<CodecLaw>& all) {
  const auto add = [&](const char* id, const char* sampled, Harness harness) {
    all.push_back({id,
                   {0, 0},
                   {0, 0},
                   true,
                   none,
                   [](Level, unsigned) {
                     return std::string("arrays of 1 to 3 records of a byte, 2 triangles, any indices");
                   },
                   sampled,
                   {std::move(harness)}});
  };
  constexpr const char* changes = "array.changes_on_samples";
  add("array.compact", changes,
      {"bundle.c", "compact", {Call::array_compact}, 0, none, bundles, bundle, "bundle"});
  add("array.reorder", changes,
      {"bundle.c", "reorder", {Call::array_reorder}, 0, none, bundles, bundle, "bundle"});
  add("array.concatenate", changes,
      {"bundle.c", "concatenate", {Call::array_concatenate}, 0, none, bundles, two_bundles, "bundles"});
  add("array.files", "array.files_on_samples",
      {"bundle.c", "files", {Call::array_save, Call::array_load}, 0, none, bundles, bundle, "bundle"});
}

void add_dag_laws(std::vector<CodecLaw>& all) {
  all.push_back({"dag.malformed",
                 {0, 0},
                 {0, 0},
                 true,
                 both,
                 [](Level, unsigned) { return std::string("any bytes, 0 to 12 of them"); },
                 "dag.malformed_on_samples",
                 {{"dag.c", "malformed", {Call::dag_decode}, 0, both, short_codes, code_and_bytes_before}}});
}

bool is_about(const Harness& h, const Facts& facts, unsigned format) {
  return std::find(h.formats.begin(), h.formats.end(), format) != h.formats.end() &&
         (facts.flags & h.flag) == h.flag && std::all_of(h.needs.begin(), h.needs.end(), facts.offers);
}

/// Why none of a law's harnesses is about a codec.
std::string lacks(const Harness& h, const Facts& facts) {
  for (const Call call : h.needs)
    if (!facts.offers(call)) return std::string("it has no entry point ") + dock::entry_point(call).name;
  return h.flag == MMVERIFY_TREE_STREAM ? "it does not declare MMVERIFY_TREE_STREAM"
                                        : "it does not declare MMVERIFY_VQ_KEEPS";
}

}  // namespace

const std::vector<CodecLaw>& laws() {
  static const std::vector<CodecLaw> all = [] {
    std::vector<CodecLaw> made;
    add_tree_laws(made);
    add_micromap_laws(made);
    add_lossy_laws(made);
    add_vq_laws(made);
    add_array_laws(made);
    add_bundle_laws(made);
    add_dag_laws(made);
    return made;
  }();
  return all;
}

std::optional<std::string> unfit(const CodecLaw& law, const Facts& facts, Level level, unsigned format) {
  if (std::none_of(law.harnesses.begin(), law.harnesses.end(),
                   [&](const Harness& h) { return is_about(h, facts, format); }))
    return lacks(law.harnesses.front(), facts);
  if (level < law.fast.first) return "it begins at level " + std::to_string(law.fast.first);
  if (std::string(law.id).starts_with("tree.") && level > facts.max_level)
    return "it is defined up to level " + std::to_string(facts.max_level);
  return std::nullopt;
}

std::vector<Question> questions(const CodecLaw& law, const Facts& facts, Level level, unsigned format) {
  std::vector<Question> all;
  for (const Harness& h : law.harnesses) {
    if (!is_about(h, facts, format)) continue;
    const unsigned bits = format == 0 ? 2 : format;
    for (const std::uint64_t size : h.sizes(facts, level, bits))
      all.push_back({h.file, h.function, level, bits, size,
                     h.begins != nullptr ? h.begins : format_name(bits), h.chosen(level, bits, size)});
  }
  return all;
}

std::vector<Question> questions_by_contract(const CodecLaw& law, const Facts& facts, Level level,
                                            unsigned format) {
  std::vector<Question> all;
  const auto how = std::find_if(law.by_contract.begin(), law.by_contract.end(), [&](const ByContract& c) {
    return facts.defines && facts.defines(c.symbol);
  });
  if (how == law.by_contract.end() || level < by_contract_from) return all;
  const auto ask = [&](const char* function, Level n, Level size) {
    all.push_back({how->file, function, n, format, size, format_name(format), {}, true});
  };
  // The entry points first: what does not call the functions of the contract ends there.
  for (const char* whole : how->wholes) ask(whole, level, level);
  for (Level n = how->first; n <= level; ++n)
    for (const char* step : how->steps) ask(step, how->on_a_map ? level : n, n);
  return all;
}

std::string format_name(unsigned format) { return format == 1 ? "2-state" : "4-state"; }

}  // namespace mmverify::proofs::codecs
