// Pointers, loads and stores.
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>

#include <bit>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

/// Places of one access that may be told apart.
constexpr std::size_t most_places = 1 << 16;

/// Bytes that a program may reach: the size where it is known, else what the inputs make it.
Word size_of(const Object& object) {
  return object.size.empty() ? circuit::constant(object.cells.size(), pointer_bits) : object.size;
}

/// The instruction is of C, in which a null pointer may not even be moved by 0.
bool is_c(const llvm::Instruction& at) {
  namespace dwarf = llvm::dwarf;
  const llvm::DISubprogram* function = at.getFunction()->getSubprogram();
  if (function == nullptr) return false;
  const unsigned language = function->getUnit()->getSourceLanguage();
  return language == dwarf::DW_LANG_C || language == dwarf::DW_LANG_C89 || language == dwarf::DW_LANG_C99 ||
         language == dwarf::DW_LANG_C11;
}

}  // namespace

ValuePtr Executor::moved_by(const ValuePtr& p, const Word& by) const {
  auto made = std::make_shared<Value>(*p);
  for (Target& t : made->targets) t.offset = circuit::sum(graph_, t.offset, by);
  return made;
}

ValuePtr Executor::moved(State& s, const llvm::GEPOperator& gep, const llvm::Instruction& at) {
  const ValuePtr from = value(s, gep.getPointerOperand(), at);
  if (!is_pointer(from)) throw Unreadable(at, "a number taken for a pointer");
  Word by = circuit::constant(0, pointer_bits);
  for (auto step = llvm::gep_type_begin(gep); step != llvm::gep_type_end(gep); ++step) {
    if (llvm::StructType* record = step.getStructTypeOrNull()) {
      const std::uint64_t field = llvm::cast<llvm::ConstantInt>(step.getOperand())->getZExtValue();
      by = circuit::sum(
          graph_, by,
          circuit::constant(layout_.getStructLayout(record)->getElementOffset(static_cast<unsigned>(field)),
                            pointer_bits));
      continue;
    }
    const ValuePtr index = numeric(s, step.getOperand(), at);
    require_set(index, at, "an index that was never set");
    const std::uint64_t element = layout_.getTypeAllocSize(step.getIndexedType());
    const Word wide = circuit::resized(index->bits, pointer_bits, true);
    // Beyond 2^47 elements an index would wrap.
    const Word top(wide.begin() + 47, wide.end());
    require_never(Duty::bounds, negated(all_alike(top)), at, "an index beyond all memory");
    by = circuit::sum(graph_, by, circuit::product(graph_, wide, circuit::constant(element, pointer_bits)));
  }
  if (const auto none = circuit::value_of(by); none && *none == 0) return from;
  ValuePtr made = moved_by(from, by);
  if (!gep.isInBounds()) return made;
  for (const Target& t : made->targets) {
    const Object* object = t.object > 0 ? s.memory.find(t.object) : nullptr;
    if (object != nullptr)
      require_never(Duty::bounds, graph_.both(t.when, circuit::less(graph_, size_of(*object), t.offset)), at,
                    "a pointer outside of " + object->name);
    else if (t.object == null_object)
      require_never(Duty::pointers,
                    is_c(at) ? t.when : graph_.both(t.when, circuit::not_zero(graph_, t.offset)), at,
                    "a null pointer moved");
  }
  return made;
}

Literal Executor::all_alike(const Word& bits) const {
  Literal same = always;
  for (const Literal l : bits) same = graph_.both(same, negated(graph_.differ(l, bits.front())));
  return same;
}

const Object* Executor::object_at(const State& s, const Target& t, Literal condition,
                                  const llvm::Instruction& at, const char* access) {
  const std::string what = access;
  const auto refuse = [&](Duty duty, const std::string& why) -> const Object* {
    require_never(duty, condition, at, why);
    return nullptr;
  };
  if (t.object == null_object) return refuse(Duty::pointers, "a null pointer is " + what);
  if (t.object == unset_object) return refuse(Duty::pointers, "a pointer that was never set is " + what);
  if (t.object == number_object) throw Unreadable(at, "a pointer that was made of a part of another");
  if (functions_.contains(t.object)) return refuse(Duty::pointers, "a function is " + what);
  const Object* object = s.memory.find(t.object);
  if (object == nullptr) return refuse(Duty::life, "a variable is " + what + " after its life");
  if (object->gone != never)
    require_never(
        Duty::life, graph_.both(condition, object->gone), at,
        object->name + " is " + what + (object->call != 0 ? " after its life" : " after it was freed"));
  return object;
}

