// Code that the foreign subjects of topic index share, and their rows.
#pragma once

#include <memory>
#include <span>

#include "proofs/index/subject.hpp"
#include "tests/foreign/inside/curve.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {

// Rounded arithmetic.
InsideRows faults_of_rounding();
InsideRows right_rounding();

class Hand {
 public:
  Hand(Fault fault, proofs::index::Arithmetic arithmetic, Level max_level)
      : fault(fault), arithmetic(arithmetic), max_level(max_level) {}

  const Fault fault;
  const proofs::index::Arithmetic arithmetic;
  const Level max_level;
};

/// The functions that the hand has.
template <class Of>
proofs::index::Functions functions_of(const Of& hand) {
  proofs::index::Functions f;
  f.arithmetic = hand.arithmetic;
  f.max_level = hand.max_level;
  std::span<std::uint32_t> to;
  if constexpr (requires { hand.batch(); }) f.batch = hand.batch();
  if constexpr (requires { hand.index(Level{}, proofs::index::Batch{}, to); })
    f.index = [hand](Level n, proofs::index::Batch batch, auto out) { hand.index(n, batch, out); };
  if constexpr (requires { hand.index(Level{}, proofs::index::FloatBatch{}, to); })
    f.index_floats = [hand](Level n, proofs::index::FloatBatch batch, auto out) {
      hand.index(n, batch, out);
    };
  if constexpr (requires { hand.index_rows(Level{}, Level{}, std::span<const proofs::points::Row>{}, to); })
    f.index_rows = [hand](Level n, Level grid, auto rows, auto out) { hand.index_rows(n, grid, rows, out); };
  if constexpr (requires(const proofs::points::RationalPoint& p) { hand.index(Level{}, p); })
    f.index_at = [hand](Level n, const proofs::points::RationalPoint& p) { return hand.index(n, p); };
  if constexpr (requires { hand.row_index(Level{}, proofs::index::Batch{}, to); })
    f.row_index = [hand](Level n, proofs::index::Batch batch, auto out) { hand.row_index(n, batch, out); };
  if constexpr (requires { hand.row_corners(Level{}, to, std::span<proofs::index::Corners>{}); })
    f.row_corners = [hand](Level n, auto indices, auto out) { hand.row_corners(n, indices, out); };
  if constexpr (requires { Of::max_wide_level; }) {
    f.max_wide_level = Of::max_wide_level;
    f.wide_index = [hand](Level n, const proofs::points::Row& row, auto out) {
      hand.wide_index(n, row, out);
    };
    f.wide_index_at = [hand](Level n, const proofs::points::RationalPoint& p) {
      return hand.wide_index(n, p);
    };
  }
  return f;
}

template <class Of, class... Arguments>
InsideFault fault(const char* law, const char* name, const char* wrong, proofs::Levels levels,
                  Arguments... arguments) {
  return {
      law, name, wrong,
      std::make_shared<proofs::index::IndexSubject>(name, "by another hand", functions_of(Of(arguments...))),
      levels};
}

}  // namespace mmverify::tests::foreign
