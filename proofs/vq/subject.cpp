#include "proofs/vq/subject.hpp"

#include "impl/vq/vq.hpp"

namespace mmverify::proofs::vq {
namespace {

namespace slow = mmverify::spec::vq;
namespace fast = mmverify::impl::vq;

// ---- The specification

template <std::size_t side>
Vectors<side> specified_vectors() {
  Vectors<side> v;
  v.valid = slow::valid<side>;
  v.applied = slow::applied<side>;
  if constexpr (side == 2) {
    v.decode = [](Code4, std::uint32_t code) { return slow::decode_mini(code); };
    v.encode = [](Code4, const Vector<2>& vector) { return slow::encode_mini(vector); };
  } else {
    v.decode = slow::decode_vector;
    v.encode = slow::encode_vector;
  }
  return v;
}

template <class Format>
Codec<Format> specified_codec() {
  Codec<Format> c;
  c.bytes = slow::bytes<Format>;
  c.fields = slow::from_bytes<Format>;
  c.decode = [](const BlockBytes<Format>& block) { return slow::decode(slow::from_bytes<Format>(block)); };
  c.regions = [](const BlockBytes<Format>& block, auto x, auto y, auto state) {
    const Format fields = slow::from_bytes<Format>(block);
    for (std::size_t k = 0; k < state.size(); ++k) state[k] = slow::decode_region(fields, {x[k], y[k]});
  };
  return c;
}

Functions specified() {
  return {specified_vectors<2>(), specified_vectors<4>(), slow::composed, specified_codec<Vq2>(),
          specified_codec<Vq4>()};
}

// ---- impl/vq: states have the specification's numbers

template <class Format>
using FastMap = std::array<fast::State, std::tuple_size_v<Map<Format>>>;

template <class Format>
FastMap<Format> to_fast(const Map<Format>& map) {
  return std::bit_cast<FastMap<Format>>(map);
}

/// Its decoders, and what `encode` does as the encoder.
template <class Format>
Codec<Format> decoders() {
  Codec<Format> c;
  c.decode = [](const BlockBytes<Format>& block) { return std::bit_cast<Map<Format>>(fast::decode(block)); };
  c.regions = [](const BlockBytes<Format>& block, auto x, auto y, auto state) {
    for (std::size_t k = 0; k < state.size(); ++k)
      state[k] = static_cast<State>(fast::region(block, x[k], y[k]));
  };
  return c;
}

template <class Format, class Encode>
auto encoding(Encode encode) {
  return [encode](const Map<Format>& map) {
    const auto encoded = encode(to_fast<Format>(map));
    return Encoded<Format>{encoded.block, encoded.substitutions};
  };
}

template <class Format, class Encode>
auto substitutions_of(Encode encode) {
  return [encode](const Map<Format>& map) { return encode(to_fast<Format>(map)).substitutions; };
}

constexpr auto optimal2 = [](const fast::Map2& map) { return fast::encode_optimal(map); };
constexpr auto paper2 = [](const fast::Map2& map) { return fast::encode_paper(map); };
constexpr auto highest_first2 = [](const fast::Map2& map) { return fast::encode_paper_highest_first(map); };
constexpr auto paper4 = [](const fast::Map4& map) { return fast::encode_paper(map); };
constexpr auto free_c4 = [](const fast::Map4& map) { return fast::encode_paper_free_c(map); };
constexpr auto fast4 = [](const fast::Map4& map) { return fast::encode(map, fast::Effort::fast); };
constexpr auto balanced4 = [](const fast::Map4& map) { return fast::encode(map, fast::Effort::balanced); };
constexpr auto thorough4 = [](const fast::Map4& map) { return fast::encode(map, fast::Effort::thorough); };
constexpr auto proved4 = [](const fast::Map4& map) { return fast::encode_proved(map).encoded; };
constexpr auto bound4 = [](const Map<Vq4>& map) { return fast::encode_proved(to_fast<Vq4>(map)).least; };

VqSubjectPtr subject(const char* name, const char* about, const Functions& functions) {
  return std::make_shared<VqSubject>(name, about, functions);
}

VqSubjectPtr decoding() {
  Functions functions;
  functions.vq2 = decoders<Vq2>();
  functions.vq4 = decoders<Vq4>();
  return subject("vq", "this project's library, its decoders", functions);
}

template <class Format>
VqSubjectPtr encoder(const char* name, const char* about, Codec<Format> codec) {
  Functions functions;
  functions.codec<Format>() = std::move(codec);
  return subject(name, about, functions);
}

}  // namespace

const std::vector<VqSubjectPtr>& built_in_subjects() {
  static const std::vector<VqSubjectPtr> all{
      subject("vq-spec", "the specification: vectors, codes, blocks and both decoders", specified()),
      decoding(),
      encoder<Vq2>("vq2-optimal", "this project's library, the fewest substitutions",
                   {.encode = encoding<Vq2>(optimal2),
                    .keeps_what_fits = true,
                    .fewest = true,
                    .at_most = substitutions_of<Vq2>(paper2)}),
      encoder<Vq2>("vq2-paper", "Algorithm 1 as printed", {.encode = encoding<Vq2>(paper2)}),
      encoder<Vq2>("vq2-paper-highest-first", "Algorithm 1, the vector with the highest score first",
                   {.encode = encoding<Vq2>(highest_first2)}),
      encoder<Vq4>("vq4-fast", "this project's library, the least effort",
                   {.encode = encoding<Vq4>(fast4), .keeps_what_fits = true}),
      encoder<Vq4>("vq4-balanced", "this project's library, more effort",
                   {.encode = encoding<Vq4>(balanced4),
                    .keeps_what_fits = true,
                    .at_most = substitutions_of<Vq4>(fast4)}),
      encoder<Vq4>("vq4-thorough", "this project's library, the most effort without a bound",
                   {.encode = encoding<Vq4>(thorough4),
                    .keeps_what_fits = true,
                    .at_most = substitutions_of<Vq4>(balanced4)}),
      encoder<Vq4>("vq4-proved", "this project's library, beside a bound that no block undercuts",
                   {.encode = encoding<Vq4>(proved4),
                    .keeps_what_fits = true,
                    .at_most = substitutions_of<Vq4>(thorough4),
                    .at_least = bound4}),
      encoder<Vq4>("vq4-paper", "Algorithm 2 as printed", {.encode = encoding<Vq4>(paper4)}),
      encoder<Vq4>("vq4-paper-free-c", "Algorithm 2, its all-C partition without an entry",
                   {.encode = encoding<Vq4>(free_c4)}),
  };
  return all;
}

}  // namespace mmverify::proofs::vq
