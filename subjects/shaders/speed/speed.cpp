#include "subjects/shaders/speed/speed.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>

#include "impl/attribute/lookup.hpp"
#include "impl/dag/container.hpp"
#include "impl/dag/dag.hpp"
#include "impl/index/index.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "impl/vq/vq.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/compile/includes.hpp"

namespace mmverify::shaders {
namespace {

using impl::micromap::Format;

/// Time of a call in ns per lookup: wall time, the best of three turns.
template <class Call>
double ns_each(double seconds, std::size_t lookups, const Call& call) {
  using Clock = std::chrono::steady_clock;
  double best = 0;
  for (int turn = 0; turn < 3; ++turn) {
    std::size_t calls = 0;
    double passed = 0;
    for (const auto begin = Clock::now(); passed < seconds;
         passed = std::chrono::duration<double>(Clock::now() - begin).count(), ++calls)
      call();
    const double ns = 1e9 * passed / static_cast<double>(calls * lookups);
    best = turn == 0 ? ns : std::min(best, ns);
  }
  return best;
}

/// The shaders of a file on the device. A subject is valid until the next file is opened.
class OnDevice {
 public:
  OnDevice(const std::string& file, std::uint32_t device)
      : compiled_(compile({include_root() + "/shaders/subjects/" + file, {}, device})) {
    const std::string library = device_library();
    void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) throw NotAvailable(library + ": " + dlerror());
    setenv(manifest_variable, compiled_.manifest_file.c_str(), 1);
    const auto open = reinterpret_cast<const mmverify_subject_t* (*)()>(dlsym(handle, "mmverify_subject_v1"));
    subject_ = open();
    unsetenv(manifest_variable);
    if (subject_ != nullptr) return;
    const auto why = reinterpret_cast<const char* (*)()>(dlsym(handle, "mmverify_subject_v1_not_here"));
    throw NotAvailable(why());
  }
  const mmverify_subject_t* operator->() const { return subject_; }

 private:
  Compiled compiled_;
  const mmverify_subject_t* subject_ = nullptr;
};

class Measuring {
 public:
  explicit Measuring(const SpeedOptions& options) : options_(options) {
    std::mt19937 random(static_cast<std::uint32_t>(options.seed));
    for (std::size_t k = 0; k < options.batch; ++k) {
      const float a = static_cast<float>(random() >> 8) * 0x1p-24f,
                  b = static_cast<float>(random() >> 8) * 0x1p-24f;
      u_.push_back(a + b <= 1 ? a : 1 - a);
      v_.push_back(a + b <= 1 ? b : 1 - b);
      x_.push_back(static_cast<std::uint32_t>(random() % 32));
      y_.push_back(static_cast<std::uint32_t>(random() % 32));
    }
  }

  Speeds all() {
    // Ranked trees first: a subject keeps the functions that an earlier file offered.
    trees("tree_ranked.glsl", true);
    trees("tree.glsl", false);
    graphs();
    const auto of_trees = static_cast<std::ptrdiff_t>(made_.rows.size());
    indices();
    std::rotate(made_.rows.begin(), made_.rows.begin() + of_trees, made_.rows.end());
    blocks();
    attributes();
    return std::move(made_);
  }

 private:
  template <class T, class Device, class Cpu>
  void add(const std::string& function, std::optional<std::uint32_t> level, std::size_t values,
           const Device& device, const Cpu& cpu, bool is_ours = true) {
    if (options_.progress) options_.progress(function + (level ? " level " + std::to_string(*level) : ""));
    std::vector<T> got(options_.batch * values), right(options_.batch * values);
    const auto of_cpu = [&] {
      for (std::size_t k = 0; k < options_.batch; ++k) cpu(k, &right[k * values]);
    };
    device(got.data());
    of_cpu();
    Speed speed{.function = function, .level = level};
    for (std::size_t k = 0; k < options_.batch; ++k)
      speed.differing += !std::equal(&got[k * values], &got[k * values] + values, &right[k * values]);
    speed.device_ns = ns_each(options_.seconds, options_.batch, [&] { device(got.data()); });
    if (is_ours) speed.cpu_ns = ns_each(options_.seconds, options_.batch, of_cpu);
    made_.rows.push_back(std::move(speed));
  }

