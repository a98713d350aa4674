// Packed maps of the built-in subjects.
#include "impl/attribute/compress.hpp"
#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace fast = mmverify::impl::attribute;

fast::PackedShape library_shape(const PackedShape& shape) {
  return {static_cast<fast::MapAt>(shape.at), shape.level, shape.channels, shape.maps, shape.error};
}

/// The numbers of one channel of a map at a level: of faces parents of parents, of vertices the first ones.
std::vector<std::int32_t> numbers_at(const PackedShape& shape, std::vector<std::int32_t> numbers,
                                     Level level) {
  for (Level m = shape.level; m > level && shape.at == MapAt::faces; --m) {
    for (std::size_t k = 0; 4 * k < numbers.size(); ++k)
      numbers[k] = spec::attribute::family_of(
                       {numbers[4 * k], numbers[4 * k + 1], numbers[4 * k + 2], numbers[4 * k + 3]})
                       .parent;
    numbers.resize(numbers.size() / 4);
  }
  numbers.resize(static_cast<std::size_t>(spec::attribute::values_of(shape.at, level)));
  return numbers;
}

/// All values of all levels, worked out at once.
ValueReader specified_reader(const PackedShape& shape, ByteView bytes) {
  const auto codes = spec::attribute::unpack(shape, bytes);
  const auto values = static_cast<std::size_t>(spec::attribute::values_of(shape.at, shape.level));
  auto all = std::make_shared<std::vector<std::vector<std::int32_t>>>();
  for (std::size_t map = 0; codes && map < shape.maps; ++map)
    for (Level m = 0; m <= shape.level; ++m)
      for (std::size_t c = 0; c < shape.channels; ++c) {
        std::vector<std::int32_t> numbers;
        for (std::size_t x = 0; x < values; ++x)
          numbers.push_back(spec::attribute::number_of_code((*codes)[(map * values + x) * shape.channels + c],
                                                            shape.error[c]));
        all->push_back(numbers_at(shape, std::move(numbers), m));
      }
  return [shape, all](std::uint32_t map, Level level, std::uint32_t index) {
    std::array<std::uint8_t, 4> value{};
    for (std::size_t c = 0; c < shape.channels; ++c)
      value[c] = static_cast<std::uint8_t>(spec::attribute::code_of_number(
          (*all)[(map * (shape.level + 1) + level) * shape.channels + c][index], shape.error[c]));
    return value;
  };
}

std::optional<Bytes> library_unpack(const PackedShape& shape, ByteView bytes) {
  try {
    return fast::PackedMaps(library_shape(shape), bytes).codes();
  } catch (const fast::BadPacked&) {
    return std::nullopt;
  }
}

}  // namespace

Compression specified_compression() {
  return {spec::attribute::pack, spec::attribute::unpack, specified_reader};
}

Compression library_compression() {
  Compression f;
  f.pack = [](const PackedShape& shape, ByteView codes) { return fast::pack(library_shape(shape), codes); };
  f.unpack = library_unpack;
  f.reader = [](const PackedShape& shape, ByteView bytes) -> ValueReader {
    const auto maps = std::make_shared<const fast::PackedMaps>(library_shape(shape), bytes);
    return [maps](std::uint32_t map, Level level, std::uint32_t index) {
      return maps->value(map, level, index);
    };
  };
  return f;
}

}  // namespace mmverify::proofs::attribute
