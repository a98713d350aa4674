#include "bench/codec/measure.hpp"

#include "bench/rounds.hpp"

namespace mmverify::bench {
namespace {

/// One kind of work by both codecs, and the places of its figures.
struct Kind {
  std::function<void()> CodecWork::*pass;
  std::uint64_t CodecCase::*elements;
  Spread CodecFigures::*spread;
  double CodecRow::*ratio;
};

/// Encoding comes first, since the others take its codes.
constexpr Kind kinds[] = {
    {&CodecWork::encode, &CodecCase::micro_triangles, &CodecFigures::encode, &CodecRow::encode_ratio},
    {&CodecWork::decode, &CodecCase::micro_triangles, &CodecFigures::decode, &CodecRow::decode_ratio},
    {&CodecWork::look_up, &CodecCase::lookups, &CodecFigures::look_up, &CodecRow::look_up_ratio},
};

CodecFigures figures(const CodecCase& of, const CodecWork& work) {
  CodecFigures f;
  if (work.bits) f.bits = work.bits() / static_cast<double>(of.micro_triangles);
  if (work.changed) f.changed = work.changed();
  if (work.wrong_lookups) f.wrong_lookups = work.wrong_lookups();
  return f;
}

}  // namespace

CodecRow measured_codec(const CodecCase& of, std::size_t rounds) {
  std::vector<Work> works;
  for (const Kind& kind : kinds)
    for (const CodecWork* codec : {&of.theirs, &of.ours})
      if (codec->*kind.pass) works.push_back({of.*kind.elements, codec->*kind.pass});
  const RoundTimes times = times_in_rounds(works, rounds);
  CodecRow row{.of = of, .theirs = figures(of, of.theirs), .ours = figures(of, of.ours)};
  auto next = times.begin();
  for (const Kind& kind : kinds) {
    const auto theirs = next, ours = of.theirs.*kind.pass ? next + 1 : next;
    if (of.theirs.*kind.pass) row.theirs.*kind.spread = spread_of(*next++);
    if (of.ours.*kind.pass) row.ours.*kind.spread = spread_of(*next++);
    if (of.theirs.*kind.pass && of.ours.*kind.pass) row.*kind.ratio = median_ratio(*theirs, *ours);
  }
  return row;
}

}  // namespace mmverify::bench
