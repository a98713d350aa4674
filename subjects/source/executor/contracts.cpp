// Proofs by contract: memory of any size of which a few bytes are watched, and functions that stand for a codec's own.
#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

constexpr std::size_t byte_bits = 8;

ValuePtr any_byte(Graph& g) {
  Word bits;
  for (std::size_t k = 0; k < byte_bits; ++k) bits.push_back(g.input());
  return number(std::move(bits));
}

Word beyond(Graph& g, const Word& offset, std::size_t by) {
  return by == 0 ? offset : circuit::sum(g, offset, circuit::constant(by, pointer_bits));
}

}  // namespace

llvm::Function& Executor::stand_in(llvm::Function& function, const llvm::Instruction* at) const {
  const auto found = stand_ins_.find(&function);
  if (found == stand_ins_.end() || at == nullptr || at->getFunction()->hasFnAttribute(law_attribute))
    return function;
  return *found->second;
}

void Executor::put_in_place(State& s, const llvm::CallBase& i) {
  const auto function = [&](unsigned k) -> llvm::Function* {
    const ValuePtr p = value(s, i.getArgOperand(k), i);
    if (!is_pointer(p) || p->targets.size() != 1)
      throw Unreadable(i, "a contract of one function or another");
    if (p->targets.front().object == null_object) return nullptr;
    const auto found = functions_.find(p->targets.front().object);
    if (found == functions_.end()) throw Unreadable(i, "a contract of something that is no function");
    return found->second;
  };
  llvm::Function *own = function(0), *other = function(1);
  if (own == nullptr) return;
  if (other == nullptr || own->arg_size() != other->arg_size())
    throw Unreadable(i, "a contract of a function with other arguments");
  stand_ins_[own] = other;
}

ValuePtr Executor::watched_memory(State& s, const llvm::CallBase& i) {
  const ValuePtr size = numeric(s, i.getArgOperand(0), i);
  const ValuePtr places = value(s, i.getArgOperand(1), i);
  const auto count = known(numeric(s, i.getArgOperand(2), i));
  if (!count) throw Unreadable(i, "watched memory with a number of places that is not known");
  Object object;
  object.name = "the memory of " + place_of(i);
  object.size = size->bits;
  const llvm::Type& word = *llvm::Type::getInt64Ty(module_.getContext());
  for (std::size_t k = 0; k < *count; ++k) {
    const ValuePtr at = load(s, moved_by(places, circuit::constant(k * sizeof(std::uint64_t), pointer_bits)),
                             sizeof(std::uint64_t), word, i);
    require_set(at, i, "a place that was never set");
    // Two places may be one.
    ValuePtr byte = any_byte(graph_);
    for (std::size_t j = 0; j < k; ++j)
      byte = chosen(graph_, circuit::equal(graph_, object.watched[j], at->bits), object.cells[j].value, byte);
    object.watched.push_back(at->bits);
    object.cells.push_back({byte, 0});
  }
  s.memory.add(++objects_, std::move(object));
  return pointer(objects_);
}

void Executor::make_constant(State& s, const llvm::CallBase& i) {
  const ValuePtr p = value(s, i.getArgOperand(0), i);
  if (!is_pointer(p) || p->targets.size() != 1 || p->targets.front().object <= 0)
    throw Unreadable(i, "one memory or another is to be only read");
  s.memory.writable(p->targets.front().object).constant = true;
}

ValuePtr Executor::load_watched(const Object& object, const Word& offset, std::size_t bytes) {
  Word bits, unset;
  for (std::size_t k = 0; k < bytes; ++k) {
    const Word at = beyond(graph_, offset, k);
    ValuePtr byte;
    for (std::size_t w = 0; w < object.watched.size(); ++w) {
      const Literal here = circuit::equal(graph_, object.watched[w], at);
      if (here == never) continue;
      const ValuePtr own = loaded(object, w, 1);
      if (is_pointer(own)) return pointer(number_object);
      if (byte == nullptr && here != always) byte = any_byte(graph_);
      byte = here == always ? own : chosen(graph_, here, own, byte);
      if (here == always) break;
    }
    if (byte == nullptr) byte = any_byte(graph_);
    const Word u = unset_bits(*byte);
    bits.insert(bits.end(), byte->bits.begin(), byte->bits.end());
    unset.insert(unset.end(), u.begin(), u.end());
  }
  return number(std::move(bits), std::move(unset));
}

void Executor::store_watched(Object& object, const Word& offset, const ValuePtr& value, Literal when) {
  if (is_pointer(value)) throw std::logic_error("a pointer in watched memory");
  const Word u = unset_bits(*value);
  for (std::size_t k = 0; k < bytes_of(*value); ++k) {
    const Word at = beyond(graph_, offset, k);
    const auto part = [k](const Word& w) {
      const auto first = w.begin() + static_cast<long>(byte_bits * k);
      return Word(first, first + byte_bits);
    };
    const ValuePtr byte = number(part(value->bits), u.empty() ? Word{} : part(u));
    for (std::size_t w = 0; w < object.watched.size(); ++w) {
      const Literal here = graph_.both(when, circuit::equal(graph_, object.watched[w], at));
      if (here != never)
        mmverify::source::executor::store(object, w, chosen(graph_, here, byte, loaded(object, w, 1)));
    }
  }
}

