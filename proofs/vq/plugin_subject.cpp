#include "proofs/vq/texts.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::vq {
namespace {

using dock::Call;
using dock::LibraryPtr;

constexpr std::uint32_t no_format = 0;

/// Bytes as the header has them: a state each.
template <class Format>
using Bytes = std::array<std::uint8_t, std::tuple_size_v<Map<Format>>>;

template <class Format>
Codec<Format> codec_of(const LibraryPtr& library, Call decode, Call region, Call encode) {
  constexpr Level n = level_of<Format>;
  Codec<Format> c;
  if (library->offers(decode))
    c.decode = [=](const BlockBytes<Format>& block) {
      Map<Format> map;
      const dock::Answer answer = dock::ask(*library, {decode, n, no_format, block, map.size()},
                                            [&] { return "decoding " + text_of_block<Format>(block); });
      for (std::size_t k = 0; k < map.size(); ++k) map[k] = static_cast<State>(answer.bytes.at(k));
      return map;
    };
  if (library->offers(region))
    c.regions = [=](const BlockBytes<Format>& block, auto x, auto y, auto state) {
      std::vector<std::uint8_t> bytes(state.size());
      dock::look_up(*library,
                    {region,
                     n,
                     no_format,
                     block,
                     {x.data(), y.data()},
                     [&](std::uint64_t k) { return fmt::format("x={},y={}", x[k], y[k]); }},
                    bytes);
      for (std::size_t k = 0; k < state.size(); ++k) state[k] = static_cast<State>(bytes[k]);
    };
  if (library->offers(encode))
    c.encode = [=](const Map<Format>& map) {
      const auto bytes = std::bit_cast<Bytes<Format>>(map);
      Encoded<Format> encoded{};
      const dock::Answer answer = dock::ask(*library, {encode, n, no_format, bytes, encoded.block.size()},
                                            [&] { return "encoding " + text_of_map<Format>(map); });
      for (std::size_t k = 0; k < encoded.block.size(); ++k) encoded.block[k] = answer.bytes.at(k);
      return encoded;
    };
  c.keeps_what_fits = (library->description().flags & MMVERIFY_VQ_KEEPS) != 0;
  return c;
}

}  // namespace

VqSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::vq)) return nullptr;
  Functions functions;
  functions.vq2 = codec_of<Vq2>(library, Call::vq2_decode, Call::vq2_region, Call::vq2_encode);
  functions.vq4 = codec_of<Vq4>(library, Call::vq4_decode, Call::vq4_region, Call::vq4_encode);
  return std::make_shared<VqSubject>(name, library->about(), std::move(functions), library->fingerprint());
}

}  // namespace mmverify::proofs::vq
