#include <cstring>

#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/combinations.hpp"
#include "proofs/traverse/subject.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/dock/elements.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::traverse {
namespace {

using dock::Call;
using dock::Library;
using dock::LibraryPtr;

static_assert(static_cast<std::uint32_t>(Api::ext_pipeline) == MMVERIFY_EXT_PIPELINE);
static_assert(static_cast<std::uint32_t>(Api::dxr_query) == MMVERIFY_DXR_QUERY);
static_assert(static_cast<std::uint32_t>(Outcome::non_opaque) == MMVERIFY_NON_OPAQUE);

static_assert(static_cast<std::uint32_t>(Operation::over) == MMVERIFY_BLEND_OVER);

using Key = std::array<std::uint32_t, 3>;
Key key_of(const Combination& c) {
  const Words w = words_of(c);
  return {w.candidate, w.instance, w.ray};
}

/// A library's answers about candidates of one API, in one batch.
std::vector<std::uint8_t> asked(const Library& library, Api api, const std::vector<Combination>& all) {
  std::vector<std::uint32_t> candidates, instances, rays;
  for (const Combination& c : all) {
    const Words w = words_of(c);
    candidates.push_back(w.candidate);
    instances.push_back(w.instance);
    rays.push_back(w.ray);
  }
  std::vector<std::uint8_t> codes(all.size());
  dock::ask_all(library,
                {Call::traverse_decide,
                 0,
                 static_cast<std::uint32_t>(api),
                 {candidates.data(), instances.data(), rays.data()},
                 [&](std::size_t k) { return text_of(all[k]); }},
                all.size(), codes.data());
  return codes;
}

/// The answers to all defined combinations; each API is asked once, at its first combination.
class Answers {
 public:
  explicit Answers(LibraryPtr library) : library_(std::move(library)) {}

  std::uint8_t operator()(const Combination& c) {
    const std::lock_guard hold(lock_);
    auto& of_api = known_[c.api];
    if (of_api.empty()) {
      std::vector<Combination> all;
      for (const Combination& one : defined())
        if (one.api == c.api) all.push_back(one);
      // Combinations with equal flags follow each other, with all kinds of micromap data: a library that works on
      // several at a time may mix these up.
      std::stable_sort(all.begin(), all.end(), [](const Combination& a, const Combination& b) {
        const Words x = words_of(a), y = words_of(b);
        return std::pair(x.instance, x.ray) < std::pair(y.instance, y.ray);
      });
      const std::vector<std::uint8_t> codes = asked(*library_, c.api, all);
      for (std::size_t k = 0; k < all.size(); ++k) of_api.emplace(key_of(all[k]), codes[k]);
    }
    const auto answer = of_api.find(key_of(c));
    return answer != of_api.end() ? answer->second : asked(*library_, c.api, {c}).front();
  }

 private:
  LibraryPtr library_;
  std::mutex lock_;
  std::map<Api, std::map<Key, std::uint8_t>> known_;
};

/// A payload or a value, as the cases of laws write it.
std::string text_of_word(std::uint32_t word) {
  return fmt::format("{} {} {} {}", word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24);
}

void blend(const Library& library, Operation o, std::span<const std::uint32_t> payload,
           std::span<const std::uint32_t> value, std::span<std::uint32_t> out) {
  dock::ask_all(library,
                {Call::traverse_blend,
                 0,
                 static_cast<std::uint32_t>(o),
                 {payload.data(), value.data()},
                 [&](std::size_t k) {
                   return fmt::format("{} of payload {} and {}", name_of(o), text_of_word(payload[k]),
                                      text_of_word(value[k]));
                 }},
                out.size(), out.data());
}

std::string text_of_hits(Operation o, std::uint32_t payload, std::span<const Hit> hits) {
  std::string text = fmt::format("blending by {} into {}", name_of(o), text_of_word(payload));
  for (const Hit& h : hits)
    text += h.accepted
                ? fmt::format(", accepted at {}", number_of_distance(h.distance))
                : fmt::format(", {} at {}", text_of_word(word_of(h.value)), number_of_distance(h.distance));
  return text;
}

spec::traverse::Colour gather(const Library& library, Operation o, const spec::traverse::Colour& payload,
                              std::span<const Hit> hits) {
  mmverify_blend_case_t what{};
  what.size = sizeof what;
  what.operation = static_cast<std::uint32_t>(o);
  what.payload = word_of(payload);
  what.count = static_cast<std::uint32_t>(hits.size());
  std::vector<std::uint8_t> blob(sizeof what + hits.size() * sizeof(mmverify_hit_t));
  std::memcpy(blob.data(), &what, sizeof what);
  std::uint8_t* to = blob.data() + sizeof what;
  for (const Hit& h : hits) {
    const mmverify_hit_t hit{number_of_distance(h.distance), h.accepted ? 1u : 0u, word_of(h.value)};
    std::memcpy(to, &hit, sizeof hit);
    to += sizeof hit;
  }
  spec::traverse::Colour out{};
  const dock::Answer answer =
      dock::ask(library, {Call::traverse_blend_hits, 0, what.operation, blob, out.size()},
                [&] { return text_of_hits(o, what.payload, hits); });
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = answer.bytes[c];
  return out;
}

Functions functions_of(const LibraryPtr& library) {
  Functions f;
  if (library->offers(Call::traverse_blend))
    f.blend = [library](Operation o, std::span<const std::uint32_t> payload,
                        std::span<const std::uint32_t> value,
                        std::span<std::uint32_t> out) { blend(*library, o, payload, value, out); };
  if (library->offers(Call::traverse_blend_hits))
    f.gather = [library](Operation o, const spec::traverse::Colour& payload, std::span<const Hit> hits) {
      return gather(*library, o, payload, hits);
    };
  if (library->offers(Call::traverse_decide))
    f.decide = [answers = std::make_shared<Answers>(library)](const Combination& c) {
      return static_cast<Outcome>(
          (*answers)(c));  // a code that is no outcome is wrong, and named by its number
    };
  return f;
}

}  // namespace

TraverseSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::traverse)) return nullptr;
  return std::make_shared<TraverseSubject>(name, library->about(), functions_of(library),
                                           library->fingerprint());
}

}  // namespace mmverify::proofs::traverse
