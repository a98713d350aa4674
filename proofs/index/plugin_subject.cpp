#include <cstring>

#include "proofs/index/subjects/rounded_subject.hpp"
#include "subjects/dock/elements.hpp"

namespace mmverify::proofs::index {
namespace {

using dock::Borrowed;
using dock::Call;
using dock::LibraryPtr;
using dock::Worker;

template <class T>
void put(const Worker& worker, Call call, std::size_t array, std::uint64_t count, const T* from) {
  for (std::uint64_t t = 0; t < count; t += dock::batch_size) {
    const std::size_t piece = dock::in_slot(count, static_cast<std::size_t>(t / dock::batch_size));
    std::memcpy(worker.input(call, array, count, t), from + t, piece * sizeof(T));
  }
}

std::string point_text(double u, double v) { return fmt::format("u={:a},v={:a}", u, v); }

/// Puts questions to a library, in whole batches.
class Questions {
 public:
  explicit Questions(LibraryPtr library)
      : library_(std::move(library)), begun_(std::make_shared<std::array<std::once_flag, dock::calls>>()) {}

  void rows(Call call, Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out) const {
    std::vector<Row> command;
    std::size_t count = 0;
    const auto run = [&] {
      ask(
          n, call, count, [&](Worker& w, Call c) { place_rows(w, c, count, grid, command); }, out.data());
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

  void points(Call call, Level n, Batch batch, std::span<std::uint32_t> out) const {
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

  /// Asks for pairs of floats or doubles; a call that takes floats rounds doubles.
  template <class Pairs>
  void pairs(Call call, Level n, const Pairs& batch, std::span<std::uint32_t> out) const {
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      const auto at = [u = batch.u.data() + from, v = batch.v.data() + from](std::size_t t) {
        return std::pair{double{u[t]}, double{v[t]}};
      };
      ask(
          n, call, count, [&](Worker& w, Call c) { place_points(w, c, count, at); }, out.data() + from);
    });
  }

  std::uint32_t point(Call call, Level n, const RationalPoint& p) const {
    std::uint32_t answer = 0;
    const std::pair at{nearest(p.u), nearest(p.v)};
    ask(
        n, call, 1, [&](Worker& w, Call c) { place_points(w, c, 1, [&at](std::size_t) { return at; }); },
        &answer);
    return answer;
  }

  void corners(Call call, Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const {
    static_assert(sizeof(Corners) == dock::entry_point(Call::corners).answer_bytes);
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      ask(
          n, call, count, [&](Worker& w, Call c) { put(w, c, 0, count, indices.data() + from); },
          out.data() + from);
    });
  }

 private:
  template <class Piece>
  static void in_pieces(std::size_t size, Piece piece) {
    for (std::size_t from = 0; from < size; from += dock::capacity)
      piece(from, std::min(dock::capacity, size - from));
  }

  /// Writes points directly to the worker's input; at(t) gives u and v.
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

  /// Writes the representatives of rows, which floats hold exactly: k / (4 2^grid) has at most 19 bits.
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

  /// Makes the first call of an entry point reveal races.  Two threads may see a table half full that a library fills
  /// at its first call.  So that call, made by the worker from two threads, covers all that may be filled, its end
  /// first, and not only the one micro-triangle of level 0.  A library may have tables for some levels or for all, so
  /// two levels run, each in a process of its own.
  void begin(Call call) const {
    std::call_once((*begun_)[static_cast<std::size_t>(call)], [&] {
      const Level last = library_->description().max_level;
      for (const Level n : {last, std::min(last, first_level)}) try {
          library_->pool().give_back(library_->pool().fresh());
          if (dock::entry_point(call).signature.of_points)
            ask_of_all_points(n, call);
          else
            ask_of_last_indices(n, call);
          const Borrowed of_no_more_use(library_->pool());
        } catch (const dock::CaseBroken&) {
          // The law that reaches this case reports it.
        }
    });
  }

  void ask_of_last_indices(Level n, Call call) const {
    const std::uint64_t all = triangle_count(n), count = std::min<std::uint64_t>(all, dock::batch_size);
    std::vector<std::uint32_t> last;
    for (std::uint64_t k = 0; k < count; ++k) last.push_back(static_cast<std::uint32_t>(all - 1 - k));
    std::vector<Corners> out(last.size());
    run(
        n, call, last.size(), [&](Worker& w, Call c) { put(w, c, 0, last.size(), last.data()); }, out.data());
  }

  void ask_of_all_points(Level n, Call call) const {
    constexpr std::size_t side = 64;
    std::vector<std::pair<double, double>> points;
    for (std::size_t v = side; v-- > 0;)
      for (std::size_t u = side - v; u-- > 0;)
        points.emplace_back((static_cast<double>(u) + 0.25) / side, (static_cast<double>(v) + 0.25) / side);
    std::vector<std::uint32_t> out(points.size());
    const auto at = [&](std::size_t t) { return points[t]; };
    run(
        n, call, points.size(), [&](Worker& w, Call c) { place_points(w, c, points.size(), at); },
        out.data());
  }

