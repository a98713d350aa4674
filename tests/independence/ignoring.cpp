// Right functions that do not read one field of what they are asked.
//
// MMVERIFY_IGNORED is ENTRY/FIELD/WAY: the entry point, the field, and what the right function gets in the field's place:
//   zero, ones   a constant
//   like         the field's neighbour: G is R, v is u
//   rest         what the field was when all other fields were first as they are now; the answer is then a function of
//                these others, and the only law that refutes it asks two questions that differ in the field alone.
// The subject has this entry point alone, and what the contract wants beside it.
#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "tests/independence/fields.hpp"
#include "tests/independence/measure.hpp"
#include "tests/independence/right.hpp"

namespace mmverify::independence {
namespace {

enum class Way { zero, ones, like, rest };
struct Ignored {
  std::string entry, parameter, member, part;
  Way way;
};

const mmverify_subject_t& right() {
  static const mmverify_subject_t subject = right_of_all();
  return subject;
}
const Ignored& ignored();

void put(const Target& t, const std::uint8_t* from) {
  for (std::size_t k = 0; k < t.bytes; ++k)
    t.at[k] = static_cast<std::uint8_t>((t.at[k] & ~t.mask) | (from[k] & t.mask));
}

/// The field as it was when the rest was first as it is now.
void as_at_first(const Target& t, const Regions& all) {
  static std::mutex lock;
  static std::unordered_map<std::uint64_t, std::array<std::uint8_t, 8>> known;
  std::array<std::uint8_t, 8> value{}, none{};
  std::memcpy(value.data(), t.at, t.bytes);
  put(t, none.data());
  const std::uint64_t key = hash(all);
  const std::lock_guard guard(lock);
  put(t, known.emplace(key, value).first->second.data());
}

/// The neighbour of a field: the next one of its width in its region, or the region before or after it.
Target neighbour(const Target& t, const Regions& all, std::size_t region) {
  const Region& r = all[region];
  const auto inside = [](const Region& in, const std::uint8_t* at, std::size_t bytes) {
    return at >= in.at && at + bytes <= in.at + in.bytes;
  };
  if (t.bytes < r.bytes) {
    if (inside(r, t.at - t.bytes, t.bytes)) return {t.at - t.bytes, t.bytes, t.mask};
    if (inside(r, t.at + t.bytes, t.bytes)) return {t.at + t.bytes, t.bytes, t.mask};
  }
  for (const std::size_t other : {region - 1, region + 1})
    if (other < all.size() && all[other].bytes == r.bytes) return {all[other].at, t.bytes, t.mask};
  return {};
}

/// A line in the file MMVERIFY_TALLY, once: what the questions asked of the field.
class Note {
 public:
  explicit Note(const char* line) : line_(line) {}
  bool wanted() const { return !done_; }
  void write() {
    if (!done_.exchange(true)) std::ofstream(std::getenv("MMVERIFY_TALLY"), std::ios::app) << line_ << "\n";
  }

 private:
  const char* line_;
  std::atomic<bool> done_ = std::getenv("MMVERIFY_TALLY") == nullptr;
};
Note& varied() {
  static Note note("varied");
  return note;
}
/// The right function answers otherwise.
Note& wrong() {
  static Note note("wrong");
  return note;
}

void note_value(const Target& t) {
  static std::mutex lock;
  static std::optional<std::array<std::uint8_t, 8>> first;
  if (!varied().wanted()) return;
  std::array<std::uint8_t, 8> value{};
  for (std::size_t k = 0; k < t.bytes; ++k) value[k] = t.at[k] & t.mask;
  const std::lock_guard guard(lock);
  if (!first) first = value;
  if (*first != value) varied().write();
}

void ignore(Regions& all) {
  const Ignored& i = ignored();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].parameter != i.parameter || all[k].member != i.member) continue;
    const Target t = target_of(all[k], i.part);
    if (t.at == nullptr || t.bytes > 8) return;
    note_value(t);
    constexpr std::array<std::uint8_t, 8> zeros{}, ones{255, 255, 255, 255, 255, 255, 255, 255};
    switch (i.way) {
      case Way::zero: return put(t, zeros.data());
      case Way::ones: return put(t, ones.data());
      case Way::like:
        if (const Target n = neighbour(t, all, k); n.at != nullptr) put(t, n.at);
        return;
      case Way::rest: return as_at_first(t, all);
    }
  }
}

/// "(a.level, a.floats(0))": "level", "floats(0)".  The case of a struct is "what".
std::vector<std::string> names_of(const char* arguments) {
  std::vector<std::string> names;
  int depth = 0;
  for (const char* c = arguments; *c != 0; ++c) {
    depth += *c == '(' ? 1 : *c == ')' ? -1 : 0;
    if ((*c == '(' && depth == 1) || (*c == ',' && depth == 1)) {
      names.emplace_back();
    } else if (depth > 0 && *c != ' ' && *c != '\n') {
      names.back() += *c;
    }
  }
  for (std::string& name : names) name = name.rfind("a.", 0) == 0 ? name.substr(2) : "what";
  return names;
}

