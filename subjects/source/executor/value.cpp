#include "subjects/source/executor/value.hpp"

#include <algorithm>
#include <map>

namespace mmverify::source::executor {
namespace {

ValuePtr as_pointer(const ValuePtr& v) {
  if (is_pointer(v)) return v;
  const Word unset = unset_bits(*v);
  const bool all = std::all_of(unset.begin(), unset.end(), [](Literal l) { return l == always; });
  return pointer(all ? unset_object : number_object);
}

ValuePtr chosen_pointer(Graph& g, Literal when, const ValuePtr& a, const ValuePtr& b) {
  struct Pair {
    const Target *a = nullptr, *b = nullptr;
  };
  std::map<int, Pair> objects;
  for (const Target& t : a->targets) objects[t.object].a = &t;
  for (const Target& t : b->targets) objects[t.object].b = &t;
  auto made = std::make_shared<Value>();
  made->kind = Value::Kind::pointer;
  for (const auto& [object, pair] : objects) {
    const Literal here =
        g.chosen(when, pair.a == nullptr ? never : pair.a->when, pair.b == nullptr ? never : pair.b->when);
    if (here == never) continue;
    if (pair.a == nullptr || pair.b == nullptr)
      made->targets.push_back({here, object, (pair.a == nullptr ? pair.b : pair.a)->offset});
    else
      made->targets.push_back({here, object, circuit::chosen(g, when, pair.a->offset, pair.b->offset)});
  }
  if (made->targets.size() == 1) made->targets.front().when = always;
  return made;
}

}  // namespace

ValuePtr number(Word bits, Word unset) {
  if (std::all_of(unset.begin(), unset.end(), [](Literal l) { return l == never; })) unset.clear();
  auto made = std::make_shared<Value>();
  made->bits = std::move(bits);
  made->unset = std::move(unset);
  return made;
}

ValuePtr number(std::uint64_t value, std::size_t width) { return number(circuit::constant(value, width)); }

ValuePtr unset_number(std::size_t width) { return number(Word(width, never), Word(width, always)); }

ValuePtr pointer(int object, std::uint64_t offset) {
  auto made = std::make_shared<Value>();
  made->kind = Value::Kind::pointer;
  made->targets.push_back({always, object, circuit::constant(offset, pointer_bits)});
  return made;
}

ValuePtr parts(std::vector<ValuePtr> parts) {
  auto made = std::make_shared<Value>();
  made->kind = Value::Kind::parts;
  made->parts = std::move(parts);
  return made;
}

std::optional<std::uint64_t> known(const ValuePtr& v) {
  if (v->kind != Value::Kind::number || !v->unset.empty()) return std::nullopt;
  return circuit::value_of(v->bits);
}

Word unset_bits(const Value& v) { return v.unset.empty() ? Word(v.bits.size(), never) : v.unset; }

ValuePtr chosen(Graph& g, Literal when, const ValuePtr& a, const ValuePtr& b) {
  if (a == b || when == always) return a;
  if (when == never) return b;
  if (a->kind == Value::Kind::parts) {
    std::vector<ValuePtr> all;
    for (std::size_t k = 0; k < a->parts.size(); ++k)
      all.push_back(chosen(g, when, a->parts[k], b->parts[k]));
    return parts(std::move(all));
  }
  if (is_pointer(a) || is_pointer(b)) return chosen_pointer(g, when, as_pointer(a), as_pointer(b));
  if (a->unset.empty() && b->unset.empty()) return number(circuit::chosen(g, when, a->bits, b->bits));
  const Word ua = unset_bits(*a), ub = unset_bits(*b);
  Word bits(a->bits.size());
  // An unset bit has any value: the other side's saves a node.
  for (std::size_t k = 0; k < bits.size(); ++k)
    bits[k] = ua[k] == always   ? b->bits[k]
              : ub[k] == always ? a->bits[k]
                                : g.chosen(when, a->bits[k], b->bits[k]);
  return number(std::move(bits), circuit::chosen(g, when, ua, ub));
}

}  // namespace mmverify::source::executor
