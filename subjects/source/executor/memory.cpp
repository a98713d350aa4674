#include "subjects/source/executor/memory.hpp"

#include <algorithm>

#include "subjects/source/executor/planted.hpp"

namespace mmverify::source::executor {
namespace {

constexpr std::size_t pointer_bytes = 8;

bool same(const Cell& a, const Cell& b) { return a.value == b.value && a.byte == b.byte; }

/// The value whose bytes begin at `at` and lie there in order; null if there is none.
ValuePtr whole(const Object& object, std::size_t at, std::size_t bytes) {
  const Cell& first = object.cells[at];
  if (first.value == nullptr || first.byte != 0 || bytes_of(*first.value) != bytes) return nullptr;
  for (std::size_t k = 1; k < bytes; ++k)
    if (object.cells[at + k].value != first.value || object.cells[at + k].byte != k) return nullptr;
  return first.value;
}

bool unwritten(const Object& object, std::size_t at, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; ++k)
    if (object.cells[at + k].value != nullptr) return false;
  return true;
}

/// Bytes at `at` that both objects have as one value, or as nothing; 0 if there is no such value.
std::size_t common_word(const Object& a, const Object& b, std::size_t at) {
  for (const Object* object : {&a, &b}) {
    const Cell& cell = object->cells[at];
    if (cell.value == nullptr || cell.byte != 0) continue;
    const std::size_t bytes = bytes_of(*cell.value);
    if (at + bytes > a.cells.size()) continue;
    const auto fits = [&](const Object& o) {
      return unwritten(o, at, bytes) || whole(o, at, bytes) != nullptr;
    };
    if (fits(a) && fits(b)) return bytes;
  }
  return 0;
}

/// b where `when` holds, else a.
std::shared_ptr<Object> chosen_object(Graph& g, Literal when, const Object& a, const Object& b) {
  auto made = std::make_shared<Object>(a);
  made->gone = g.chosen(when, b.gone, a.gone);
  for (std::size_t at = 0; at < a.cells.size();) {
    if (same(a.cells[at], b.cells[at])) {
      ++at;
      continue;
    }
    std::size_t bytes = common_word(a, b, at);
    if (bytes == 0) bytes = 1;
    store(*made, at, chosen(g, when, loaded(b, at, bytes), loaded(a, at, bytes)));
    at += bytes;
  }
  return made;
}

}  // namespace

std::size_t bytes_of(const Value& v) {
  return v.kind == Value::Kind::pointer ? pointer_bytes : (v.bits.size() + 7) / 8;
}

ValuePtr loaded(const Object& object, std::size_t at, std::size_t bytes) {
  if (ValuePtr v = whole(object, at, bytes)) return v;
  Word bits, unset;
  for (std::size_t k = at; k < at + bytes; ++k) {
    const Cell& cell = object.cells[planted == Mistake::bytes_reversed ? 2 * at + bytes - 1 - k : k];
    if (cell.value == nullptr) {
      bits.insert(bits.end(), 8, never);
      unset.insert(unset.end(), 8, always);
      continue;
    }
    if (is_pointer(cell.value)) return pointer(number_object);
    const Word u = unset_bits(*cell.value);
    for (std::size_t bit = std::size_t{8} * cell.byte; bit < std::size_t{8} * cell.byte + 8; ++bit) {
      bits.push_back(bit < u.size() ? cell.value->bits[bit] : never);
      unset.push_back(bit < u.size() ? u[bit] : never);
    }
  }
  return number(std::move(bits), std::move(unset));
}

void store(Object& object, std::size_t at, const ValuePtr& value) {
  const std::size_t bytes = bytes_of(*value);
  for (std::size_t k = 0; k < bytes; ++k) object.cells[at + k] = {value, static_cast<std::uint8_t>(k)};
}

void forget(Object& object, std::size_t at, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; ++k) object.cells[at + k] = {};
}

void Memory::add(int number, Object object) {
  objects_.emplace_back(number, std::make_shared<Object>(std::move(object)));
}

const Object* Memory::find(int number) const {
  const auto at = std::lower_bound(objects_.begin(), objects_.end(), number,
                                   [](const Entry& e, int n) { return e.first < n; });
  return at == objects_.end() || at->first != number ? nullptr : at->second.get();
}

Object& Memory::writable(int number) {
  const auto at = std::lower_bound(objects_.begin(), objects_.end(), number,
                                   [](const Entry& e, int n) { return e.first < n; });
  if (at->second.use_count() > 1) at->second = std::make_shared<Object>(*at->second);
  return *at->second;
}

void Memory::drop(int call) {
  std::erase_if(objects_, [call](const Entry& e) { return e.second->call == call; });
}

void Memory::choose(Graph& g, Literal when, const Memory& other) {
  std::vector<Entry> all;
  auto a = objects_.begin();
  auto b = other.objects_.begin();
  while (a != objects_.end() || b != other.objects_.end()) {
    // An object of one side alone: no pointer of the other side leads to it.
    if (b == other.objects_.end() || (a != objects_.end() && a->first < b->first)) {
      all.push_back(*a++);
    } else if (a == objects_.end() || b->first < a->first) {
      all.push_back(*b++);
    } else {
      all.push_back(a->second == b->second ? *a
                                           : Entry{a->first, chosen_object(g, when, *a->second, *b->second)});
      ++a;
      ++b;
    }
  }
  objects_ = std::move(all);
}

}  // namespace mmverify::source::executor