void Executor::require_within(const Object& object, const Word& offset, std::size_t bytes, Literal condition,
                              const llvm::Instruction& at, const char* access) {
  // The access ends beyond the object: size < offset + bytes, with a bit for the carry.
  const Word end = circuit::sum(graph_, circuit::resized(offset, pointer_bits + 1, false),
                                circuit::constant(bytes, pointer_bits + 1));
  const Literal outside =
      circuit::less(graph_, circuit::resized(size_of(object), pointer_bits + 1, false), end);
  require_never(Duty::bounds, graph_.both(condition, outside), at,
                object.name + " is " + access + " outside of its " +
                    (object.size.empty() ? std::to_string(object.cells.size()) + " bytes" : "bytes"));
}

std::vector<std::pair<Literal, std::size_t>> Executor::offsets(const Object& object, const Word& offset,
                                                               std::size_t bytes, Literal condition,
                                                               const llvm::Instruction& at,
                                                               const char* access) {
  const std::size_t size = object.cells.size();
  require_within(object, offset, bytes, condition, at, access);
  if (const auto place = circuit::value_of(offset)) {
    if (*place > size || bytes > size - *place) return {};
    return {{always, *place}};
  }
  std::vector<std::pair<Literal, std::size_t>> places;
  for (std::size_t place = 0; place + bytes <= size; ++place) {
    if (places.size() > most_places) throw Unreadable(at, "an access with too many places");
    const Literal here = circuit::equal(graph_, circuit::constant(place, pointer_bits), offset);
    if (here != never) places.emplace_back(here, place);
  }
  return places;
}

ValuePtr Executor::load_from(const Object& object, const Target& t, std::size_t bytes, const llvm::Type& type,
                             Literal condition, const llvm::Instruction& at) {
  if (!object.watched.empty()) {
    require_within(object, t.offset, bytes, condition, at, "read");
    return load_watched(object, t.offset, bytes);
  }
  const auto places = offsets(object, t.offset, bytes, condition, at, "read");
  if (places.size() == 1 && places.front().first == always)
    return loaded(object, places.front().second, bytes);
  std::vector<std::pair<Literal, ValuePtr>> values;
  bool numbers = true;
  for (const auto& [here, place] : places) {
    values.emplace_back(here, loaded(object, place, bytes));
    numbers = numbers && values.back().second->kind == Value::Kind::number;
  }
  if (values.empty()) return unset_of(type, at);
  if (!numbers) {
    ValuePtr all = values.front().second;
    for (const auto& [here, v] : values) all = chosen(graph_, here, v, all);
    return all;
  }
  // Exactly one place is read, so a bit is set if it is at that place.
  Word bits(8 * bytes), unset(8 * bytes, never);
  for (std::size_t k = 0; k < bits.size(); ++k) {
    std::vector<Literal> some, none;
    for (const auto& [here, v] : values) {
      if (const Literal l = graph_.both(here, v->bits[k]); l != never) some.push_back(l);
      if (v->unset.empty()) continue;
      if (const Literal l = graph_.both(here, v->unset[k]); l != never) none.push_back(l);
    }
    bits[k] = graph_.any_of(std::move(some));
    unset[k] = graph_.any_of(std::move(none));
  }
  return number(std::move(bits), std::move(unset));
}

std::vector<Executor::Part> Executor::parts_of(const llvm::Type& type) const {
  std::vector<Part> all;
  auto* record = const_cast<llvm::Type*>(&type);
  if (auto* fields = llvm::dyn_cast<llvm::StructType>(record))
    for (unsigned k = 0; k < fields->getNumElements(); ++k)
      all.push_back({layout_.getStructLayout(fields)->getElementOffset(k), fields->getElementType(k)});
  else
    for (std::uint64_t k = 0; k < record->getArrayNumElements(); ++k)
      all.push_back(
          {k * layout_.getTypeAllocSize(record->getArrayElementType()), record->getArrayElementType()});
  return all;
}

void Executor::require_aligned(const State& s, const ValuePtr& p, std::uint64_t align, Literal when,
                               const llvm::Instruction& at, const char* access) {
  if (align == 1 || !is_pointer(p)) return;
  for (const Target& t : p->targets) {
    const Object* object = t.object > 0 ? s.memory.find(t.object) : nullptr;
    if (object == nullptr) continue;
    const Word low(t.offset.begin(), t.offset.begin() + std::countr_zero(align));
    const bool of_law = at.getFunction()->hasFnAttribute(law_attribute);
    const std::uint64_t known = object->promised == 0 || of_law ? object->align : object->promised;
    const Literal off = known < align ? always : circuit::not_zero(graph_, low);
    require_never(
        Duty::alignment, graph_.both(graph_.both(when, t.when), off), at,
        object->name + " is " + access + " at an address that is no multiple of " + std::to_string(align));
  }
}

