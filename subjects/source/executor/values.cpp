// Operands of instructions: registers, constants, and global variables when they are first met.
#include <llvm/IR/Constants.h>
#include <llvm/IR/GlobalAlias.h>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

std::size_t width_of(const llvm::Type& type, const llvm::Instruction& at) {
  if (!type.isIntegerTy()) {
    if (type.isFloatingPointTy()) throw Unreadable(at, "a floating-point number");
    throw Unreadable(at, "a value of a type that is neither a number of bits nor a pointer");
  }
  if (type.getIntegerBitWidth() > 64) throw Unreadable(at, "a number of more than 64 bits");
  return type.getIntegerBitWidth();
}

/// A type's description or table of functions that is elsewhere: it has an address, and nothing of it may be read.
bool is_of_type(const llvm::GlobalVariable& global) {
  return !global.hasInitializer() &&
         (global.getName().startswith("_ZTI") || global.getName().startswith("_ZTV"));
}
/// No table of the standard exceptions has more.
constexpr std::size_t bytes_of_type = 256;

}  // namespace

ValuePtr Executor::value(State& s, const llvm::Value* v, const llvm::Instruction& at) {
  if (const auto found = s.values.find(v); found != s.values.end()) return found->second;
  if (const auto* c = llvm::dyn_cast<llvm::Constant>(v)) return constant(s, *c, at);
  throw Unreadable(at, "an operand that is no number, pointer or struct");
}

ValuePtr Executor::numeric(State& s, const llvm::Value* v, const llvm::Instruction& at) {
  ValuePtr got = value(s, v, at);
  if (got->kind == Value::Kind::number) return got;
  throw Unreadable(at, is_pointer(got) ? "a pointer taken for a number" : "a struct taken for a number");
}

ValuePtr Executor::unset_of(const llvm::Type& type, const llvm::Instruction& at) const {
  if (type.isPointerTy()) return pointer(unset_object);
  if (type.isStructTy() || type.isArrayTy()) {
    std::vector<ValuePtr> all;
    const unsigned count =
        type.isStructTy() ? type.getStructNumElements() : static_cast<unsigned>(type.getArrayNumElements());
    for (unsigned k = 0; k < count; ++k)
      all.push_back(
          unset_of(type.isStructTy() ? *type.getStructElementType(k) : *type.getArrayElementType(), at));
    return parts(std::move(all));
  }
  return unset_number(width_of(type, at));
}

ValuePtr Executor::constant(State& s, const llvm::Constant& c, const llvm::Instruction& at) {
  if (const auto* n = llvm::dyn_cast<llvm::ConstantInt>(&c))
    return number(n->getZExtValue(), width_of(*c.getType(), at));
  if (llvm::isa<llvm::ConstantPointerNull>(c)) return pointer(null_object);
  if (llvm::isa<llvm::UndefValue>(c)) return unset_of(*c.getType(), at);
  if (const auto* g = llvm::dyn_cast<llvm::GlobalVariable>(&c)) return pointer(object_of(*g, at));
  if (const auto* a = llvm::dyn_cast<llvm::GlobalAlias>(&c)) return constant(s, *a->getAliasee(), at);
  if (const auto* f = llvm::dyn_cast<llvm::Function>(&c)) {
    const auto [found, fresh] = function_numbers_.emplace(f, objects_ + 1);
    if (fresh) functions_[++objects_] = module_.getFunction(f->getName());
    return pointer(found->second);
  }
  if (c.isNullValue() || llvm::isa<llvm::ConstantAggregate>(c)) {
    std::vector<ValuePtr> all;
    for (unsigned k = 0; c.getAggregateElement(k) != nullptr; ++k)
      all.push_back(constant(s, *c.getAggregateElement(k), at));
    return parts(std::move(all));
  }
  if (const auto* gep = llvm::dyn_cast<llvm::GEPOperator>(&c)) return moved(s, *gep, at);
  if (const auto* e = llvm::dyn_cast<llvm::ConstantExpr>(&c);
      e != nullptr && e->getOpcode() == llvm::Instruction::BitCast)
    return constant(s, *e->getOperand(0), at);
  throw Unreadable(at, "a constant that is computed in a way which cannot be followed");
}

int Executor::object_of(const llvm::GlobalVariable& global, const llvm::Instruction& at) const {
  if (const auto found = globals_.find(&global); found != globals_.end()) return found->second;
  if (global.isThreadLocal()) throw Unreadable(at, "the thread's own variable " + global.getName().str());
  throw Unreadable(at, "the variable " + global.getName().str() + ", whose first value is not known here");
}

