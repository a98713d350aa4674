// impl/traverse/ against the specification, on any words.
//
// Input: records of 16 bytes, four little-endian words.  A record is a decision: the API and its setup for micromaps,
// the candidate, the instance's flags, the ray's.  It is also a hit: the first word has its distance and whether it is
// accepted, the second its value.  Bytes after the last whole record are ignored.  Decisions are judged alone, then all
// as spans.  All hits belong to one ray, in the order of their records; the ray's payload is the last word of all, its
// operation the remainder of that word's lowest byte.
//
// Covers: impl/traverse/*
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "impl/traverse/blend.hpp"
#include "impl/traverse/decision.hpp"
#include "spec/traverse/blend.hpp"
#include "spec/traverse/decision.hpp"

namespace {

namespace fast = mmverify::impl::traverse;
namespace slow = mmverify::spec::traverse;

struct Record {
  std::uint32_t who, candidate, instance, ray;
};

std::uint32_t word_at(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

void require_equal(const char* what, const Record& r, std::uint32_t expected, std::uint32_t got) {
  if (got == expected) return;
  std::fprintf(stderr, "traverse_differential: %s of %08x %08x %08x %08x: expected %u got %u\n", what, r.who,
               r.candidate, r.instance, r.ray, expected, got);
  std::abort();
}

/// The combination that words encode; unused bits are ignored.  The words do not tell a special index from a
/// map, and the decision does not depend on it.
slow::Combination combination(const Record& r) {
  const auto bit = [](std::uint32_t word, std::uint32_t value) { return (word & value) != 0; };
  slow::Combination c;
  c.api = static_cast<slow::Api>(r.who % slow::apis);
  c.enabled = !slow::has_switch(c.api) || bit(r.who, 0x100);
  c.candidate = {bit(r.candidate, 4) ? slow::Held::special : slow::Held::nothing,
                 static_cast<slow::State>(r.candidate & 3), bit(r.candidate, 8)};
  c.instance = {bit(r.instance, 4), bit(r.instance, 8), bit(r.instance, 16), bit(r.instance, 32)};
  c.ray = {bit(r.ray, 1), bit(r.ray, 2), bit(r.ray, 64), bit(r.ray, 128), bit(r.ray, 1024)};
  return c;
}

void decisions(const std::vector<Record>& records) {
  std::vector<std::uint32_t> candidate, instance, ray;
  for (const Record& r : records) {
    const slow::Combination c = combination(r);
    const slow::Undefined u = slow::undefined(c);
    require_equal("reasons", r, std::uint32_t{u.ray_flags} | u.instance_flags * 2u | u.not_enabled * 4u,
                  fast::undefined(c.enabled, r.candidate, r.instance, r.ray));
    const auto got = static_cast<std::uint32_t>(fast::decide(r.candidate, r.instance, r.ray));
    require_equal("an outcome that is one", r, 1, got < 3);
    if (!u.any()) require_equal("outcome", r, static_cast<std::uint32_t>(slow::decide(c)), got);
    candidate.push_back(r.candidate);
    instance.push_back(r.instance);
    ray.push_back(r.ray);
  }
  std::vector<fast::Outcome> out(records.size());
  fast::decide(candidate, instance, ray, out);
  for (std::size_t k = 0; k < out.size(); ++k)
    require_equal("outcome in a batch", records[k],
                  static_cast<std::uint32_t>(fast::decide(candidate[k], instance[k], ray[k])),
                  static_cast<std::uint32_t>(out[k]));
}

slow::Colour colour(std::uint32_t word) {
  return {word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24};
}
std::uint32_t word(const slow::Colour& c) { return c[0] | c[1] << 8 | c[2] << 16 | c[3] << 24; }

void blends(const std::vector<Record>& records) {
  const std::uint32_t payload = records.back().ray;
  const auto o = payload % 256 % slow::operations;
  std::vector<std::uint32_t> payloads, values;
  std::vector<fast::Hit> hits;
  std::vector<slow::Hit> slow_hits;
  for (const Record& r : records) {
    // binary32 represents these distances exactly.
    const std::uint32_t distance = r.who >> 9;
    const bool accepted = (r.who & 0x80) != 0;
    hits.push_back({static_cast<float>(distance), accepted, r.candidate});
    slow_hits.push_back({distance, accepted, colour(r.candidate)});
    payloads.push_back(r.ray);
    values.push_back(r.candidate);
    require_equal("blend", r,
                  word(slow::blend(static_cast<slow::Operation>(o), colour(r.ray), colour(r.candidate))),
                  fast::blend(static_cast<fast::Operation>(o), r.ray, r.candidate));
  }
  std::vector<std::uint32_t> out(records.size());
  fast::blend(static_cast<fast::Operation>(o), payloads, values, out);
  for (std::size_t k = 0; k < out.size(); ++k)
    require_equal("blend in a batch", records[k],
                  fast::blend(static_cast<fast::Operation>(o), payloads[k], values[k]), out[k]);
  require_equal(
      "payload after all hits", records.back(),
      word(slow::blended_before_closest(static_cast<slow::Operation>(o), colour(payload), slow_hits)),
      fast::blended(static_cast<fast::Operation>(o), payload, hits));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<Record> records;
  for (; size >= 16; data += 16, size -= 16)
    records.push_back({word_at(data), word_at(data + 4), word_at(data + 8), word_at(data + 12)});
  if (records.empty()) return 0;
  decisions(records);
  blends(records);
  return 0;
}