  template <class Place, class Number>
  void ask(Level n, Call call, std::size_t count, Place place, Number* out) const {
    begin(call);
    run(n, call, count, place, out);
  }

  /// Runs one command; `place` writes the inputs, and the answers go to `out`.
  template <class Place, class Number>
  void run(Level n, Call call, std::size_t count, Place place, Number* out) const {
    Borrowed worker =
        dock::ask(*library_, {call, n, count, [&](Worker& w) { place(w, call); },
                              [&](const Worker& w, std::uint64_t t) { return element(w, call, count, t); }});
    for (std::size_t from = 0; from < count; from += dock::batch_size)
      std::memcpy(out + from, worker->answer(call, count, from),
                  std::min(dock::batch_size, count - from) * sizeof(Number));
    worker.give_back();
  }

  static std::string element(const Worker& worker, Call call, std::uint64_t count, std::uint64_t t) {
    const auto read = [&](std::size_t array, auto number) {
      std::memcpy(&number, worker.input(call, array, count, t), sizeof number);
      return number;
    };
    switch (call) {
      case Call::index_f64: return point_text(read(0, double{}), read(1, double{}));
      case Call::index_f32:
      case Call::row_index_f32: return point_text(double{read(0, float{})}, double{read(1, float{})});
      default: break;
    }
    return fmt::format("k={}", read(0, std::uint32_t{}));
  }

  static constexpr Level first_level = 8;
  LibraryPtr library_;
  std::shared_ptr<std::array<std::once_flag, dock::calls>> begun_;
};

Functions functions_of(const LibraryPtr& library, Arithmetic arithmetic) {
  const auto offers = [&](Call call) { return library->offers(call); };
  const bool doubles = arithmetic == Arithmetic::binary64;
  const Call call = doubles ? Call::index_f64 : Call::index_f32;
  const Questions ask(library);
  Functions f;
  f.arithmetic = arithmetic;
  f.max_level = library->description().max_level;
  f.batch = dock::capacity;
  f.receive_at = [doubles](const RationalPoint& p) -> RationalPoint {
    if (doubles) return {rational(nearest(p.u)), rational(nearest(p.v))};
    return {rational(static_cast<float>(nearest(p.u))), rational(static_cast<float>(nearest(p.v)))};
  };
  if (offers(call)) {
    f.index = [ask, call](Level n, Batch batch, auto out) { ask.points(call, n, batch, out); };
    f.index_rows = [ask, call](Level n, Level grid, auto rows, auto out) {
      ask.rows(call, n, grid, rows, out);
    };
    f.index_floats = [ask, call](Level n, FloatBatch batch, auto out) { ask.pairs(call, n, batch, out); };
    f.index_doubles = [ask, call](Level n, DoubleBatch batch, auto out) { ask.pairs(call, n, batch, out); };
    f.index_at = [ask, call](Level n, const RationalPoint& p) { return ask.point(call, n, p); };
  }
  const std::uint32_t flags = library->description().flags;
  f.corner_order = (flags & MMVERIFY_CORNERS_OF_CHILDREN) != 0 ? CornerOrder::of_children
                   : (flags & MMVERIFY_CORNERS_BASE_U_V) != 0  ? CornerOrder::base_u_v
                                                               : CornerOrder::undeclared;
  if (offers(Call::corners))
    f.corners = [ask](Level n, auto indices, auto out) { ask.corners(Call::corners, n, indices, out); };
  if (offers(Call::row_index_f32) && arithmetic == Arithmetic::binary32) {
    f.row_index = [ask](Level n, Batch batch, auto out) { ask.points(Call::row_index_f32, n, batch, out); };
    f.row_index_floats = [ask](Level n, FloatBatch batch, auto out) {
      ask.pairs(Call::row_index_f32, n, batch, out);
    };
    f.row_index_at = [ask](Level n, const RationalPoint& p) { return ask.point(Call::row_index_f32, n, p); };
  }
  if (offers(Call::row_corners))
    f.row_corners = [ask](Level n, auto indices, auto out) {
      ask.corners(Call::row_corners, n, indices, out);
    };
  return f;
}

IndexSubjectPtr subject(const std::string& name, const LibraryPtr& library, Arithmetic arithmetic) {
  return std::make_shared<IndexSubject>(name, library->about(), functions_of(library, arithmetic),
                                        library->fingerprint());
}

}  // namespace

std::vector<IndexSubjectPtr> plugin_subjects(const LibraryPtr& library) {
  const auto offers = [&](Call call) { return library->offers(call); };
  std::vector<IndexSubjectPtr> subjects;
  // A library without an index may still have corners or rows to judge.
  const bool others = offers(Call::corners) || offers(Call::row_index_f32) || offers(Call::row_corners);
  if (offers(Call::index_f32) || (others && !offers(Call::index_f64)))
    subjects.push_back(subject(library->path(), library, Arithmetic::binary32));
  if (offers(Call::index_f64))
    subjects.push_back(subject(subjects.empty() ? library->path() : library->path() + ":f64", library,
                               Arithmetic::binary64));
  return subjects;
}

}  // namespace mmverify::proofs::index
