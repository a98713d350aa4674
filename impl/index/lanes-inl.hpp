// The steps of impl/index/index.hpp from two floats to an index, in vectors.  This text is included inside a namespace
// with hn, its tags Floats, Ints and Words, and FloatVec, IntVec and WordVec.  There hn is Highway; to prove
// `index.floats`, the same text runs on an hn whose functions write formulas.  The steps are exact for the reasons
// given there.

HWY_INLINE FloatVec clamped(FloatVec x) {
  const Floats d;
  return hn::Min(hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), x), hn::Set(d, 1.0f));
}

HWY_INLINE FloatVec scaled(FloatVec x, FloatVec N) { return hn::Mul(clamped(x), N); }

// 1 if the mask is set, else 0: a set mask is all ones, which is -1.
HWY_INLINE IntVec one_if(hn::Mask<Ints> mask) {
  const Ints di;
  return hn::Sub(hn::Zero(di), hn::VecFromMask(di, mask));
}
HWY_INLINE IntVec one_if_float(hn::Mask<Floats> mask) { return one_if(hn::RebindMask(Ints(), mask)); }

// Whole parts are signed words: every value fits, and x86 converts only these.
struct Cut {
  IntVec whole;
  FloatVec part;
};
HWY_INLINE Cut cut(FloatVec y) {
  const auto whole = hn::ConvertTo(Ints(), y);
  return {whole, hn::Sub(y, hn::ConvertTo(Floats(), whole))};
}

HWY_INLINE IntVec reach_one(FloatVec uf, FloatVec vf) {
  return one_if_float(hn::Ge(hn::Min(uf, vf), hn::Sub(hn::Set(Floats(), 1.0f), hn::Max(uf, vf))));
}

HWY_INLINE IntVec is_more_than_none(FloatVec uf) { return one_if_float(hn::Gt(uf, hn::Zero(Floats()))); }

HWY_INLINE IntVec row_of(IntVec iu, IntVec iv, IntVec carry, IntVec N) {
  return hn::Min(hn::Sub(N, hn::Set(Ints(), 1)), hn::Add(hn::Add(iu, iv), carry));
}

// iu = floor(uN), iv = floor(vN); carry is 1 if uf+vf >= 1, beyond is 1 if uf > 0, else 0.
struct GridPoint {
  IntVec iu, iv, carry, beyond;
};
HWY_INLINE GridPoint find(FloatVec u, FloatVec v, Level n) {
  const auto N = hn::Set(Floats(), static_cast<float>(std::int32_t{1} << n));
  const Cut pu = cut(scaled(u, N)), pv = cut(scaled(v, N));
  return {pu.whole, pv.whole, reach_one(pu.part, pv.part), is_more_than_none(pu.part)};
}

struct Square {
  IntVec iu, iv, row;
};
HWY_INLINE Square square(IntVec iu, IntVec iv, IntVec carry, IntVec N) {
  const auto last = hn::Sub(N, hn::Set(Ints(), 1));
  const auto below = hn::Min(iv, last);
  return {hn::Min(iu, hn::Sub(last, below)), below, row_of(iu, iv, carry, N)};
}

struct RowPlace {
  IntVec row, col, dia;
};
HWY_INLINE RowPlace row_place(IntVec iu, IntVec iv, IntVec carry, IntVec beyond, IntVec N) {
  const auto last = hn::Sub(N, hn::Set(Ints(), 1));
  const auto row = row_of(iu, iv, carry, N);
  return {row, hn::Min(row, iv), hn::Min(last, hn::Sub(N, hn::Add(iu, beyond)))};
}

HWY_INLINE WordVec xor_from_above(WordVec x) {
  x = hn::Xor(x, hn::ShiftRight<1>(x));
  x = hn::Xor(x, hn::ShiftRight<2>(x));
  x = hn::Xor(x, hn::ShiftRight<4>(x));
  return hn::Xor(x, hn::ShiftRight<8>(x));
}

template <int shift>
HWY_INLINE WordVec part(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftLeft<shift>(x)), hn::Set(Words(), mask));
}

HWY_INLINE WordVec spread(WordVec x) {
  return part<1>(part<2>(part<4>(part<8>(x, 0x00ff00ff), 0x0f0f0f0f), 0x33333333), 0x55555555);
}

HWY_INLINE WordVec curve(const Square& q) {
  const Words dw;
  const auto iu = hn::BitCast(dw, q.iu);
  const auto b0 = hn::Xor(iu, hn::BitCast(dw, q.row));
  const auto t = hn::And(hn::Xor(iu, hn::BitCast(dw, q.iv)), b0);
  const auto b1 = hn::Or(hn::AndNot(b0, hn::Xor(xor_from_above(t), iu)), t);
  return hn::Or(spread(b0), hn::ShiftLeft<1>(spread(b1)));
}
