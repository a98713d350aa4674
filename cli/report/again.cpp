#include "cli/report/again.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "cli/build_info.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "proofs/index/diagnosis.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;
using Json = nlohmann::ordered_json;

constexpr Level all_levels_to = 6;           // highest level at which every cell is asked
constexpr Level highest_asked = 10;          // takes a second or so
constexpr std::int64_t squares_around = 32;  // cells listed on each side of the counterexample
constexpr std::size_t most_results = 200, most_pictures = 8;

using index::Order;

/// The order of indices that the law is about.
Order order_of(const Law& law, const index::IndexSubject& subject) {
  const bool rows =
      law.id == "index.row_order" || law.id == "index.row_corners" || law.id.starts_with("paper.w_minor");
  return rows || !subject.functions.index ? Order::rows : Order::curve;
}

/// The subjects of topic index, asked once for each order.
class SubjectAnswers {
 public:
  /// Asks the subject and returns its number in the list. Domain: the subject has the order's entry point.
  std::size_t add(const index::IndexSubject& subject, Order order, Level level, const std::string& at) {
    const auto [place, added] = numbers_.emplace(std::pair(subject.name(), order), numbers_.size());
    const std::size_t number = place->second;
    if (added) {
      list_.push_back({{"subject", subject.name()},
                       {"order", order == Order::curve ? "curve" : "rows"},
                       {"levels", Json::array()}});
      for (Level n = 0; n <= std::min(all_levels_to, subject.functions.max_level); ++n)
        list_[number]["levels"].push_back(asked(subject, order, n, index::whole_level(n)));
    }
    if (level > all_levels_to && level <= std::min(highest_asked, subject.functions.max_level))
      if (const auto window = around(at, level); window && further_.insert({number, level}).second) {
        Json one = asked(subject, order, level, *window);
        one["window"] = {window->ku0, window->ku1, window->kv0, window->kv1};
        list_[number]["levels"].push_back(one);
      }
    return number;
  }
  const Json& list() const { return list_; }

 private:
  /// The cells around a counterexample; nothing if it is no point.
  static std::optional<index::CellWindow> around(const std::string& at, Level n) {
    try {
      const points::RationalPoint p = points::parse_point(at);
      const double quarters = 4.0 * spec::side(n);
      const auto u = static_cast<std::int64_t>(points::nearest(p.u) * quarters),
                 v = static_cast<std::int64_t>(points::nearest(p.v) * quarters);
      // Rounded to grid lines.
      const auto low = [](std::int64_t k) { return std::max<std::int64_t>(0, (k / 4 - squares_around) * 4); };
      const auto high = [](std::int64_t k) { return (k / 4 + squares_around) * 4; };
      return index::CellWindow{low(u), high(u), low(v), high(v)};
    } catch (const BadCase&) {
      return std::nullopt;
    }
  }

  static Json asked(const index::IndexSubject& subject, Order order, Level n,
                    const index::CellWindow& window) {
    const index::WrongCells found = index::wrong_cells(subject, n, order, window);
    Json wrong = Json::array();
    for (const index::WrongCell& c : found.listed)
      for (const Json& x : {Json(c.ku), Json(c.kv), Json(c.expected), Json(c.got)}) wrong.push_back(x);
    return {{"level", n}, {"cells", found.cells}, {"wrong_cells", found.wrong}, {"wrong", wrong}};
  }

  std::map<std::pair<std::string, Order>, std::size_t> numbers_;
  std::set<std::pair<std::size_t, Level>> further_;
  Json list_ = Json::array();
};

std::string digits(const std::vector<spec::micromap::State>& states) {
  std::string text;
  for (const auto s : states) text += static_cast<char>('0' + static_cast<int>(s));
  return text;
}

/// The true states of the case's triangle and the subject's; null if there are too many.
Json states_of(const bake::BakeSubject& subject, const std::string& at, Level n) {
  if (n > all_levels_to) return nullptr;
  const bake::Case one = bake::case_from(at);
  const auto baked = subject.functions.bake(one, n, bake::Format::four_state);
  if (!baked) return nullptr;
  std::vector<bake::State> right = bake::true_map(one, n);
  for (std::size_t k = 0; k < right.size(); ++k)
    // A baker need not tell the two unknown states apart.
    if (!subject.functions.centroid && spec::micromap::unknown(right[k]) &&
        spec::micromap::unknown(baked->states[k]))
      right[k] = baked->states[k];
  return {{"level", n}, {"expected", digits(right)}, {"got", digits(baked->states)}};
}

/// Repeats the question of one result's counterexample, and writes the outcome into `one`.
void ask(const Json& result, SubjectAnswers& asked, std::size_t& pictures, Json& one) {
  const std::string id = result["law"], name = result["subject"];
  const Json& c = result["counterexample"];
  const Json level_text = c.contains("level") && !c["level"].is_null() ? c["level"] : result["level"];
  const Law* law = find_law(id);
  const SubjectPtr subject = find_subject(name);
  const auto why = [&one](const std::string& words) { one["why"] = words; };
  if (law == nullptr) return why("this program has no law of that name");
  if (name == "standard input") return why("its answers came on a pipe and were not kept");
  if (subject == nullptr) return why("the subject is not built in, and no library is started for a page");
  if (level_text.is_null()) return why("it is about many levels at once");
  const Level level = level_text.get<Level>();
  if (const auto unfit = law->unfit(*subject, level)) return why(*unfit);
  const std::string at = c["case"];
  if (law->replay) {
    const Replayed r = law->replay(*subject, level, at);
    one["holds"] = r.holds;
    one["expected"] = r.expected;
    one["got"] = r.got;
    if (law->topic != "index" && !r.picture.empty() && pictures < most_pictures) {
      one["picture"] = r.picture;
      ++pictures;
    }
  }
  if (const auto* index = dynamic_cast<const index::IndexSubject*>(subject.get())) {
    const Order order = order_of(*law, *index);
    if (order == Order::curve ? index->functions.index != nullptr : index->functions.row_index != nullptr)
      one["asked"] = asked.add(*index, order, level, at);
  } else if (const auto* bake = dynamic_cast<const bake::BakeSubject*>(subject.get());
             bake != nullptr && !id.starts_with("bake.mesh_")) {
    if (Json states = states_of(*bake, at, level); !states.is_null()) one["states"] = states;
  }
}

}  // namespace

Json asked_again(const std::vector<ReportInput>& inputs) {
  SubjectAnswers asked;
  Json again = Json::array();
  std::size_t pictures = 0;
  for (std::size_t file = 0; file < inputs.size(); ++file) {
    const Json& run = inputs[file].content;
    if (!run.contains("results")) continue;
    for (std::size_t k = 0; k < run["results"].size(); ++k) {
      const Json& result = run["results"][k];
      if (result["verdict"] != "refuted" || result["counterexample"].is_null()) continue;
      Json one{{"file", file},
               {"result", k},
               {"same_source", run["tool"].value("source_hash", "") == build::source_hash}};
      if (again.size() >= most_results)
        one["why"] = fmt::format("of all that is refuted only the first {} are asked", most_results);
      else if (run.contains("scene"))
        one["why"] = "it is about the scene's own data; the command with the counterexample shows it again";
      else
        try {
          ask(result, asked, pictures, one);
        } catch (const std::exception& error) {
          one["why"] = error.what();
        }
      again.push_back(one);
    }
  }
  return {{"asked", asked.list()}, {"again", again}};
}

}  // namespace mmverify::cli
