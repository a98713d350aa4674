// Exceptions of C++: an object is thrown, unwinds calls that catch none of its type, and lands where one does.
#include <llvm/IR/DebugInfoMetadata.h>

#include <array>
#include <string_view>
#include <utility>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

/// The name of a type, as LLVM's bitcode mangles it, behind this prefix.
constexpr std::string_view type_prefix = "_ZTI";

std::string type_of(const llvm::Value& info, const llvm::Instruction& at) {
  const llvm::Value* global = info.stripPointerCasts();
  const std::string name = global->getName().str();
  if (!name.starts_with(type_prefix)) throw Unreadable(at, "an exception of a type without a name");
  return name.substr(type_prefix.size());
}

/// Types of the standard library, which have no body here, and the type each is derived from.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> standard_types{
    {{"St9exception", ""},
     {"St9bad_alloc", "St9exception"},
     {"St20bad_array_new_length", "St9bad_alloc"},
     {"St11logic_error", "St9exception"},
     {"St12domain_error", "St11logic_error"},
     {"St12length_error", "St11logic_error"},
     {"St12out_of_range", "St11logic_error"},
     {"St16invalid_argument", "St11logic_error"},
     {"St13runtime_error", "St9exception"},
     {"St11range_error", "St13runtime_error"},
     {"St14overflow_error", "St13runtime_error"}}};

/// The type of the exception that a function of the standard library throws; empty for other functions.
std::string_view thrown_by(std::string_view name) {
  constexpr std::string_view before = "__throw_";
  const std::size_t at = name.find(before);
  if (!name.starts_with("_ZSt") || at == name.npos) return {};
  for (const auto& [type, base] : standard_types) {
    const std::string_view words = type.substr(type.find_first_not_of("St0123456789"));
    if (name.substr(at + before.size()).starts_with(words)) return type;
  }
  return {};
}

/// A constructor or destructor of a standard exception: it touches the exception's own bytes, which no program reads.
bool is_of_standard_exception(std::string_view name) {
  constexpr std::string_view member = "_ZN";
  if (!name.starts_with(member)) return false;
  name.remove_prefix(member.size());
  for (const auto& [type, base] : standard_types)
    if (name.starts_with(type)) {
      const std::string_view rest = name.substr(type.size());
      return rest.starts_with("C1") || rest.starts_with("C2") || rest.starts_with("D1") ||
             rest.starts_with("D2");
    }
  return false;
}

/// A destructor that does nothing but call such destructors. Exceptions are never destroyed here, so others cannot be
/// followed.
bool does_nothing(const llvm::Function& f) {
  if (is_of_standard_exception(f.getName())) return true;
  if (f.isDeclaration()) return false;
  for (const llvm::BasicBlock& block : f)
    for (const llvm::Instruction& i : block) {
      if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&i)) {
        const llvm::Function* to = call->getCalledFunction();
        if (to == nullptr || (!to->isIntrinsic() && !does_nothing(*to))) return false;
      } else if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(&i)) {
        if (!llvm::isa<llvm::AllocaInst>(store->getPointerOperand())) return false;
      }
    }
  return true;
}

}  // namespace

bool Executor::may_throw(const llvm::Function& f) {
  const llvm::DISubprogram* text = f.getSubprogram();
  return text != nullptr && !f.doesNotThrow() &&
         llvm::dwarf::isCPlusPlus(
             static_cast<llvm::dwarf::SourceLanguage>(text->getUnit()->getSourceLanguage()));
}

unsigned Executor::number_of_type(const std::string& type) {
  return type_numbers_.emplace(type, static_cast<unsigned>(type_numbers_.size()) + 1).first->second;
}
unsigned Executor::number_of_type(const llvm::Value& info, const llvm::Instruction& at) {
  return number_of_type(type_of(info, at));
}

bool Executor::is_derived(const std::string& type, const std::string& base,
                          const llvm::Instruction& at) const {
  if (type == base) return true;
  if (type.size() == 1) return false;  // a number's type, as int is
  for (const auto& [known, its_base] : standard_types)
    if (known == type) return !its_base.empty() && is_derived(std::string(its_base), base, at);
  const llvm::GlobalVariable* info = module_.getNamedGlobal(std::string(type_prefix) + type);
  if (info == nullptr || !info->hasInitializer())
    throw Unreadable(at, "an exception of the type " + type + ", whose bases are not known here");
  // A type has its vtable and its name; then one base, at the same place; or several, and where they are.
  const unsigned members = info->getInitializer()->getNumOperands();
  if (members == 2) return false;
  if (members > 3) throw Unreadable(at, "an exception with several bases");
  return is_derived(type_of(*info->getInitializer()->getOperand(2), at), base, at);
}

