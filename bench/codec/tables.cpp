#include "bench/codec/tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mmverify::bench {
namespace {

using R = CodecRow;

/// The time of one kind of work: theirs with its spread, ours with its, and the ratio.
void add_times(Fields<R>& fields, const std::string& key, const std::string& group, const std::string& each,
               Spread CodecFigures::*of, double R::*ratio_of) {
  const auto one = [&](const char* suffix, const char* heading, const CodecFigures R::*whose,
                       double Spread::*which) {
    fields.push_back({{time(key + suffix, "ns " + each).if_any(), heading, "ns", digits(2), group},
                      [of, whose, which](const R& r) -> Value {
                        const Spread& s = r.*whose.*of;
                        return s.median == 0 ? Value() : Value(s.*which);
                      }});
  };
  one("_theirs_ns", "theirs", &R::theirs, &Spread::median);
  one("_theirs_least_ns", "least", &R::theirs, &Spread::least);
  one("_theirs_most_ns", "most", &R::theirs, &Spread::most);
  one("_ours_ns", "ours", &R::ours, &Spread::median);
  fields.push_back(
      {{ratio(key + "_ratio", speed_less, "theirs / ours: the median of the rounds' ratios").if_any(),
        "theirs / ours",
        "",
        {.digits = 3, .type = 'g'},
        group},
       [ratio_of](const R& r) -> Value { return r.*ratio_of == 0 ? Value() : Value(r.*ratio_of); }});
}

Value unless_0(double x) { return x == 0 ? Value() : Value(x); }

/// Columns without a value in any row say nothing.
void drop_empty(Table& table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    const auto empty = [c](const Row& row) { return row[c].index() == 0; };
    if (!std::all_of(table.rows.begin(), table.rows.end(), empty)) continue;
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (Row& row : table.rows) row.erase(row.begin() + at);
  }
}

Fields<R> codec_fields() {
  Fields<R> fields{
      {{.key = text("maps", key, "the kind of maps"), .heading = "maps", .leads = true},
       [](const R& r) { return r.of.of; }},
      {{.key = level(16, key, "none: these maps have no levels").if_any(), .heading = "level", .leads = true},
       [](const R& r) -> Value { return r.of.level ? Value(std::uint64_t{*r.of.level}) : Value(); }},
      {{.key = one_of("states", key, {2, 3, 4}), .heading = "states", .leads = true},
       [](const R& r) { return r.of.states; }},
      {{positive("count", same, "of maps"), "count"}, [](const R& r) { return r.of.maps; }},
      {{number("bits_theirs", about_less, "a micro-triangle or region").if_any(), "theirs", "", digits(4),
        "bits"},
       [](const R& r) { return unless_0(r.theirs.bits); }},
      {{number("bits_ours", about_less, "a micro-triangle or region").if_any(), "ours", "", digits(4),
        "bits"},
       [](const R& r) { return unless_0(r.ours.bits); }},
      {{count("changed_theirs", less, "states that came back otherwise, or were given up"), "theirs", "",
        plain, "states changed"},
       [](const R& r) { return r.theirs.changed; }},
      {{count("changed_ours", less, "the same of ours"), "ours", "", plain, "states changed"},
       [](const R& r) { return r.ours.changed; }},
      {{count("wrong_lookups", less, "of theirs, answers that are not the code's own map's").if_any(),
        "theirs", "", plain, "lookups wrong"},
       [](const R& r) -> Value { return r.theirs.wrong_lookups ? Value(*r.theirs.wrong_lookups) : Value(); }},
  };
  add_times(fields, "encode", "encode a micro-triangle", "a micro-triangle", &CodecFigures::encode,
            &R::encode_ratio);
  add_times(fields, "decode", "decode a micro-triangle", "a micro-triangle", &CodecFigures::decode,
            &R::decode_ratio);
  add_times(fields, "lookup", "a lookup", "a lookup", &CodecFigures::look_up, &R::look_up_ratio);
  return fields;
}

}  // namespace

Result codec_tables(const std::vector<CodecRow>& rows, const CodecBench& bench) {
  const Fields<CodecBench> members{
      {{text("library", left_out)}, [](const CodecBench& b) { return b.library; }},
      {{text("ours", setting, "our codec")}, [](const CodecBench& b) { return b.ours; }},
  };
  Table table = table_of<R>({.key = "rows"}, codec_fields(), rows);
  drop_empty(table);
  return {
      .topic = "codec",
      .description = "mmverify bench tree|dag|vq|array|attribute --subject FILE: a codec beside ours",
      .settings = {},
      .about = fmt::format("{} beside {}, one thread, {} rounds in turn: median, least and most; called in "
                           "this process, without the walls of prove",
                           bench.library, bench.ours, bench.rounds),
      .tables = {table_of<CodecBench>({.form = Form::members}, members, {bench}), table}};
}

}  // namespace mmverify::bench
