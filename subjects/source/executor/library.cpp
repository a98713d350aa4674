// Calls: functions with a body, the laws' own functions, and those of C's library that codecs use.
#include <llvm/Demangle/Demangle.h>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

/// An allocation whose size the inputs decide is at most that large.
constexpr std::uint64_t largest_allocation = 1 << 16;
/// Memory of malloc and of operator new lies at multiples of it: alignof(max_align_t).
constexpr std::uint64_t allocation_align = 16;
/// Conflicts for the question whether a bit of a size may be set.
constexpr int size_effort = 1000;

bool is_allocation(const std::string& name) {
  return name == "malloc" || name == "calloc" || name == "_Znwm" || name == "_Znam";
}
bool is_release(const std::string& name) {
  return name == "free" || name == "_ZdlPv" || name == "_ZdaPv" || name == "_ZdlPvm" || name == "_ZdaPvm";
}

}  // namespace

bool Executor::call_instruction(State& s, const llvm::CallBase& i) {
  if (i.isInlineAsm()) throw Unreadable(i, "assembly");
  llvm::Function* f = i.getCalledFunction();
  if (f == nullptr) {
    const ValuePtr to = value(s, i.getCalledOperand(), i);
    if (!is_pointer(to) || to->targets.size() != 1) throw Unreadable(i, "a call of one function or another");
    const auto found = functions_.find(to->targets.front().object);
    if (found == functions_.end()) {
      require_never(Duty::pointers, always, i, "a call through a pointer to no function");
      return false;
    }
    f = found->second;
  }
  if (f->isIntrinsic()) return call_intrinsic(s, i);
  const std::string name = f->getName().str();
  // A function of the codec's own may have the name of one of the law's, which have no body.
  if (f->isDeclaration() && call_law(s, i, name)) return s.when != never;
  if (f->isDeclaration() && &stand_in(*f, &i) == f) {
    const std::optional<bool> goes_on = call_of_exceptions(s, i, name);
    return goes_on ? *goes_on : call_library(s, i, name);
  }
  if (f->doesNotReturn() && !may_throw(*f)) return never_called(s, name, i);
  if (f->isVarArg()) throw Unreadable(i, name + " takes any number of arguments");
  std::vector<ValuePtr> arguments;
  for (unsigned k = 0; k < i.arg_size(); ++k) {
    const ValuePtr given = value(s, i.getArgOperand(k), i);
    arguments.push_back(i.isByValArgument(k) && planted != Mistake::shared_by_value ? copied(s, given, i, k)
                                                                                    : given);
  }
  if (name == "any_map" && arguments.size() == 3)
    if (const auto level = known(arguments[0]), bits = known(arguments[1]); level && bits && *level <= 8)
      sweeper_.map(static_cast<unsigned>(*level), static_cast<unsigned>(*bits));
  const ValuePtr result = call(*f, arguments, s, &i);
  if (s.when == never) return false;
  if (result != nullptr) s.values[&i] = result;
  return true;
}

ValuePtr Executor::copied(State& s, const ValuePtr& p, const llvm::CallBase& at, unsigned argument) {
  llvm::Type& type = *at.getParamByValType(argument);
  if (!is_pointer(p) || p->targets.size() != 1 || !circuit::value_of(p->targets.front().offset))
    throw Unreadable(at, "a struct of one variable or another is passed by value");
  const Target& t = p->targets.front();
  const Object* object = object_at(s, t, always, at, "read");
  const std::size_t bytes = layout_.getTypeAllocSize(&type);
  if (object == nullptr || offsets(*object, t.offset, bytes, always, at, "read").empty()) return p;
  Object copy;
  copy.name = object->name + ", passed by value,";
  const auto first = object->cells.begin() + static_cast<long>(*circuit::value_of(t.offset));
  copy.cells.assign(first, first + static_cast<long>(bytes));
  copy.call = calls_ + 1;
  copy.align =
      std::max(layout_.getABITypeAlign(&type).value(), at.getParamAlign(argument).valueOrOne().value());
  s.memory.add(++objects_, std::move(copy));
  return pointer(objects_);
}

