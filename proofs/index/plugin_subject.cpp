#include "proofs/index/plugin_subject.hpp"

#include <fmt/format.h>

#include <cstring>

#include "proofs/index/rounded_subject.hpp"

namespace mmverify::proofs::index {
namespace {

using dock::Borrowed;
using dock::Call;
using dock::LibraryPtr;
using dock::Misbehaved;
using dock::Worker;

template <class T>
void put(const Worker& worker, Call call, std::size_t array, std::uint64_t count, const T* from) {
  for (std::uint64_t t = 0; t < count; t += dock::batch_size) {
    const std::size_t piece = dock::in_slot(count, static_cast<std::size_t>(t / dock::batch_size));
    std::memcpy(worker.input(call, array, count, t), from + t, piece * sizeof(T));
  }
}

std::string point_text(double u, double v) { return fmt::format("u={:a},v={:a}", u, v); }

class PluginSubject : public IndexSubject {
 public:
  PluginSubject(std::string name, LibraryPtr library, Arithmetic arithmetic)
      : IndexSubject(std::move(name), library->about(), arithmetic, library->description().max_level),
        library_(std::move(library)) {}

  std::string fingerprint() const override { return library_->fingerprint(); }

  bool has(Entry e) const override {
    switch (e) {
      case Entry::index:
        return offers(point_call());
      case Entry::corners:
        return offers(Call::corners);
      case Entry::row_index:
        return offers(Call::row_index_f32) && arithmetic() == Arithmetic::binary32;
      case Entry::row_corners:
        return offers(Call::row_corners);
      case Entry::wide_index:
        return false;
    }
    return false;
  }

  std::size_t batch() const override { return dock::capacity; }