namespace {

bool alike(const Value& a, const Value& b) {
  const auto same_target = [](const Target& x, const Target& y) {
    return x.when == y.when && x.object == y.object && x.offset == y.offset;
  };
  return a.kind == b.kind && a.bits == b.bits && a.unset == b.unset &&
         std::equal(a.targets.begin(), a.targets.end(), b.targets.begin(), b.targets.end(), same_target) &&
         std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const ValuePtr& x, const ValuePtr& y) { return alike(*x, *y); });
}

bool alike(const Cell& a, const Cell& b) {
  if (a.byte != b.byte || (a.value == nullptr) != (b.value == nullptr)) return false;
  return a.value == b.value || alike(*a.value, *b.value);
}

}  // namespace

void Executor::require_described(const State& s, const llvm::Instruction& at) {
  for (const auto& [global, number] : globals_) {
    const Object* now = s.memory.find(number);
    if (now == nullptr || !now->lasting || now->constant) continue;
    const auto [first, fresh] = described_.emplace(number, *now);
    const std::vector<Cell>&was = first->second.cells, &is = now->cells;
    if (!fresh && !std::equal(was.begin(), was.end(), is.begin(), is.end(),
                              [](const Cell& a, const Cell& b) { return alike(a, b); }))
      throw Unreadable(at, "a later call of mmverify_subject_v1 changes " + now->name);
  }
}

void Executor::make_globals(State& s, const llvm::Instruction& at) {
  const bool by_contract =
      module_.getFunction("stands_for") != nullptr || module_.getFunction("watched_memory") != nullptr;
  // Numbers first: a variable's first value may have the address of another one.
  for (const llvm::GlobalVariable& global : module_.globals())
    if ((global.hasInitializer() || is_of_type(global)) && !global.isThreadLocal())
      globals_[&global] = ++objects_;
  for (const llvm::GlobalVariable& global : module_.globals()) {
    const auto number = globals_.find(&global);
    if (number == globals_.end()) continue;
    Object object;
    object.name = global.getName().str();
    object.cells.resize(global.hasInitializer() ? layout_.getTypeAllocSize(global.getValueType())
                                                : bytes_of_type);
    object.constant = global.isConstant();
    // A proof by contract notes what the functions of the law have seen.
    object.lasting = !by_contract || !global.hasAttribute(law_attribute);
    object.align = layout_.getValueOrABITypeAlignment(global.getAlign(), global.getValueType()).value();
    try {
      if (global.hasInitializer()) initialize(s, object, 0, *global.getInitializer(), at);
      s.memory.add(number->second, std::move(object));
    } catch (const Unreadable&) {
      // A program that needs the variable is told so where it needs it.
      globals_.erase(number);
    }
  }
}

void Executor::initialize(State& s, Object& object, std::size_t at, const llvm::Constant& c,
                          const llvm::Instruction& where) {
  const llvm::Type& type = *c.getType();
  const std::size_t bytes = layout_.getTypeAllocSize(c.getType());
  if (llvm::isa<llvm::UndefValue>(c)) return;
  if (type.isArrayTy() || type.isStructTy()) {
    for (std::size_t k = 0; k < bytes; ++k) mmverify::source::executor::store(object, at + k, number(0, 8));
    const unsigned count =
        type.isStructTy() ? type.getStructNumElements() : static_cast<unsigned>(type.getArrayNumElements());
    for (unsigned k = 0; k < count; ++k) {
      const llvm::Constant& part = *c.getAggregateElement(k);
      const std::size_t offset =
          type.isStructTy()
              ? layout_.getStructLayout(llvm::cast<llvm::StructType>(c.getType()))->getElementOffset(k)
              : k * layout_.getTypeAllocSize(type.getArrayElementType());
      initialize(s, object, at + offset, part, where);
    }
    return;
  }
  // A float in a table is bits until the program computes with it.
  if (const auto* f = llvm::dyn_cast<llvm::ConstantFP>(&c))
    return mmverify::source::executor::store(
        object, at, number(f->getValueAPF().bitcastToAPInt().getZExtValue(), 8 * bytes));
  ValuePtr v = constant(s, c, where);
  if (v->kind == Value::Kind::number) v = number(circuit::resized(v->bits, 8 * bytes, false));
  mmverify::source::executor::store(object, at, v);
}

}  // namespace mmverify::source::executor