bool Executor::never_called(State& s, const std::string& symbol, const llvm::Instruction& i) {
  // Rust's names end in a hash.
  std::string name = llvm::demangle(symbol);
  if (const std::size_t hash = name.rfind("::h"); hash != std::string::npos && name.size() == hash + 19)
    name.resize(hash);
  require_never(Duty::ends, always, i, name + " is called, which does not return");
  s.when = never;
  return false;
}

bool Executor::call_law(State& s, const llvm::CallBase& i, const std::string& name) {
  if (name == "any" || name == "any_state") {
    const auto bits = known(numeric(s, i.getArgOperand(0), i));
    if (!bits || *bits < 1 || *bits > 64)
      throw Unreadable(i, name + "() of a number of bits that is not known");
    Word word;
    for (std::uint64_t k = 0; k < *bits; ++k) word.push_back(graph_.input());
    choices_.push_back({running_, word});
    const std::size_t width = i.getType()->getIntegerBitWidth();
    s.values[&i] = number(circuit::resized(word, width, false));
    return true;
  }
  if (name == "stands_for") {
    put_in_place(s, i);
    return true;
  }
  if (name == "watched_memory") {
    s.values[&i] = watched_memory(s, i);
    return true;
  }
  if (name == "only_read") {
    make_constant(s, i);
    return true;
  }
  if (name != "check" && name != "assume") return false;
  const ValuePtr holds = numeric(s, i.getArgOperand(0), i);
  require_set(holds, i, "the answer depends on a value that was never set");
  const Literal broken = negated(circuit::not_zero(graph_, holds->bits));
  if (name == "check")
    require_never(Duty::checks, broken, i, "the check fails");
  else
    sweeper_.assume(negated(graph_.both(running_, broken)));
  return true;
}

bool Executor::call_library(State& s, const llvm::CallBase& i, const std::string& name) {
  const auto argument = [&](unsigned k) { return value(s, i.getArgOperand(k), i); };
  const auto size = [&](unsigned k) {
    const ValuePtr v = numeric(s, i.getArgOperand(k), i);
    require_set(v, i, "a size that was never set");
    return v->bits;
  };
  if (is_allocation(name)) {
    const bool zero = name == "calloc";
    s.values[&i] = allocated(s, zero ? circuit::product(graph_, size(0), size(1)) : size(0), zero, i);
  } else if (is_release(name)) {
    release(s, argument(0), i);
  } else if (name == "memcpy" || name == "memmove") {
    copy(s, argument(0), argument(1), size(2), name == "memmove", i);
    s.values[&i] = argument(0);
  } else if (name == "memset") {
    fill(s, argument(0), argument(1), size(2), i);
    s.values[&i] = argument(0);
  } else if (name == "memcmp" || name == "bcmp") {
    s.values[&i] = compared_bytes(s, argument(0), argument(1), size(2), i);
  } else if (name == "strlen") {
    s.values[&i] = length_of_text(s, argument(0), i);
  } else if (i.doesNotReturn()) {
    return never_called(s, name, i);
  } else {
    throw Unreadable(i, "a call of " + name + ", which has no body here");
  }
  return true;
}

ValuePtr Executor::allocated(State& s, Word size, bool zero, const llvm::Instruction& at) {
  // A bit of the size that is never set where the program gets here makes no room.
  for (Literal& bit : size)
    if (bit > always && sweeper_.both_possible(running_, bit, size_effort) == circuit::Answer::impossible)
      bit = never;
  const std::uint64_t most = circuit::at_most(size);
  if (most > largest_allocation)
    throw Unreadable(at, "an allocation of a size that the inputs decide, perhaps beyond " +
                             std::to_string(largest_allocation) + " bytes");
  Object object;
  object.name = "the allocation of " + place_of(at);
  object.cells.resize(most);
  object.align = allocation_align;
  if (!circuit::value_of(size)) object.size = size;
  if (zero)
    for (std::size_t k = 0; k < most; ++k) mmverify::source::executor::store(object, k, number(0, 8));
  s.memory.add(++objects_, std::move(object));
  return pointer(objects_);
}