/// The place of the last size among parameters: of elements their count.
template <class... P>
constexpr std::size_t last_size = [] {
  std::size_t at = 0, k = 0;
  ((at = std::is_same_v<P, std::size_t> ? k : at, ++k), ...);
  return at;
}();

/// The place of the answer.
template <class... P>
constexpr std::size_t answer_at = [] {
  std::size_t at = 0, k = 0;
  ((at = dock::is_answer<P> ? k : at, ++k), ...);
  return at;
}();

template <dock::Call entry, class F>
struct Asked;
template <dock::Call entry, class R, class... P>
struct Asked<entry, R (*)(P...)> {
  static inline R (*right_function)(P...) = nullptr;
  static inline std::vector<std::string> names;

  static R ask(P... given) {
    constexpr const dock::EntryPoint& e = dock::entry_point(entry);
    constexpr bool of_elements = e.signature.arrays != 0 || entry == dock::Call::attribute_face_mip;
    thread_local std::vector<std::uint32_t> numbers;
    thread_local std::vector<std::size_t> sizes;
    thread_local Regions all;
    numbers.clear();
    sizes.clear();
    (
        [&] {
          if constexpr (std::is_same_v<P, std::uint32_t>) numbers.push_back(given);
          if constexpr (std::is_same_v<P, std::size_t>) sizes.push_back(given);
        }(),
        ...);
    const std::size_t count = of_elements ? sizes.back() : 1;
    std::size_t blob = 0;
    if constexpr ((std::is_same_v<P, const std::uint8_t*> || ...)) blob = blob_bytes(entry, numbers, sizes);
    constexpr bool blob_of_element = entry == dock::Call::attribute_face_mip;
    constexpr std::size_t answer = entry == dock::Call::attribute_face_mip ? 4 : e.answer_bytes;
    for (std::size_t k = 0; k < count; ++k) {
      std::tuple<Copy<P>...> copies;
      all.clear();
      const auto each = [&](auto&& f) {
        [&]<std::size_t... I>(std::index_sequence<I...>) { (f(std::get<I>(copies), given, names[I]), ...); }
        (std::index_sequence_for<P...>{});
      };
      each([&](auto& copy, auto g, const std::string& name) {
        using G = decltype(g);
        if constexpr (std::is_same_v<G, const std::uint8_t*>)
          copy.take(g, blob_of_element ? k : 0, blob);
        else if constexpr (std::is_same_v<G, std::size_t>)
          copy.take(g, k, 0);
        else
          copy.take(g, k, answer);
        copy.regions(name, all);
      });
      if constexpr (of_elements) std::get<last_size<P...>>(copies).size = 1;
      const auto call = [&] {
        return [&]<std::size_t... I>(std::index_sequence<I...>) {
          return right_function(std::get<I>(copies).argument()...);
        }
        (std::index_sequence_for<P...>{});
      };
      using Result = std::conditional_t<std::is_void_v<R>, int, R>;
      const auto result = [&]() -> Result {
        if constexpr (std::is_void_v<R>)
          return call(), 1;
        else
          return call();
      };
      auto& out = std::get<answer_at<P...>>(copies).out;
      auto* const real_out = out;
      // The right answer is computed until this subject has once answered wrongly.
      thread_local std::vector<std::uint64_t> right_answer;
      std::size_t room = 0;
      Result right_result{};
      if (wrong().wanted() || measures()) {
        (
            [&](const auto& g) {
              if constexpr (std::is_same_v<std::decay_t<decltype(g)>, const mmverify_bake_case_t*>)
                numbers = {g->level, g->format};
              if constexpr (std::is_same_v<std::decay_t<decltype(g)>, const mmverify_attribute_case_t*>)
                numbers = {g->level};
            }(given),
            ...);
        room = of_elements                      ? answer
               : std::is_same_v<R, std::size_t> ? sizes.back()
                                                : answer_bytes(entry, numbers, sizes);
      }
      if (wrong().wanted()) {
        right_answer.resize((room + 7) / 8);
        out = reinterpret_cast<decltype(+real_out)>(right_answer.data());
        right_result = result();
        out = real_out;
        if (std::is_same_v<R, std::size_t>)
          room = std::min<std::size_t>(room, static_cast<std::size_t>(right_result));
      }
      ignore(all);
      const Result got = result();
      if (measures()) {
        const std::size_t told = std::is_same_v<R, std::size_t>
                                     ? std::min<std::size_t>(room, static_cast<std::size_t>(got))
                                 : got != 0 ? room
                                            : 0;
        measure(entry, all, {{}, {}, reinterpret_cast<std::uint8_t*>(real_out), told});
      }
      if (wrong().wanted() && (got != right_result ||
                               (right_result != 0 && std::memcmp(real_out, right_answer.data(), room) != 0)))
        wrong().write();
      if constexpr (!std::is_void_v<R>) return got;
    }
    if constexpr (!std::is_void_v<R>) return {};
  }
};