  RationalPoint receive(const RationalPoint& p) const override {
    if (arithmetic() == Arithmetic::binary64) return {rational(nearest(p.u)), rational(nearest(p.v))};
    return {rational(static_cast<float>(nearest(p.u))), rational(static_cast<float>(nearest(p.v)))};
  }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    ask_points(point_call(), n, batch, out);
  }
  void index_rows(Level n, Level grid, std::span<const Row> rows,
                  std::span<std::uint32_t> out) const override {
    std::vector<Row> command;
    std::size_t count = 0;
    const auto run = [&] {
      ask(
          n, point_call(), count, [&](Worker& w, Call call) { place_rows(w, call, count, grid, command); },
          out.data());
      out = out.subspan(count);
      command.clear();
      count = 0;
    };
    for (const Row& row : rows)
      for (std::uint64_t from = 0; from < row.count;) {
        const std::uint64_t piece = std::min<std::uint64_t>(row.count - from, dock::capacity - count);
        command.push_back(Cells::cut(row, from, piece));
        count += piece;
        from += piece;
        if (count == dock::capacity) run();
      }
    if (count != 0) run();
  }
  void row_index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    ask_points(Call::row_index_f32, n, batch, out);
  }
  void row_index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    ask_pairs(Call::row_index_f32, n, batch, out);
  }
  std::uint32_t row_index(Level n, const RationalPoint& p) const override {
    return ask_point(Call::row_index_f32, n, p);
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    ask_pairs(point_call(), n, batch, out);
  }
  void index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const override {
    ask_pairs(point_call(), n, batch, out);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const override {
    return ask_point(point_call(), n, p);
  }
  void corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    ask_corners(Call::corners, n, indices, out);
  }
  void row_corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    ask_corners(Call::row_corners, n, indices, out);
  }

 private:
  bool offers(Call call) const { return library_->offers(call); }
  Call point_call() const { return arithmetic() == Arithmetic::binary64 ? Call::index_f64 : Call::index_f32; }

  template <class Piece>
  static void in_pieces(std::size_t size, Piece piece) {
    for (std::size_t from = 0; from < size; from += dock::capacity)
      piece(from, std::min(dock::capacity, size - from));
  }

  /// Writes points straight to where the worker reads them; at(t) gives u and v.
  template <class At>
  static void place_points(Worker& worker, Call call, std::size_t count, At at) {
    const auto fill = [&](auto number) {
      using T = decltype(number);
      for (std::size_t from = 0; from < count; from += dock::batch_size) {
        auto* u = reinterpret_cast<T*>(worker.input(call, 0, count, from));
        auto* v = reinterpret_cast<T*>(worker.input(call, 1, count, from));
        const std::size_t piece = std::min(dock::batch_size, count - from);
        for (std::size_t t = 0; t < piece; ++t) {
          const auto [pu, pv] = at(from + t);
          u[t] = static_cast<T>(pu);
          v[t] = static_cast<T>(pv);
        }
      }
    };
    if (call == Call::index_f64)
      fill(double{});
    else
      fill(float{});
  }

  /// The same for the representatives of rows, which floats hold exactly: k / (4 2^grid) has at most 19 bits.
  static void place_rows(Worker& worker, Call call, std::size_t count, Level grid,
                         std::span<const Row> rows) {
    const auto fill = [&](auto number) {
      using T = decltype(number);
      const T scale = T(1) / static_cast<T>(std::uint32_t{4} << grid);
      std::size_t done = 0;
      for (const Row& row : rows)
        for (std::uint64_t from = 0; from < row.count;) {
          const std::uint64_t piece =
              std::min<std::uint64_t>(row.count - from, dock::batch_size - done % dock::batch_size);
          auto* u = reinterpret_cast<T*>(worker.input(call, 0, count, done));
          auto* v = reinterpret_cast<T*>(worker.input(call, 1, count, done));
          const T kv = static_cast<T>(row.kv) * scale;
          auto k = static_cast<std::int32_t>(row.ku + static_cast<std::int64_t>(from) * row.stride);
          for (std::uint64_t t = 0; t < piece; ++t, k += static_cast<std::int32_t>(row.stride)) {
            u[t] = static_cast<T>(k) * scale;
            v[t] = kv;
          }
          done += piece;
          from += piece;
        }
    };
    if (call == Call::index_f64)
      fill(double{});
    else
      fill(float{});
  }

  void ask_points(Call call, Level n, Batch batch, std::span<std::uint32_t> out) const {
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      const GridPoint* p = batch.points.data() + from;
      constexpr double scale = 1.0 / (1 << Fixed64::fraction_bits);
      const auto at = [p](std::size_t t) {
        return std::pair{static_cast<double>(p[t].u.raw()) * scale,
                         static_cast<double>(p[t].v.raw()) * scale};
      };
      ask(
          n, call, count, [&](Worker& w, Call c) { place_points(w, c, count, at); }, out.data() + from);
    });
  }

  /// Pairs of floats or doubles; a call that takes floats rounds doubles.
  template <class Pairs>
  void ask_pairs(Call call, Level n, const Pairs& batch, std::span<std::uint32_t> out) const {
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      const auto at = [u = batch.u.data() + from, v = batch.v.data() + from](std::size_t t) {
        return std::pair{double{u[t]}, double{v[t]}};
      };
      ask(
          n, call, count, [&](Worker& w, Call c) { place_points(w, c, count, at); }, out.data() + from);
    });
  }

  std::uint32_t ask_point(Call call, Level n, const RationalPoint& p) const {
    std::uint32_t answer = 0;
    const std::pair at{nearest(p.u), nearest(p.v)};
    ask(
        n, call, 1, [&](Worker& w, Call c) { place_points(w, c, 1, [&at](std::size_t) { return at; }); },
        &answer);
    return answer;
  }

  void ask_corners(Call call, Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const {
    static_assert(sizeof(Corners) == dock::entry_point(Call::corners).answer_bytes);
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      ask(
          n, call, count, [&](Worker& w, Call c) { put(w, c, 0, count, indices.data() + from); },
          out.data() + from);
    });
  }

  /// Runs one command; `place` writes the inputs, the answers go to `out`.
  template <class Place, class Number>
  void ask(Level n, Call call, std::size_t count, Place place, Number* out) const {
    Borrowed borrowed(library_->pool());
    Worker& worker = *borrowed;
    place(worker, call);
    try {
      worker.ask(call, n, count);
    } catch (const Misbehaved& found) {
      // pin_down leaves the inputs of a new worker, so the text is made from a fresh copy.
      place(worker, call);
      throw SubjectBroken(
          fmt::format("{} at level {} {}", found.what, n, elements(worker, call, count, found)));
    }
    for (std::size_t from = 0; from < count; from += dock::batch_size)
      std::memcpy(out + from, worker.answer(call, count, from),
                  std::min(dock::batch_size, count - from) * sizeof(Number));
    borrowed.give_back();
  }

  static std::string element(const Worker& worker, Call call, std::uint64_t count, std::uint64_t t) {
    const auto read = [&](std::size_t array, auto number) {
      std::memcpy(&number, worker.input(call, array, count, t), sizeof number);
      return number;
    };
    switch (call) {
      case Call::index_f64:
        return point_text(read(0, double{}), read(1, double{}));
      case Call::index_f32:
      case Call::row_index_f32:
        return point_text(double{read(0, float{})}, double{read(1, float{})});
      default:
        break;
    }
    return fmt::format("k={}", read(0, std::uint32_t{}));
  }

  static std::string elements(const Worker& worker, Call call, std::uint64_t count, const Misbehaved& found) {
    const std::string first = element(worker, call, count, found.first);
    if (found.count == 1) return "on case " + first;
    return fmt::format("in the batch of {} cases from {} to {}", found.count, first,
                       element(worker, call, count, found.first + found.count - 1));
  }

  LibraryPtr library_;
};

}  // namespace

std::vector<std::shared_ptr<const IndexSubject>> plugin_subjects(const LibraryPtr& library) {
  const auto offers = [&](Call call) { return library->offers(call); };
  std::vector<std::shared_ptr<const IndexSubject>> subjects;
  // A library without any index still has corners or rows to judge.
  const bool others = offers(Call::corners) || offers(Call::row_index_f32) || offers(Call::row_corners);
  if (offers(Call::index_f32) || (others && !offers(Call::index_f64)))
    subjects.push_back(std::make_shared<PluginSubject>(library->path(), library, Arithmetic::binary32));
  if (offers(Call::index_f64))
    subjects.push_back(std::make_shared<PluginSubject>(
        subjects.empty() ? library->path() : library->path() + ":f64", library, Arithmetic::binary64));
  return subjects;
}

}  // namespace mmverify::proofs::index