std::optional<unsigned> Executor::caught_as(const llvm::LandingPadInst& pad, const std::string& type) {
  for (unsigned k = 0; k < pad.getNumClauses(); ++k) {
    if (pad.isFilter(k)) throw Unreadable(pad, "a list of the exceptions that a function may throw");
    if (pad.getClause(k)->isNullValue()) return number_of_type("");
    if (const std::string of = type_of(*pad.getClause(k), pad); is_derived(type, of, pad))
      return number_of_type(of);
  }
  return pad.isCleanup() ? std::optional(0U) : std::nullopt;
}

void Executor::throws(State& s, ValuePtr exception, const std::string& type, const llvm::Instruction& at) {
  if (!is_pointer(exception) || exception->targets.size() != 1)
    throw Unreadable(at, "one exception or another is thrown");
  thrown_types_[exception->targets.front().object] = {type, place_of(at)};
  thrown_ = s;
  thrown_->exception = std::move(exception);
  s.when = never;
}

void Executor::unwind(Call& c, State thrown, const llvm::Instruction& at) {
  if (const auto* invoke = llvm::dyn_cast<llvm::InvokeInst>(&at)) {
    Literal lands = never;
    for (const Target& t : thrown.exception->targets)
      if (caught_as(*invoke->getLandingPadInst(), thrown_types_.at(t.object).name))
        lands = graph_.either(lands, t.when);
    State landing = thrown;
    landing.when = graph_.both(thrown.when, lands);
    thrown.when = graph_.both(thrown.when, negated(lands));
    if (possible(landing.when)) go(c, at, *invoke->getUnwindDest(), std::move(landing));
    if (!possible(thrown.when)) return;
  }
  leave(c, std::move(thrown), at);
}

void Executor::leave(Call& c, State thrown, const llvm::Instruction& at) {
  c.lost = true;
  const auto* call = llvm::dyn_cast<llvm::CallBase>(&at);
  const bool of_law = c.function.hasFnAttribute(law_attribute);
  if (of_law || c.function.doesNotThrow() || (call != nullptr && call->doesNotThrow())) {
    running_ = condition(thrown);
    for (const Target& t : thrown.exception->targets)
      require_never(Duty::ends, t.when, at,
                    "an exception that is thrown at " + thrown_types_.at(t.object).thrown_at + " leaves " +
                        (of_law ? "an entry point" : "a function that throws none"));
    return;
  }
  thrown.values.clear();
  thrown.turns.clear();
  thrown.memory.drop(c.number);
  if (c.thrown)
    merge(*c.thrown, std::move(thrown));
  else
    c.thrown = std::move(thrown);
}

ValuePtr Executor::landed(State& s, const llvm::LandingPadInst& pad) {
  ValuePtr selector = number(0, 32);
  for (const Target& t : s.exception->targets)
    if (const auto as = caught_as(pad, thrown_types_.at(t.object).name))
      selector = chosen(graph_, t.when, number(*as, 32), selector);
  return parts({std::exchange(s.exception, nullptr), selector});
}

std::optional<bool> Executor::call_of_exceptions(State& s, const llvm::CallBase& i, const std::string& name) {
  const auto argument = [&](unsigned k) { return value(s, i.getArgOperand(k), i); };
  if (name == "__cxa_allocate_exception") {
    s.values[&i] = allocated(s, numeric(s, i.getArgOperand(0), i)->bits, false, i);
  } else if (name == "__cxa_throw") {
    if (const llvm::Value* end = i.getArgOperand(2)->stripPointerCasts();
        !llvm::isa<llvm::ConstantPointerNull>(end))
      if (const auto* f = llvm::dyn_cast<llvm::Function>(end); f == nullptr || !does_nothing(*f))
        throw Unreadable(i, "an exception whose destructor does something");
    throws(s, argument(0), type_of(*i.getArgOperand(1), i), i);
    return false;
  } else if (const std::string_view type = thrown_by(name); !type.empty()) {
    Object object;
    object.name = "an exception";
    s.memory.add(++objects_, std::move(object));
    throws(s, pointer(objects_), std::string(type), i);
    return false;
  } else if (name == "__cxa_begin_catch") {
    s.caught.push_back(argument(0));
    s.values[&i] = s.caught.back();
  } else if (name == "__cxa_get_exception_ptr") {
    s.values[&i] = argument(0);
  } else if (name == "__cxa_end_catch" && !s.caught.empty()) {
    s.caught.pop_back();
  } else if (name == "__cxa_rethrow" && !s.caught.empty()) {
    thrown_ = s;
    thrown_->exception = s.caught.back();
    s.when = never;
    return false;
  } else if (name != "__cxa_free_exception" && !is_of_standard_exception(name)) {
    return std::nullopt;
  }
  return true;
}

}  // namespace mmverify::source::executor