void Executor::release(State& s, const ValuePtr& p, const llvm::Instruction& at) {
  if (!is_pointer(p)) throw Unreadable(at, "a number taken for a pointer");
  for (const Target& t : p->targets) {
    if (t.object == null_object) continue;
    const Object* object = object_at(s, t, t.when, at, "freed");
    if (object == nullptr) continue;
    require_never(Duty::life, graph_.both(t.when, circuit::not_zero(graph_, t.offset)), at,
                  "a pointer is freed that malloc did not return");
    if (object->call != 0 || object->lasting)
      require_never(Duty::life, t.when, at, object->name + " is freed, which malloc did not return");
    Object& own = s.memory.writable(t.object);
    own.gone = graph_.either(own.gone, t.when);
  }
}

std::size_t Executor::most_bytes(const State& s, const ValuePtr& p, const Word& size,
                                 const llvm::Instruction& at) const {
  std::size_t most = 0;
  for (const Target& t : p->targets)
    if (const Object* object = t.object > 0 ? s.memory.find(t.object) : nullptr) {
      if (!object->watched.empty())
        throw Unreadable(at, "bytes copied or compared one by one, in a proof by contract");
      most = std::max(most, object->cells.size());
    }
  return std::min<std::uint64_t>(most, circuit::at_most(size));
}

void Executor::require_apart(const ValuePtr& to, const ValuePtr& from, const Word& size,
                             const llvm::Instruction& at) {
  for (const Target& t : to->targets)
    for (const Target& f : from->targets) {
      if (t.object != f.object || t.object <= 0) continue;
      const Word ahead = circuit::difference(graph_, t.offset, f.offset),
                 behind = circuit::difference(graph_, f.offset, t.offset);
      const Literal meet =
          graph_.both(circuit::not_zero(graph_, ahead),
                      graph_.either(circuit::less(graph_, ahead, size), circuit::less(graph_, behind, size)));
      require_never(Duty::overlap, graph_.both(graph_.both(t.when, f.when), meet), at,
                    "memcpy between bytes that overlap");
    }
}

void Executor::copy(State& s, const ValuePtr& to, const ValuePtr& from, const Word& size, bool may_overlap,
                    const llvm::Instruction& at) {
  if (!is_pointer(to) || !is_pointer(from)) throw Unreadable(at, "a number taken for a pointer");
  if (!may_overlap) require_apart(to, from, size, at);
  if (copy_watched(s, to, from, size, at)) return;
  const std::size_t most = std::max(most_bytes(s, to, size, at), most_bytes(s, from, size, at));
  require_never(Duty::bounds, circuit::less(graph_, circuit::constant(most, size.size()), size), at,
                "a copy of more bytes than there are");
  // A whole object's bytes may be parts of pointers, which are moved as they are.
  const auto known_size = circuit::value_of(size);
  const auto plain = [&](const ValuePtr& p) {
    return p->targets.size() == 1 && p->targets.front().object > 0 &&
           circuit::value_of(p->targets.front().offset);
  };
  if (known_size && plain(to) && plain(from))
    return copy_cells(s, to->targets.front(), from->targets.front(), *known_size, at);
  const llvm::Type& byte = *llvm::Type::getInt8Ty(module_.getContext());
  std::vector<ValuePtr> bytes;
  const Literal running = running_;
  for (std::size_t k = 0; k < most; ++k) {
    running_ = graph_.both(running, is_inside(k, size));
    bytes.push_back(load(s, moved_by(from, circuit::constant(k, pointer_bits)), 1, byte, at));
  }
  for (std::size_t k = 0; k < most; ++k) {
    const Literal here = is_inside(k, size);
    running_ = graph_.both(running, here);
    store(s, moved_by(to, circuit::constant(k, pointer_bits)), bytes[k], here, at);
  }
  running_ = running;
}

