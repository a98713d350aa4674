// The extension module mmverify._core: the library behind NumPy arrays.  The package's Python files check what users
// pass, and have the documentation; this file checks what the library would read or write beyond.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "impl/mmverify.hpp"

namespace py = pybind11;
using namespace mmverify::impl;

namespace {

using Floats = py::array_t<float, py::array::c_style>;
using Words = py::array_t<std::uint32_t, py::array::c_style>;
using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

void need(bool holds, const char* fault) {
  if (!holds) throw py::value_error(fault);
}

template <class T>
std::span<const T> view(const py::array_t<T, py::array::c_style>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

template <class T>
std::span<T> room(py::array_t<T, py::array::c_style>& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

micromap::Format format_of(unsigned states) {
  need(states == 2 || states == 4, "states: 2 or 4");
  return states == 2 ? micromap::Format::two_state : micromap::Format::four_state;
}

std::size_t size_of(std::uint64_t count, micromap::Format format) {
  return static_cast<std::size_t>(micromap::packed_bytes(count, format));
}

Words find_index(std::uint32_t level, const Floats& u, const Floats& v) {
  Words found(u.size());
  const auto out = room(found);
  const auto us = view(u), vs = view(v);
  const py::gil_scoped_release released;
  index::from_barycentrics(us, vs, level, out);
  return found;
}

/// The corners (i, j) of each index, six numbers: i0 j0 i1 j1 i2 j2.
Words find_corners(std::uint32_t level, const Words& index) {
  const std::size_t count = static_cast<std::size_t>(index.size());
  Words found({index.size(), py::ssize_t{6}});
  const auto out = room(found);
  const auto indices = view(index);
  const py::gil_scoped_release released;
  std::vector<std::uint32_t> lists(6 * count);
  const auto list = [&](std::size_t k) { return std::span(lists).subspan(k * count, count); };
  index::corners(indices, level, {list(0), list(1), list(2), list(3), list(4), list(5)});
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < 6; ++c) out[6 * k + c] = lists[c * count + k];
  return found;
}

Bytes pack(const Bytes& codes, unsigned states) {
  const auto format = format_of(states);
  const auto from = view(codes);
  Bytes packed(static_cast<py::ssize_t>(size_of(from.size(), format)));
  const auto out = room(packed);
  const py::gil_scoped_release released;
  micromap::pack({reinterpret_cast<const micromap::State*>(from.data()), from.size()}, format, out);
  return packed;
}

Bytes unpack(const Bytes& packed, std::size_t count, unsigned states) {
  const auto format = format_of(states);
  const auto from = view(packed);
  need(from.size() >= size_of(count, format), "packed: fewer bytes than the states take");
  Bytes codes(static_cast<py::ssize_t>(count));
  const auto out = room(codes);
  const py::gil_scoped_release released;
  micromap::unpack(from, format, {reinterpret_cast<micromap::State*>(out.data()), out.size()});
  return codes;
}

/// One mip level, a two-dimensional array that need not be contiguous: rows at any distance, columns side by side.
template <class Texel>
bake::Texels texels_of(const py::array& mip) {
  const auto size = static_cast<py::ssize_t>(sizeof(Texel));
  need(mip.strides(1) == size && mip.strides(0) >= size && mip.strides(0) % size == 0, "alpha: strides");
  return bake::TexelView<Texel>{
      static_cast<const Texel*>(mip.data()), static_cast<std::uint32_t>(mip.shape(1)),
      static_cast<std::uint32_t>(mip.shape(0)), static_cast<std::size_t>(mip.strides(0) / size)};
}

/// The same where another channel's bytes lie between the columns.
bake::PixelView pixels_of(const py::array& mip) {
  const py::ssize_t step = mip.strides(1);
  need(step >= 1 && step <= 16 && mip.strides(0) >= step * mip.shape(1), "alpha: strides");
  return {static_cast<const std::uint8_t*>(mip.data()),
          static_cast<std::uint32_t>(mip.shape(1)),
          static_cast<std::uint32_t>(mip.shape(0)),
          static_cast<std::size_t>(mip.strides(0)),
          static_cast<std::uint32_t>(step),
          0};
}

struct Sampler {
  bake::AlphaMode mode;
  bake::Sampling sampling;
};

bake::TriangleBaker baker_of(const std::vector<py::array>& mips, const Sampler& how) {
  for (const py::array& mip : mips)
    need(mip.ndim() == 2 && mip.dtype().equal(mips[0].dtype()), "alpha: mips");
  const bool bytes = !mips.empty() && py::isinstance<py::array_t<std::uint8_t>>(mips[0]);
  if (bytes && std::any_of(mips.begin(), mips.end(), [](const auto& mip) { return mip.strides(1) != 1; })) {
    std::vector<bake::PixelView> views;
    for (const py::array& mip : mips) views.push_back(pixels_of(mip));
    const py::gil_scoped_release released;
    return bake::TriangleBaker(views, how.mode, how.sampling);
  }
  std::vector<bake::Texels> views;
  for (const py::array& mip : mips) {
    const bool words = py::isinstance<py::array_t<std::uint16_t>>(mip);
    need(bytes || words || py::isinstance<py::array_t<float>>(mip), "alpha: dtype");
    views.push_back(bytes   ? texels_of<std::uint8_t>(mip)
                    : words ? texels_of<std::uint16_t>(mip)
                            : texels_of<float>(mip));
  }
  const py::gil_scoped_release released;
  return bake::TriangleBaker(views, how.mode, how.sampling);
}

/// Calls job(0) to job(count - 1) on so many threads.  The jobs throw nothing.
void on_threads(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) job(k);
  };
  std::vector<std::jthread> others;
  for (std::size_t t = 1; t < std::min(threads, count); ++t) others.emplace_back(work);
  work();
}

