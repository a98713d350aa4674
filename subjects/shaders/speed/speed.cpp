#include "subjects/shaders/speed/speed.hpp"

#include <algorithm>
#include <bit>
#include <chrono>

#include "subjects/shaders/speed/lookups.hpp"
#include "subjects/shaders/speed/on_device.hpp"
#include "subjects/shaders/speed/sample.hpp"

namespace mmverify::shaders {
namespace {

constexpr std::uint32_t word = sizeof(std::uint32_t), most_words = 3;
constexpr std::uint64_t group = 64;  // invocations of a workgroup, of each kernel here

struct Times {
  double median = 0, spread = 0;
};
Times times_of(std::vector<double> ns) {
  std::sort(ns.begin(), ns.end());
  // A coarse clock may see nothing of a short dispatch.
  const double median = std::max(ns[ns.size() / 2], 1.0);
  return {median, (ns.back() - ns.front()) / median};
}

class Measuring {
 public:
  explicit Measuring(const SpeedOptions& options) : options_(options), device_(options.device) {
    made_.about = device_.about();
    made_.is_processor = device_.limits().is_processor;
    made_.runs = made_.is_processor ? 5 : 21;
    bound_hits();
  }

  Speeds all() {
    std::vector<std::uint32_t> levels;
    for (std::uint32_t level = options_.first; level <= options_.last; level += 4) levels.push_back(level);
    progress("maps, trees and a graph");
    const std::vector<Lookup> measured = lookups(levels, made_.is_processor);
    std::vector<Speed> rows;
    for (const Lookup& lookup : measured)
      if (lookup.random_states_bytes <= most_states_bytes()) add(lookup, rows);
    add_plain_copy();
    for (const Speed& copy : made_.rows)
      if (copy.hits == made_.hits)
        made_.bandwidth = std::max(made_.bandwidth, 1e9 * static_cast<double>(copy.hits) *
                                                        (copy.bytes_in + copy.bytes_out) / copy.ns);
    made_.rows.insert(made_.rows.end(), rows.begin(), rows.end());
    return std::move(made_);
  }

 private:
  void progress(const std::string& step) const {
    if (options_.progress) options_.progress(step);
  }

  /// The greatest power of two of hits that the device takes.
  void bound_hits() {
    const KernelLimits& limits = device_.limits();
    constexpr std::uint64_t by_default = std::uint64_t{1} << 28, on_processor = std::uint64_t{1} << 20;
    std::uint64_t most = options_.hits != 0 ? options_.hits : made_.is_processor ? on_processor : by_default;
    const auto bound = [&](std::uint64_t by, const char* why) {
      if (by >= most) return;
      most = by;
      made_.bounded_by = why;
    };
    bound(limits.groups * group, "workgroups in a dispatch (maxComputeWorkGroupCount)");
    bound(limits.buffer_bytes / (most_words * word), "bytes of a buffer (maxStorageBufferRange)");
    // Half of the memory: others may use the rest.
    bound(limits.memory_bytes / 2 / (2 * most_words * word), "the device's memory");
    made_.hits = std::bit_floor(most);
  }

  /// A larger flat map is left out.
  std::uint64_t most_states_bytes() const {
    const KernelLimits& limits = device_.limits();
    return std::min({limits.buffer_bytes, limits.groups * group * word, limits.memory_bytes / 4});
  }

  std::vector<std::uint64_t> sizes(const Lookup& lookup) const {
    constexpr std::uint64_t step = 64, least = std::uint64_t{1} << 16;
    std::vector<std::uint64_t> all{std::min(made_.hits, lookup.most_hits)};
    while (all.front() / step >= least) all.insert(all.begin(), all.front() / step);
    return all;
  }

  void reserve(const Lookup& lookup, std::uint64_t hits) {
    for (std::uint32_t k = 0; k < lookup.words_in; ++k) device_.reserve(k, hits * word);
    device_.reserve(answer_binding, hits * word * lookup.words_out);
  }

  void make_inputs(const Lookup& lookup, std::uint64_t hits, Order order) {
    device_.load("kernels/inputs.glsl", "index_f32");
    const std::uint32_t level = lookup.inputs == Inputs::square ? lookup.side : lookup.level.value_or(0);
    device_.dispatch({static_cast<std::uint32_t>(hits), level, static_cast<std::uint32_t>(lookup.inputs),
                      order == Order::shuffled, static_cast<std::uint32_t>(std::countr_zero(hits))});
  }