const Object* Executor::watched_at(const State& s, const ValuePtr& p) const {
  if (p->targets.size() != 1 || p->targets.front().object <= 0) return nullptr;
  const Object* object = s.memory.find(p->targets.front().object);
  return object == nullptr || object->watched.empty() ? nullptr : object;
}

void Executor::require_room(const State& s, const ValuePtr& p, const Word& size, const llvm::Instruction& at,
                            const char* what) {
  const auto wide = [](const Word& w) { return circuit::resized(w, pointer_bits + 1, false); };
  for (const Target& t : p->targets) {
    const Object* object = object_at(s, t, t.when, at, "copied");
    if (object == nullptr) continue;
    const Word room =
        object->size.empty() ? circuit::constant(object->cells.size(), pointer_bits) : object->size;
    const Word end = circuit::sum(graph_, wide(t.offset), wide(size));
    require_never(Duty::bounds, graph_.both(t.when, circuit::less(graph_, wide(room), end)), at, what);
  }
}

void Executor::require_not_constant(const Object& object, const llvm::Instruction& at) {
  if (object.constant)
    require_never(Duty::constants, always, at, "the constant " + object.name + " is written");
}

Literal Executor::is_inside(std::size_t k, const Word& size) {
  return circuit::less(graph_, circuit::constant(k, size.size()), size);
}

Literal Executor::is_inside(const Word& place, const Word& from, const Word& size) {
  return graph_.both(negated(circuit::less(graph_, place, from)),
                     circuit::less(graph_, circuit::difference(graph_, place, from), size));
}

bool Executor::fill_watched(State& s, const ValuePtr& to, const ValuePtr& byte, const Word& size,
                            const llvm::Instruction& at) {
  const Object* object = watched_at(s, to);
  if (object == nullptr) return false;
  require_room(s, to, size, at, "more bytes are set than there are");
  require_not_constant(*object, at);
  const Target& t = to->targets.front();
  Object& own = s.memory.writable(t.object);
  for (std::size_t w = 0; w < own.watched.size(); ++w)
    mmverify::source::executor::store(
        own, w,
        chosen(graph_, is_inside(own.watched[w], t.offset, circuit::resized(size, pointer_bits, false)), byte,
               loaded(own, w, 1)));
  return true;
}

bool Executor::copy_watched(State& s, const ValuePtr& to, const ValuePtr& from, const Word& size,
                            const llvm::Instruction& at) {
  const Object* target = watched_at(s, to);
  if (target == nullptr && watched_at(s, from) == nullptr) return false;
  require_room(s, to, size, at, "a copy of more bytes than there are");
  require_room(s, from, size, at, "a copy of more bytes than there are");
  llvm::LLVMContext& context = module_.getContext();
  constexpr std::uint64_t word = 8;
  if (const auto bytes = circuit::value_of(size); bytes && *bytes <= word) {
    if (*bytes == 0) return true;
    const auto width = static_cast<unsigned>(byte_bits * *bytes);
    store(s, to, load(s, from, *bytes, *llvm::Type::getIntNTy(context, width), at), always, at);
    return true;
  }
  if (target == nullptr) {
    const Target& f = from->targets.front();
    for (std::size_t k = 0; k < most_bytes(s, to, size, at); ++k) {
      const ValuePtr byte = load_watched(*s.memory.find(f.object), beyond(graph_, f.offset, k), 1);
      store(s, moved_by(to, circuit::constant(k, pointer_bits)), byte, is_inside(k, size), at);
    }
    return true;
  }
  require_not_constant(*target, at);
  const Target& t = to->targets.front();
  const std::vector<Word> watched = target->watched;
  std::vector<std::pair<Literal, ValuePtr>> copied;
  const Literal running = running_;
  for (const Word& place : watched) {
    const Literal here = is_inside(place, t.offset, circuit::resized(size, pointer_bits, false));
    running_ = graph_.both(running, here);
    const Word by = circuit::difference(graph_, place, t.offset);
    copied.emplace_back(here, load(s, moved_by(from, by), 1, *llvm::Type::getInt8Ty(context), at));
  }
  running_ = running;
  Object& own = s.memory.writable(t.object);
  for (std::size_t w = 0; w < watched.size(); ++w)
    mmverify::source::executor::store(own, w,
                                      chosen(graph_, copied[w].first, copied[w].second, loaded(own, w, 1)));
  return true;
}

}  // namespace mmverify::source::executor