const Ignored& ignored() {
  static const Ignored it = [] {
    const char* setting = std::getenv("MMVERIFY_IGNORED");
    std::string text = setting == nullptr ? "" : setting;
    std::array<std::string, 4> parts;
    for (std::string& part : parts) {
      const auto slash = text.find('/');
      part = text.substr(0, slash);
      text = slash == std::string::npos ? "" : text.substr(slash + 1);
    }
    const std::string& way = parts[3];
    const auto dot = parts[1].find('.');
    const std::string member = dot == std::string::npos ? "" : parts[1].substr(dot + 1);
    return Ignored{parts[0], parts[1].substr(0, dot), member, parts[2],
                   way == "ones"   ? Way::ones
                   : way == "like" ? Way::like
                   : way == "rest" ? Way::rest
                                   : Way::zero};
  }();
  return it;
}

/// The entry points that stand beside this one, since the contract or the laws want both.
bool goes_with(dock::Call other, dock::Call entry) {
  using dock::Call;
  const auto pair = [&](Call a, Call b) { return entry == a && other == b; };
  const bool of_orders = other >= Call::attribute_vertex_index && other <= Call::attribute_face_of;
  return pair(Call::dag_encode, Call::dag_decode) || pair(Call::dag_decode, Call::dag_encode) ||
         pair(Call::dag_lookup, Call::dag_encode) || pair(Call::dag_lookup_f32, Call::dag_encode) ||
         pair(Call::array_save, Call::array_load) || pair(Call::array_load, Call::array_save) ||
         pair(Call::micromap_pack, Call::micromap_unpack) ||
         pair(Call::micromap_unpack, Call::micromap_pack) ||
         pair(Call::micromap_widen, Call::micromap_force2) ||
         pair(Call::attribute_vertex_place, Call::attribute_vertex_index) ||
         pair(Call::attribute_face_place, Call::attribute_face_index) ||
         (of_orders && (entry == Call::attribute_triplet || entry == Call::attribute_face_of));
}

/// Whether it is the entry point that is asked for, or goes with that.
bool stands_beside(dock::Call other) {
  for (std::size_t e = 0; e < dock::calls; ++e)
    if (dock::entry_points[e].name == ignored().entry)
      return other == static_cast<dock::Call>(e) ? ignored().part != "without"
                                                 : goes_with(other, static_cast<dock::Call>(e));
  return false;
}

template <dock::Call entry, class F>
F wrapped(F right_function, const char* arguments) {
  using Its = Asked<entry, F>;
  Its::right_function = right_function;
  Its::names = names_of(arguments);
  return dock::entry_point(entry).name == ignored().entry ? &Its::ask : right_function;
}

template <class P>
std::string fields_of_one(const std::string& name, dock::Call entry) {
  std::string lines;
  Regions all;
  Copy<P> copy;
  copy.regions(name, all);
  for (const Region& r : all)
    for (const std::string& part : parts_of(r, entry))
      lines += std::string(dock::entry_point(entry).name) + "/" + name + (r.member.empty() ? "" : ".") +
               std::string(r.member) + "/" + part + "\n";
  return lines;
}

template <class... P, class R>
std::string fields_of(R (*)(P...), dock::Call entry, const char* arguments) {
  const std::vector<std::string> names = names_of(arguments);
  std::size_t k = 0;
  std::string lines;
  ((lines += fields_of_one<P>(names[k++], entry)), ...);
  return lines;
}

}  // namespace
}  // namespace mmverify::independence

using namespace mmverify;

/// ENTRY/REGION/PART, a line each.
extern "C" const char* mmverify_fields(void) {
  static const std::string lines = [] {
    std::string all;
#define MMVERIFY_FIELDS(name, topic, values, arguments)                                                      \
  all += independence::fields_of(static_cast<decltype(mmverify_subject_t::name)>(nullptr), dock::Call::name, \
                                 #arguments);
    MMVERIFY_ENTRY_POINTS(MMVERIFY_FIELDS)
#undef MMVERIFY_FIELDS
    return all;
  }();
  return lines.c_str();
}

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = [] {
    using dock::Call;
    const mmverify_subject_t& all = independence::right();
    mmverify_subject_t s{};
    s.abi = all.abi;
    s.size = all.size;
    s.name = std::getenv("MMVERIFY_IGNORED");
    s.max_level = all.max_level;
    s.flags = all.flags;
    s.attribute_support = all.attribute_support;
#define MMVERIFY_WRAP(name, topic, values, arguments) \
  if (independence::stands_beside(Call::name))        \
    s.name = independence::wrapped<Call::name>(all.name, #arguments);
    MMVERIFY_ENTRY_POINTS(MMVERIFY_WRAP)
#undef MMVERIFY_WRAP
    return s;
  }();
  return &subject;
}