ValuePtr Executor::load_parts(State& s, const ValuePtr& p, const llvm::Type& type,
                              const llvm::Instruction& at) {
  std::vector<ValuePtr> all;
  for (const Part& part : parts_of(type))
    all.push_back(load(s, moved_by(p, circuit::constant(part.offset, pointer_bits)),
                       layout_.getTypeStoreSize(part.type), *part.type, at));
  return parts(std::move(all));
}

ValuePtr Executor::load(State& s, const ValuePtr& p, std::size_t bytes, const llvm::Type& type,
                        const llvm::Instruction& at) {
  if (!is_pointer(p)) throw Unreadable(at, "a number taken for a pointer");
  if (type.isAggregateType()) return load_parts(s, p, type, at);
  ValuePtr all;
  for (const Target& t : p->targets) {
    const Object* object = object_at(s, t, t.when, at, "read");
    if (object == nullptr) continue;
    ValuePtr v = load_from(*object, t, bytes, type, t.when, at);
    if (type.isPointerTy() && !is_pointer(v)) v = pointer_of(v);
    all = all == nullptr ? v : chosen(graph_, t.when, v, all);
  }
  if (all == nullptr) return unset_of(type, at);
  if (type.isIntegerTy() && all->kind == Value::Kind::number &&
      all->bits.size() != type.getIntegerBitWidth()) {
    const std::size_t width = type.getIntegerBitWidth();
    return number(circuit::resized(all->bits, width, false),
                  all->unset.empty() ? Word{} : circuit::resized(all->unset, width, false));
  }
  return all;
}

ValuePtr Executor::pointer_of(const ValuePtr& v) const {
  // Eight zero bytes are the null pointer.
  if (const auto n = known(v); n && *n == 0) return pointer(null_object);
  const Word unset = unset_bits(*v);
  return pointer(!unset.empty() && unset.front() == always ? unset_object : number_object);
}

void Executor::store_typed(State& s, const ValuePtr& p, const ValuePtr& v, const llvm::Type& type,
                           const llvm::Instruction& at) {
  if (v->kind != Value::Kind::parts) return store(s, p, v, always, at);
  const std::vector<Part> all = parts_of(type);
  for (std::size_t k = 0; k < all.size(); ++k)
    store_typed(s, moved_by(p, circuit::constant(all[k].offset, pointer_bits)), v->parts[k], *all[k].type,
                at);
}

void Executor::require_no_state(const Object& object, const llvm::Instruction& at) const {
  if (object.lasting && !object.constant && !describes_)
    throw Unreadable(at,
                     "a write to " + object.name +
                         ", which outlives the call: a proof of the first calls says nothing of later ones");
}

void Executor::store(State& s, const ValuePtr& p, const ValuePtr& v, Literal when,
                     const llvm::Instruction& at) {
  if (!is_pointer(p)) throw Unreadable(at, "a number taken for a pointer");
  ValuePtr whole = v;
  if (v->kind == Value::Kind::number && v->bits.size() % 8 != 0)
    whole = number(circuit::resized(v->bits, 8 * bytes_of(*v), false),
                   v->unset.empty() ? Word{} : circuit::resized(v->unset, 8 * bytes_of(*v), false));
  const std::size_t bytes = bytes_of(*whole);
  for (const Target& t : p->targets) {
    const Literal here = graph_.both(when, t.when);
    if (here == never) continue;
    const Object* object = object_at(s, t, here, at, "written");
    if (object == nullptr) continue;
    if (object->constant)
      require_never(Duty::constants, here, at, "the constant " + object->name + " is written");
    if (!object->watched.empty()) {
      require_within(*object, t.offset, bytes, here, at, "written");
      store_watched(s.memory.writable(t.object), t.offset, whole, here);
      continue;
    }
    const auto places = offsets(*object, t.offset, bytes, here, at, "written");
    if (places.empty()) continue;
    require_no_state(*object, at);
    Object& own = s.memory.writable(t.object);
    for (const auto& [equal, place] : places)
      mmverify::source::executor::store(
          own, place,
          chosen(graph_, planted == Mistake::write_anywhere ? here : graph_.both(here, equal), whole,
                 loaded(own, place, bytes)));
  }
}

}  // namespace mmverify::source::executor