  void make_code(const Lookup& lookup) {
    if (!lookup.code.empty()) {
      device_.reserve(bytes_binding, lookup.code.size());
      device_.write(bytes_binding, lookup.code);
    }
    if (lookup.random_states_bytes == 0) return;
    constexpr std::uint32_t kind_of_states = 4;
    device_.reserve(bytes_binding, lookup.random_states_bytes);
    device_.load("kernels/inputs.glsl", "index_f32");
    device_.dispatch(
        {static_cast<std::uint32_t>(lookup.random_states_bytes / word), 0, kind_of_states, 0, 0});
  }

  /// A graphics card takes some time to raise its clock from that of an idle one, so runs before that do not count.
  template <class Runs>
  Times timed(const Runs& runs) const {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds warm{50};
    for (const auto begin = Clock::now(); !made_.is_processor && Clock::now() - begin < warm;) runs();
    return times_of(runs());
  }

  /// Runs a kernel whose inputs are there, and compares a sample.
  Speed measure(const Lookup& lookup, std::uint64_t hits, Order order, const PushConstants& constants) {
    constexpr std::uint32_t unwritten = 0xA7A7A7A7u;  // no answer is left from a run before
    device_.fill(answer_binding, unwritten);
    device_.load(lookup.file, lookup.entry_point);
    const Times times = timed([&] { return device_.times(constants, made_.runs); });
    return {.kernel = lookup.name,
            .level = lookup.level,
            .hits = hits,
            .order = order,
            .bytes_in = lookup.words_in * word,
            .bytes_out = lookup.words_out * word,
            .ns = times.median,
            .spread = times.spread,
            .checked = compare_sample(device_, lookup, hits, order)};
  }

  void add(const Lookup& lookup, std::vector<Speed>& rows) {
    progress(lookup.name + (lookup.level ? " level " + std::to_string(*lookup.level) : ""));
    for (const std::uint64_t hits : sizes(lookup)) {
      const double copy_ns = copy_time(lookup.words_in, lookup.words_out, hits);
      reserve(lookup, hits);
      make_code(lookup);
      for (const Order order : {Order::coherent, Order::shuffled}) {
        make_inputs(lookup, hits, order);
        rows.push_back(measure(lookup, hits, order,
                               {static_cast<std::uint32_t>(hits), lookup.level.value_or(0), lookup.first, 0,
                                lookup.code_bytes}));
        rows.back().share_of_copy = copy_ns / rows.back().ns;
      }
    }
  }

  /// The copy kernel of so many words a hit; each is measured once.
  double copy_time(std::uint32_t words_in, std::uint32_t words_out, std::uint64_t hits) {
    for (const Speed& copy : made_.rows)
      if (copy.bytes_in == words_in * word && copy.bytes_out == words_out * word && copy.hits == hits)
        return copy.ns;
    const Lookup copy = copy_of(words_in, words_out);
    reserve(copy, hits);
    make_inputs(copy, hits, Order::coherent);
    made_.rows.push_back(
        measure(copy, hits, Order::coherent, {static_cast<std::uint32_t>(hits), 0, 0, 0, 0}));
    made_.rows.back().order.reset();
    made_.rows.back().level.reset();
    return made_.rows.back().ns;
  }

  void add_plain_copy() {
    const std::uint64_t hits = made_.hits;
    device_.reserve(0, hits * word);
    device_.reserve(answer_binding, hits * word);
    const Times times = timed([&] { return device_.copy_times(0, answer_binding, hits * word, made_.runs); });
    made_.rows.push_back({.kernel = "vkCmdCopyBuffer",
                          .hits = hits,
                          .bytes_in = word,
                          .bytes_out = word,
                          .ns = times.median,
                          .spread = times.spread});
  }

  const SpeedOptions& options_;
  OnDevice device_;
  Speeds made_;
};

}  // namespace

Speeds speeds(const SpeedOptions& options) { return Measuring(options).all(); }

}  // namespace mmverify::shaders