void Executor::copy_cells(State& s, const Target& to, const Target& from, std::size_t bytes,
                          const llvm::Instruction& at) {
  if (bytes == 0) return;
  const Object *source = object_at(s, from, always, at, "read"),
               *target = object_at(s, to, always, at, "written");
  if (source == nullptr || target == nullptr) return;
  require_not_constant(*target, at);
  const auto read = offsets(*source, from.offset, bytes, always, at, "read");
  const auto written = offsets(*target, to.offset, bytes, always, at, "written");
  if (read.empty() || written.empty()) return;
  require_no_state(*target, at);
  if (planted == Mistake::copy_short) --bytes;
  const std::vector<Cell> cells(source->cells.begin() + static_cast<long>(read.front().second),
                                source->cells.begin() + static_cast<long>(read.front().second + bytes));
  Object& own = s.memory.writable(to.object);
  std::copy(cells.begin(), cells.end(), own.cells.begin() + static_cast<long>(written.front().second));
}

void Executor::fill(State& s, const ValuePtr& to, const ValuePtr& byte, const Word& size,
                    const llvm::Instruction& at) {
  if (!is_pointer(to)) throw Unreadable(at, "a number taken for a pointer");
  const ValuePtr one = number(circuit::resized(byte->bits, 8, false),
                              byte->unset.empty() ? Word{} : circuit::resized(byte->unset, 8, false));
  if (fill_watched(s, to, one, size, at)) return;
  const std::size_t most = most_bytes(s, to, size, at);
  require_never(Duty::bounds, circuit::less(graph_, circuit::constant(most, size.size()), size), at,
                "more bytes are set than there are");
  const Literal running = running_;
  for (std::size_t k = 0; k < most; ++k) {
    const Literal here = is_inside(k, size);
    running_ = graph_.both(running, here);
    store(s, moved_by(to, circuit::constant(k, pointer_bits)), one, here, at);
  }
  running_ = running;
}

ValuePtr Executor::length_of_text(State& s, const ValuePtr& p, const llvm::Instruction& at) {
  if (!is_pointer(p)) throw Unreadable(at, "a number taken for a pointer");
  const llvm::Type& byte = *llvm::Type::getInt8Ty(module_.getContext());
  const std::size_t most = most_bytes(s, p, Word(pointer_bits, always), at);
  Word length = circuit::constant(0, pointer_bits);
  const Literal running = running_;
  Literal goes_on = always;
  for (std::size_t k = 0; k <= most && goes_on != never; ++k) {
    running_ = graph_.both(running, goes_on);
    const Word here = circuit::constant(k, pointer_bits);
    const ValuePtr x = load(s, moved_by(p, here), 1, byte, at);
    require_set(x, at, "a byte of a text that was never set");
    if (is_pointer(x)) throw Unreadable(at, "a pointer's bytes taken for a text");
    length = circuit::chosen(graph_, goes_on, here, length);
    goes_on = graph_.both(goes_on, circuit::not_zero(graph_, x->bits));
  }
  running_ = running;
  return number(length);
}

ValuePtr Executor::compared_bytes(State& s, const ValuePtr& a, const ValuePtr& b, const Word& size,
                                  const llvm::Instruction& at) {
  const std::size_t most = std::max(most_bytes(s, a, size, at), most_bytes(s, b, size, at));
  require_never(Duty::bounds, circuit::less(graph_, circuit::constant(most, size.size()), size), at,
                "more bytes are compared than there are");
  const llvm::Type& byte = *llvm::Type::getInt8Ty(module_.getContext());
  Literal same = always, lower = never;
  const Literal running = running_;
  for (std::size_t k = most; k-- > 0;) {
    const Literal here = is_inside(k, size);
    running_ = graph_.both(running, here);
    const Word by = circuit::constant(k, pointer_bits);
    const ValuePtr x = load(s, moved_by(a, by), 1, byte, at), y = load(s, moved_by(b, by), 1, byte, at);
    require_set(x, at, "a byte that was never set is compared");
    require_set(y, at, "a byte that was never set is compared");
    if (is_pointer(x) || is_pointer(y)) throw Unreadable(at, "a comparison of a pointer's bytes");
    const Literal alike = graph_.either(negated(here), circuit::equal(graph_, x->bits, y->bits));
    lower = graph_.chosen(alike, lower, circuit::less(graph_, x->bits, y->bits));
    same = graph_.both(same, alike);
  }
  running_ = running;
  return chosen(graph_, same, number(0, 32),
                chosen(graph_, lower, number(~std::uint64_t{0}, 32), number(1, 32)));
}

}  // namespace mmverify::source::executor
