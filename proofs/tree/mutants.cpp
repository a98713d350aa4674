#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

Map map_in(const Functions& real, const Code& code) { return {code.level, code.format, real.decode(code)}; }

}  // namespace

Change encodes_another(std::function<void(Map&)> spoil) {
  return [=](Functions& functions) {
    functions.encode = [spoil, real = functions.encode](Map map) {
      spoil(map);
      return real(map);
    };
  };
}

Change decodes_wrongly(std::function<void(const Map&, Bytes&)> spoil) {
  return [=](Functions& functions) {
    functions.decode = [spoil, real = functions](const Code& code) {
      const Map map = map_in(real, code);
      Bytes decoded = map.packed;
      spoil(map, decoded);
      return decoded;
    };
  };
}

Change finds_wrongly(std::function<void(const Map&, std::uint32_t, std::uint8_t&)> spoil) {
  return [=](Functions& functions) {
    functions.lookup = [spoil, real = functions](const Code& code, std::span<const std::uint32_t> index,
                                                 std::span<std::uint8_t> state) {
      real.lookup(code, index, state);
      const Map map = map_in(real, code);
      for (std::size_t k = 0; k < index.size(); ++k) spoil(map, index[k], state[k]);
    };
  };
}

Change finds_points_wrongly(std::function<void(const Map&, float, float, std::uint8_t&)> spoil) {
  return [=](Functions& functions) {
    functions.point = [spoil, real = functions](const Code& code, std::span<const float> u,
                                                std::span<const float> v, std::span<std::uint8_t> state) {
      real.point(code, u, v, state);
      const Map map = map_in(real, code);
      for (std::size_t k = 0; k < u.size(); ++k) spoil(map, u[k], v[k], state[k]);
    };
  };
}

Change writes_wrongly(std::function<void(const Map&, Bytes&)> spoil) {
  return [=](Functions& functions) {
    functions.bytes = [spoil, real = functions](const Code& code) {
      Bytes bytes = real.bytes(code);
      spoil(map_in(real, code), bytes);
      return bytes;
    };
  };
}

Change opens_wrongly(std::function<std::optional<Code>(const Functions&, Level, Format,
                                                       std::span<const std::uint8_t>, std::optional<Code>)>
                         instead) {
  return [=](Functions& functions) {
    functions.open = [instead, real = functions](Level n, Format f, std::span<const std::uint8_t> bytes) {
      return instead(real, n, f, bytes, real.open(n, f, bytes));
    };
  };
}

}  // namespace mmverify::proofs::tree
