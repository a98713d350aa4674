// The pictures of docs/INDEX.md, docs/MICROMAP.md, docs/ATTRIBUTE.md and docs/SUBDIVISION.md, drawn from the specification and the library.
//   document_pictures FOLDER            writes them there
//   document_pictures --check FOLDER    says which of them differ from what is drawn now, exit code 1
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "proofs/drawing/canvas.hpp"
#include "spec/index/index.hpp"
#include "tests/documents/attribute_pictures.hpp"
#include "tests/documents/bleeding_picture.hpp"
#include "tests/documents/subdivision_picture.hpp"

namespace {

using namespace mmverify;
using namespace proofs::drawing;
using impl::micromap::Format, impl::micromap::State;
using Bytes = std::vector<std::uint8_t>;

/// A base triangle of this level on the page: w left below, u right, v on top.
struct View {
  double x, y, size;
  spec::Level level;

  Pixel operator()(double i, double j) const {
    const double N = std::exp2(level);
    return {x + size * (i + j / 2) / N, y + size * std::numbers::sqrt3 / 2 * (1 - j / N)};
  }
  std::vector<Pixel> triangle(std::uint32_t index) const {
    std::vector<Pixel> points;
    for (const auto& c : spec::index::corners(index, level)) points.push_back((*this)(c.i, c.j));
    return points;
  }
  Pixel middle(std::uint32_t index) const {
    Pixel sum{0, 0};
    for (const Pixel& p : triangle(index)) sum = {sum.x + p.x / 3, sum.y + p.y / 3};
    return sum;
  }
};

std::string curve() {
  Canvas canvas(1000, 360, "The curve at levels 1, 2 and 3");
  for (const spec::Level n : {1u, 2u, 3u}) {
    const View view{30 + 325.0 * (n - 1), 40, 290, n};
    const std::uint32_t count = 1u << (2 * n);
    std::vector<Pixel> path;
    for (std::uint32_t k = 0; k < count; ++k) {
      canvas.polygon(view.triangle(k), "none", grey, 1);
      path.push_back(view.middle(k));
    }
    canvas.polygon(path, "none", "#a9b8d6", n == 3 ? 3 : 4, 1, false);
    const double size = n == 1 ? 20 : n == 2 ? 14 : 9;
    for (std::uint32_t k = 0; k < count; ++k)
      canvas.text({path[k].x, path[k].y + size / 3}, fmt::format("{}", k), size, ink, "middle", n < 3);
    canvas.text({view.x + view.size / 2, 330}, fmt::format("level {}", n), 15, ink, "middle");
    if (n > 1) continue;
    canvas.text({view(0, 0).x - 6, view(0, 0).y + 18}, "w = 1", 13);
    canvas.text({view(2, 0).x + 6, view(2, 0).y + 18}, "u = 1", 13, ink, "end");
    canvas.text({view(0, 2).x + 10, view(0, 2).y + 4}, "v = 1", 13);
  }
  return canvas.str();
}

/// Alpha of a leaf: two circles cut, its edge a few texels soft.
Bytes leaf(std::uint32_t side) {
  Bytes alpha;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side, v = (y + 0.5) / side;
      const double inside =
          std::min(0.62 - std::hypot(u + 0.02, v + 0.02), 0.62 - std::hypot(u - 0.58, v - 0.58));
      alpha.push_back(static_cast<std::uint8_t>(std::clamp(127.5 + inside * side * 60, 0.0, 255.0)));
    }
  return alpha;
}

void draw(Canvas& canvas, const View& view, const Bytes& map, Format format, const std::string& title) {
  const char* fills[] = {"#ffffff", blue, "#f3d9c4", vermilion};
  std::vector<State> states(std::size_t{1} << (2 * view.level));
  impl::micromap::unpack(map, format, states);
  for (std::uint32_t k = 0; k < states.size(); ++k)
    canvas.polygon(view.triangle(k), fills[static_cast<std::size_t>(states[k])], grey, 0.6);
  canvas.text({view.x + view.size / 2, view.y + view.size * 0.87 + 26}, title, 14, ink, "middle");
}

std::string states() {
  constexpr std::uint32_t side = 64, level = 4, count = 1u << (2 * level);
  const Bytes texels = leaf(side);
  const impl::bake::TriangleBaker baker(impl::bake::AlphaView{texels.data(), side, side, side},
                                        impl::bake::Cutoff{1, 2});
  Bytes baked(count / 4), coarser(count / 16), forced(count / 8);
  baker.bake({{{0, 0}, {1, 0}, {0, 1}}}, level, baked);
  impl::micromap::down(baked, Format::four_state, count / 4, coarser);
  impl::micromap::force2(baked, count, forced);
  Canvas canvas(1000, 400, "One map: 4-state at level 4, one level down, and forced to 2-state");
  draw(canvas, {20, 40, 300, level}, baked, Format::four_state, "baked: 4-state, level 4");
  draw(canvas, {350, 40, 300, level - 1}, coarser, Format::four_state, "one level down: 4-state, level 3");
  draw(canvas, {680, 40, 300, level}, forced, Format::two_state, "force-2-state, level 4");
  const char* names[] = {"T, transparent", "O, opaque", "UT, unknown, rather transparent",
                         "UO, unknown, rather opaque"};
  const char* fills[] = {"#ffffff", blue, "#f3d9c4", vermilion};
  double x = 60;
  for (std::size_t s = 0; s < 4; ++s) {
    canvas.polygon({{x, 366}, {x + 18, 366}, {x + 18, 382}, {x, 382}}, fills[s], ink, 1);
    canvas.text({x + 26, 379}, names[s], 14);
    x += s < 2 ? 180 : 280;
  }
  return canvas.str();
}

void write(const std::string& file, const std::string& svg) {
  std::ofstream out(file, std::ios::binary);
  if (!(out << svg).flush()) throw std::runtime_error(file + ": cannot be written");
}

/// Whether the file is these very bytes.
bool current(const std::string& file, const std::string& svg) {
  std::ifstream in(file, std::ios::binary);
  return in && std::string(std::istreambuf_iterator<char>(in), {}) == svg;
}

}  // namespace

int main(int argc, char** argv) try {
  const bool check = argc == 3 && std::string(argv[1]) == "--check";
  if (argc != 2 && !check) {
    fmt::print(stderr, "usage: document_pictures [--check] FOLDER\n");
    return 2;
  }
  const std::string folder = argv[argc - 1];
  const std::map<std::string, std::string> pictures{
      {"index.svg", curve()},
      {"micromap.svg", states()},
      {"attribute_orders.svg", tests::attribute_orders()},
      {"attribute_decimation.svg", tests::attribute_decimation()},
      {"attribute_bleeding.svg", tests::attribute_bleeding()},
      {"subdivision.svg", tests::subdivision_curves()}};
  int code = 0;
  for (const auto& [name, svg] : pictures) {
    const std::string file = folder + "/" + name;
    if (!check) {
      write(file, svg);
    } else if (!current(file, svg)) {
      fmt::print(stderr, "{}: not what is drawn now; ./run pictures draws it anew\n", file);
      code = 1;
    }
  }
  return code;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 4;
}
