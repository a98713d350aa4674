#include "bench/codec/measure.hpp"

#include <algorithm>

#include "bench/timing.hpp"

namespace mmverify::bench {
namespace {

/// The times of one kind of work in all rounds, of both codecs.
struct Times {
  std::vector<double> theirs, ours, ratio;
};

void measure(const std::function<void()>& theirs, const std::function<void()>& ours, double each,
             Times& times) {
  if (theirs) times.theirs.push_back(once_ns(theirs) / each);
  if (ours) times.ours.push_back(once_ns(ours) / each);
  if (theirs && ours && times.ours.back() > 0) times.ratio.push_back(times.theirs.back() / times.ours.back());
}

Spread spread(const std::vector<double>& ns) {
  if (ns.empty()) return {};
  const auto [least, most] = std::minmax_element(ns.begin(), ns.end());
  return {median(ns), *least, *most};
}

double ratio(const Times& times) { return times.ratio.empty() ? 0 : median(times.ratio); }

CodecFigures figures(const CodecCase& of, const CodecWork& work) {
  CodecFigures f;
  if (work.bits) f.bits = work.bits() / static_cast<double>(of.micro_triangles);
  if (work.changed) f.changed = work.changed();
  return f;
}

}  // namespace

CodecRow measured_codec(const CodecCase& of, std::size_t rounds) {
  Times encode, decode, look_up;
  const auto states = static_cast<double>(of.micro_triangles), lookups = static_cast<double>(of.lookups);
  for (std::size_t round = 0; round < rounds; ++round) {
    measure(of.theirs.encode, of.ours.encode, states, encode);
    measure(of.theirs.decode, of.ours.decode, states, decode);
    measure(of.theirs.look_up, of.ours.look_up, lookups, look_up);
  }
  CodecRow row{
      of, figures(of, of.theirs), figures(of, of.ours), ratio(encode), ratio(decode), ratio(look_up)};
  row.theirs.encode = spread(encode.theirs), row.ours.encode = spread(encode.ours);
  row.theirs.decode = spread(decode.theirs), row.ours.decode = spread(decode.ours);
  row.theirs.look_up = spread(look_up.theirs), row.ours.look_up = spread(look_up.ours);
  return row;
}

}  // namespace mmverify::bench