  void about(const OnDevice& opened) {
    if (!made_.about.empty() || opened->runs_on == nullptr) return;
    std::string text = opened->runs_on;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string line = text.substr(at, end - at);
      if (const auto colon = line.find(": "); colon != std::string::npos)
        made_.about.emplace_back(line.substr(0, colon), line.substr(colon + 2));
      at = end + 1;
    }
  }

  std::vector<std::uint32_t> levels() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t level = options_.first; level <= options_.last; level += 4) all.push_back(level);
    return all;
  }

  void indices() {
    const OnDevice exact("index.glsl", options_.device);
    about(exact);
    for (const std::uint32_t level : levels())
      add<std::uint32_t>(
          "index, exact", level, 1,
          [&](std::uint32_t* out) { exact->index_f32(level, u_.data(), v_.data(), out, u_.size()); },
          [&](std::size_t k, std::uint32_t* out) {
            *out = impl::index::from_barycentrics(u_[k], v_[k], level);
          });
    for (const std::uint32_t level : levels())
      add<std::uint32_t>(
          "index, rows", level, 1,
          [&](std::uint32_t* out) { exact->row_index_f32(level, u_.data(), v_.data(), out, u_.size()); },
          [&](std::size_t k, std::uint32_t* out) { *out = impl::index::w_minor(u_[k], v_[k], level); });
    const OnDevice published("index_published.glsl", options_.device);
    for (const std::uint32_t level : levels())
      add<std::uint32_t>(
          "index, published", level, 1,
          [&](std::uint32_t* out) { published->index_f32(level, u_.data(), v_.data(), out, u_.size()); },
          [&](std::size_t k, std::uint32_t* out) {
            *out = impl::index::from_barycentrics(u_[k], v_[k], level);
          },
          false);
  }

  /// A map with O inside a disc, T outside, and unknown along the border.
  static std::vector<std::uint8_t> disc(std::uint32_t level) {
    std::vector<std::uint8_t> map(std::max<std::size_t>(1, (std::size_t{2} << 2 * level) / 8));
    const auto side = static_cast<float>(1u << level);
    for (std::uint32_t k = 0; k < 1u << 2 * level; ++k) {
      unsigned inside = 0;
      for (const auto& corner : impl::index::corners(k, level)) {
        const float x = static_cast<float>(corner.i) / side - 0.3f,
                    y = static_cast<float>(corner.j) / side - 0.3f;
        inside += x * x + y * y < 0.06f;
      }
      const unsigned state = inside == 3 ? 1 : inside == 0 ? 0 : 2;
      map[k / 4] = static_cast<std::uint8_t>(map[k / 4] | state << 2 * (k % 4));
    }
    return map;
  }

  void trees(const std::string& file, bool is_ranked) {
    const OnDevice opened(file, options_.device);
    about(opened);
    for (const std::uint32_t level : levels()) {
      if (level > 8) break;  // the paper's lookup goes bit by bit: a call takes seconds
      const std::vector<std::uint8_t> map = disc(level);
      const auto tree = impl::tree::Tree::encode(level, Format::four_state, map);
      const auto stream = impl::tree::encode_stream(level, Format::four_state, map);
      std::vector<std::uint8_t> code(stream.tree);
      code.insert(code.end(), stream.data.begin(), stream.data.end());
      if (is_ranked) {
        code.resize(opened->tree_encode(level, 2, map.data(), nullptr, 0));
        opened->tree_encode(level, 2, map.data(), code.data(), code.size());
      }
      std::vector<std::uint32_t> index;
      for (std::size_t k = 0; k < u_.size(); ++k)
        index.push_back(impl::index::from_barycentrics(u_[k], v_[k], level));
      const auto device = [&](std::uint8_t* out) {
        opened->tree_lookup(level, 2, code.data(), code.size(), index.data(), out, index.size());
      };
      if (is_ranked)
        add<std::uint8_t>("tree, ranked", level, 1, device,
                          [&](std::size_t k, std::uint8_t* out) { *out = tree[index[k]]; });
      else
        add<std::uint8_t>("tree, bit by bit", level, 1, device, [&](std::size_t k, std::uint8_t* out) {
          *out = impl::tree::lookup_stream(level, Format::four_state, stream, index[k]);
        });
    }
  }

  void graphs() {
    const OnDevice opened("dag.glsl", options_.device);
    about(opened);
    for (const std::uint32_t level : levels()) {
      if (level > impl::dag::max_level) break;
      impl::dag::Dag graph(impl::dag::Format::four_state);
      graph.add(level, disc(level));
      const std::vector<std::uint8_t> code = impl::dag::save(graph);
      const std::vector<std::uint32_t> map(u_.size(), 0);
      add<std::uint8_t>(
          "graph", level, 1,
          [&](std::uint8_t* out) {
            opened->dag_lookup_f32(2, code.data(), code.size(), map.data(), u_.data(), v_.data(), out,
                                   u_.size());
          },
          [&](std::size_t k, std::uint8_t* out) { *out = graph.at_point(0, u_[k], v_[k]); });
    }
  }

  template <class Map>
  static Map square(std::uint32_t side) {
    Map map{};
    for (std::uint32_t k = 0; k < map.size(); ++k) {
      const auto x = static_cast<float>(k % side) - 0.4f * static_cast<float>(side),
                 y = static_cast<float>(k / side) - 0.5f * static_cast<float>(side);
      const float r = (x * x + y * y) / static_cast<float>(side * side);
      map[k] = r < 0.05f ? impl::vq::State::O : r > 0.12f ? impl::vq::State::T : impl::vq::State::C;
    }
    return map;
  }

  void blocks() {
    const OnDevice opened("vq.glsl", options_.device);
    const auto block2 = impl::vq::encode_optimal(square<impl::vq::Map2>(16)).block;
    const auto block4 = impl::vq::encode(square<impl::vq::Map4>(32)).block;
    std::vector<std::uint32_t> x2, y2;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      x2.push_back(x_[k] % 16);
      y2.push_back(y_[k] % 16);
    }
    add<std::uint8_t>(
        "VQ2", {}, 1,
        [&](std::uint8_t* out) { opened->vq2_region(block2.data(), x2.data(), y2.data(), out, x2.size()); },
        [&](std::size_t k, std::uint8_t* out) {
          *out = static_cast<std::uint8_t>(impl::vq::region(block2, x2[k], y2[k]));
        });
    add<std::uint8_t>(
        "VQ4", {}, 1,
        [&](std::uint8_t* out) { opened->vq4_region(block4.data(), x_.data(), y_.data(), out, x_.size()); },
        [&](std::size_t k, std::uint8_t* out) {
          *out = static_cast<std::uint8_t>(impl::vq::region(block4, x_[k], y_[k]));
        });
  }

  void attributes() {
    const OnDevice opened("attribute.glsl", options_.device);
    using impl::attribute::VertexOrder;
    for (const auto& [name, order] : {std::pair{"triplet, W-minor", VertexOrder::w_minor},
                                      {"triplet, U-major", VertexOrder::u_major},
                                      {"triplet, Bird", VertexOrder::bird}})
      for (const std::uint32_t level : levels())
        add<std::uint32_t>(
            name, level, 3,
            [&, o = order](std::uint32_t* out) {
              opened->attribute_triplet_f32(level, static_cast<std::uint32_t>(o), u_.data(), v_.data(), out,
                                            u_.size());
            },
            [&, o = order](std::size_t k, std::uint32_t* out) {
              const auto triplet = impl::attribute::triplet(o, u_[k], v_[k], level);
              std::copy(triplet.begin(), triplet.end(), out);
            });
    for (const std::uint32_t level : levels())
      add<float>(
          "weights", level, 3,
          [&](float* out) { opened->attribute_weights_f32(level, u_.data(), v_.data(), out, u_.size()); },
          [&](std::size_t k, float* out) {
            const auto weights = impl::attribute::locate(u_[k], v_[k], level).weights;
            std::copy(weights.begin(), weights.end(), out);
          });
  }

  const SpeedOptions& options_;
  std::vector<float> u_, v_;
  std::vector<std::uint32_t> x_, y_;
  Speeds made_;
};

}  // namespace

Speeds speeds(const SpeedOptions& options) { return Measuring(options).all(); }

}  // namespace mmverify::shaders