/// A baked map in the form that was asked for.
void write_map(const micromap::PackedMap& map, micromap::Format format, bool packed,
               std::span<std::uint8_t> out) {
  const std::uint64_t count = micromap::micro_triangles(map.level);
  if (!packed) {
    micromap::unpack(map.bytes, map.format, {reinterpret_cast<micromap::State*>(out.data()), out.size()});
    if (format == micromap::Format::two_state)
      for (std::uint8_t& code : out) code &= 1;  // force-2
  } else if (format == micromap::Format::two_state) {
    micromap::force2(map.bytes, count, out);
  } else {
    std::copy_n(map.bytes.begin(), out.size(), out.begin());
  }
}

/// The maps of all triangles, one behind the other: a byte a state, or packed.
Bytes bake_maps(const std::vector<py::array>& mips, const Floats& uv, const Words& levels, unsigned states,
                bool packed, std::size_t threads, const Sampler& how) {
  const auto format = format_of(states);
  const auto numbers = view(uv);
  const auto level = view(levels);
  need(numbers.size() == 6 * level.size(), "uv: six numbers a triangle");
  std::vector<std::size_t> ends{0};
  for (const std::uint32_t n : level) {
    need(n <= bake::max_bake_level, "level: above 12");
    const std::uint64_t count = micromap::micro_triangles(n);
    ends.push_back(ends.back() + (packed ? size_of(count, format) : static_cast<std::size_t>(count)));
  }
  Bytes out(static_cast<py::ssize_t>(ends.back()));
  const auto bytes = room(out);
  const bake::TriangleBaker baker = baker_of(mips, how);
  const py::gil_scoped_release released;
  std::vector<bake::BaseTriangle> triangles(level.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangles[t][k] = {numbers[6 * t + 2 * k], numbers[6 * t + 2 * k + 1]};
  const auto parallel = [threads](std::size_t count, const auto& job) { on_threads(threads, count, job); };
  const bake::MeshMaps baked = bake::bake_mesh(baker, triangles, level, parallel);
  parallel(level.size(), [&](std::size_t t) {
    write_map(baked.maps[t], format, packed, bytes.subspan(ends[t], ends[t + 1] - ends[t]));
  });
  return out;
}

Words useful_levels(const Floats& uv, std::uint32_t width, std::uint32_t height, std::uint32_t limit) {
  const auto numbers = view(uv);
  Words levels(uv.size() / 6);
  const auto out = room(levels);
  const py::gil_scoped_release released;
  for (std::size_t t = 0; t < out.size(); ++t) {
    bake::BaseTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = {numbers[6 * t + 2 * k], numbers[6 * t + 2 * k + 1]};
    out[t] = bake::useful_level(triangle, width, height, limit).level;
  }
  return levels;
}

Bytes bytes_of(const void* from, std::size_t size) {
  Bytes bytes(static_cast<py::ssize_t>(size));
  std::copy_n(static_cast<const std::uint8_t*>(from), size, bytes.mutable_data());
  return bytes;
}

template <class Row>
Bytes rows_of(const std::vector<Row>& rows) {
  return bytes_of(rows.data(), rows.size() * sizeof(Row));
}

/// The buffers of an array, each as its bytes: records, data, indices, histogram, the geometry's histogram or None.
py::tuple build_array(const std::vector<Bytes>& packed, const Words& levels, unsigned states,
                      const array::BuildOptions& options) {
  const auto format = format_of(states);
  need(packed.size() == static_cast<std::size_t>(levels.size()), "maps: a level for each");
  std::vector<micromap::PackedMap> maps;
  for (std::size_t t = 0; t < packed.size(); ++t) {
    const std::uint32_t level = view(levels)[t];
    need(level <= bake::max_bake_level, "maps: a level above 12");
    need(view(packed[t]).size() == size_of(micromap::micro_triangles(level), format), "maps: bytes of a map");
    maps.push_back({level, format, view(packed[t])});
  }
  const array::Built built = [&] {
    const py::gil_scoped_release released;
    return array::build({}, maps, options);
  }();
  const py::object geometry =
      built.geometry_counts ? py::object(rows_of(*built.geometry_counts)) : py::none();
  return py::make_tuple(rows_of(built.array.records), rows_of(built.array.data), rows_of(built.part.indices),
                        rows_of(built.array_counts), geometry);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.attr("version") = MMVERIFY_VERSION;
  module.def("index", &find_index);
  module.def("corners", &find_corners);
  module.def("pack", &pack);
  module.def("unpack", &unpack);
  module.def("useful_levels", &useful_levels);
  module.def("bake", [](const std::vector<py::array>& mips, const Floats& uv, const Words& levels,
                        unsigned states, bool packed, std::size_t threads,
                        const std::variant<std::pair<std::uint32_t, std::uint32_t>, float, py::none>& cutoff,
                        std::pair<unsigned, unsigned> wrap, bool nearest, float border,
                        std::array<float, 2> factors, float margin) {
    need(wrap.first <= 4 && wrap.second <= 4, "wrap: 0 to 4");
    bake::AlphaMode mode = bake::Blend{};
    if (const auto* quotient = std::get_if<0>(&cutoff))
      mode = bake::Cutoff{quotient->first, quotient->second};
    if (const auto* number = std::get_if<1>(&cutoff)) mode = bake::Mask{*number};
    const auto filter = nearest ? bake::Filter::nearest : bake::Filter::bilinear;
    const bake::Sampling sampling{static_cast<bake::Wrap>(wrap.first),
                                  static_cast<bake::Wrap>(wrap.second),
                                  filter,
                                  border,
                                  factors,
                                  margin};
    return bake_maps(mips, uv, levels, states, packed, threads, {mode, sampling});
  });
  module.def("build", [](const std::vector<Bytes>& packed, const Words& levels, unsigned states, unsigned api,
                         unsigned encoding, bool special, bool share, std::uint32_t bound) {
    need(api < array::api_count && encoding <= 4, "api, index_type: beyond their lists");
    return build_array(packed, levels, states,
                       {.api = static_cast<array::Api>(api),
                        .encoding = static_cast<micromap::Encoding>(encoding),
                        .special = special,
                        .share = share,
                        .bound = bound});
  });
}
