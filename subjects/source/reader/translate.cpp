// Translates LLVM instructions to operations. Branches become conditions: a block is reached if one of its
// edges is taken, and a phi becomes a choice by its edges.
#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Analysis/CFG.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>
#include <llvm/Support/raw_ostream.h>

#include <map>
#include <optional>

#include "subjects/source/reader/intrinsics.hpp"
#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/reasons.hpp"
#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {
namespace {

using Number = std::uint32_t;

/// The file and line; empty if unknown.
std::string place(const llvm::Instruction& at) {
  return line_of(at) == nullptr ? std::string() : place_of(at);
}

std::string name_of(const llvm::Instruction& at) {
  std::string name = at.getOpcodeName();
  if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&at)) {
    const llvm::Function* to = call->getCalledFunction();
    name += to != nullptr ? " of " + to->getName().str() : " of what is not known before it runs";
  }
  return name;
}

[[noreturn]] void not_known(const llvm::Instruction& at, const std::string& why = {}) {
  const std::string where = place(at), file = at.getFunction()->getParent()->getSourceFileName();
  throw NotKnown((where.empty() ? file : where) + ": " + name_of(at) + (why.empty() ? "" : ": " + why));
}

using I = llvm::Instruction;

/// The instructions that are operations with the same operands, two or one.
const std::map<unsigned, Op> of_two{{I::Sub, Op::sub},     {I::Mul, Op::mul},     {I::Shl, Op::shl},
                                    {I::AShr, Op::ashr},   {I::And, Op::bit_and}, {I::Or, Op::bit_or},
                                    {I::Xor, Op::bit_xor}, {I::FAdd, Op::fadd},   {I::FSub, Op::fsub},
                                    {I::FMul, Op::fmul},   {I::FDiv, Op::fdiv}};
const std::map<unsigned, Op> of_one{
    {I::SExt, Op::sext},     {I::Trunc, Op::trunc},   {I::Freeze, Op::freeze},  {I::FNeg, Op::fneg},
    {I::Load, Op::read},     {I::FPToUI, Op::fptoui}, {I::FPToSI, Op::fptosi},  {I::UIToFP, Op::uitofp},
    {I::SIToFP, Op::sitofp}, {I::FPExt, Op::fpext},   {I::FPTrunc, Op::fptrunc}};

class Translation {
 public:
  Translation(const llvm::Function& f, Planted planted) : function_(f), planted_(planted) {}

  Program run() {
    llvm::SmallVector<std::pair<const llvm::BasicBlock*, const llvm::BasicBlock*>, 4> loops;
    llvm::FindFunctionBackedges(function_, loops);
    if (!loops.empty()) not_known(*loops.front().first->getTerminator(), "a loop that no constant ends");
    values_[function_.getArg(0)] = add({Op::input_u, {true, 32}});
    values_[function_.getArg(1)] = add({Op::input_v, {true, 32}});
    const llvm::ReversePostOrderTraversal<const llvm::Function*> in_order(&function_);
    for (const llvm::BasicBlock* block : in_order) translate(*block);
    if (!result_) throw NotKnown(function_.getParent()->getSourceFileName() + ": it never returns");
    program_.result = *result_;
    return std::move(program_);
  }

 private:
  using Block = const llvm::BasicBlock*;

  Number add(Node node) {
    program_.nodes.push_back(std::move(node));
    return static_cast<Number>(program_.nodes.size() - 1);
  }
  Number word(std::uint64_t value, unsigned bits) { return add({Op::constant, {false, bits}, {}, {value}}); }
  Number yes_or_no(bool yes) { return word(yes ? 1 : 0, 1); }
  const Type& type_of(Number k) const { return program_.nodes[k].type; }
  /// a and b; poison of b does not count if a is 0.
  Number both(Number a, Number b) { return add({Op::select, {false, 1}, {a, b, yes_or_no(false)}}); }

  void forbid(const llvm::Instruction& at, Number condition, const std::string& what) {
    const std::string where = place(at);
    program_.forbidden.push_back(
        {both(reached_.at(at.getParent()), condition), what + (where.empty() ? "" : ", " + where)});
  }

  static std::optional<Type> type_of(const llvm::Type* t) {
    if (t->isFloatTy()) return Type{true, 32};
    if (t->isDoubleTy()) return Type{true, 64};
    if (t->isIntegerTy() && t->getIntegerBitWidth() <= 64) return Type{false, t->getIntegerBitWidth()};
    return std::nullopt;
  }
  static Type type_at(const llvm::Instruction& at, const llvm::Type* t) {
    const auto type = type_of(t);
    if (!type) {
      std::string text;
      llvm::raw_string_ostream(text) << *t;
      not_known(at, "a value of type " + text);
    }
    return *type;
  }

  Number value(const llvm::Instruction& at, const llvm::Value* v) {
    if (const auto known = values_.find(v); known != values_.end()) return known->second;
    const Type type = type_at(at, v->getType());
    if (const auto* k = llvm::dyn_cast<llvm::ConstantInt>(v)) return word(k->getZExtValue(), type.bits);
    if (const auto* x = llvm::dyn_cast<llvm::ConstantFP>(v))
      return add({Op::constant, type, {}, {x->getValueAPF().bitcastToAPInt().getZExtValue()}});
    // Undefined values of the source are opaque calls by now (undefined.hpp). This one was written by a pass,
    // which knows that every bit is set later or none matters: it is arbitrary at each use.
    if (llvm::isa<llvm::UndefValue>(v)) return add({Op::freeze, type, {add({Op::unset, type})}});
    not_known(at, "an operand of a kind that is not known");
  }

  /// The condition that an edge is taken: its block is reached and branches there.
  Number edge(Block from, Block to) {
    const llvm::Instruction& end = *from->getTerminator();
    const Number here = reached_.at(from);
    if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(&end)) {
      if (branch->isUnconditional() || branch->getSuccessor(0) == branch->getSuccessor(1)) return here;
      Number taken = value(end, branch->getCondition());
      if (branch->getSuccessor(1) == to) taken = add({Op::bit_xor, {false, 1}, {taken, yes_or_no(true)}});
      return both(here, taken);
    }
    if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(&end)) {
      const Number of = value(end, choice->getCondition());
      Number any = yes_or_no(false);
      const bool is_default = choice->getDefaultDest() == to;
      for (const auto& one : choice->cases())
        if ((one.getCaseSuccessor() == to) != is_default) {
          const Number hit = add({Op::eq, {false, 1}, {of, value(end, one.getCaseValue())}});
          any = add({Op::bit_or, {false, 1}, {any, hit}});
        }
      return both(here, is_default ? add({Op::bit_xor, {false, 1}, {any, yes_or_no(true)}}) : any);
    }
    not_known(end);
  }

  void reach(Block block) {
    if (block == &function_.getEntryBlock()) {
      reached_[block] = yes_or_no(true);
      return;
    }
    std::optional<Number> any;
    std::map<Block, bool> done;
    for (const Block from : llvm::predecessors(block)) {
      if (reached_.count(from) == 0 || std::exchange(done[from], true)) continue;
      const Number taken = edges_[{from, block}] = edge(from, block);
      any = any ? add({Op::bit_or, {false, 1}, {*any, taken}}) : taken;
    }
    reached_[block] = any.value();
  }

  void translate(const llvm::BasicBlock& block) {
    reach(&block);
    for (const llvm::Instruction& at : block) {
      if (llvm::isa<llvm::DbgInfoIntrinsic>(at)) continue;
      if (at.isTerminator()) {
        end(at);
        continue;
      }
      if (at.getType()->isPointerTy()) {
        const auto* call = llvm::dyn_cast<llvm::CallInst>(&at);
        if (!llvm::isa<llvm::GetElementPtrInst>(at) && !llvm::isa<llvm::BitCastInst>(at) &&
            (call == nullptr || guarded(*call) != Guarded::address))
          not_known(at, "a pointer");
        continue;  // the load follows it
      }
      const std::optional<Number> made = instruction(at);
      if (!made) continue;
      values_[&at] = *made;
      if (program_.nodes[*made].where.empty()) program_.nodes[*made].where = place(at);
    }
  }

  void end(const llvm::Instruction& at) {
    if (const auto* back = llvm::dyn_cast<llvm::ReturnInst>(&at)) {
      const Number one = value(at, back->getReturnValue());
      result_ = result_ ? add({Op::select, type_of(one), {reached_.at(at.getParent()), one, *result_}}) : one;
      return;
    }
    if (llvm::isa<llvm::UnreachableInst>(at))
      return forbid(at, yes_or_no(true), "a place that must not be reached");
    if (!llvm::isa<llvm::BranchInst>(at) && !llvm::isa<llvm::SwitchInst>(at)) not_known(at);
  }

  std::optional<Number> instruction(const llvm::Instruction& at) {
    if (const auto* math = llvm::dyn_cast<llvm::FPMathOperator>(&at);
        math != nullptr && math->getFastMathFlags().any())
      not_known(at, "fast-math flags, which leave its value open");
    if (const auto* phi = llvm::dyn_cast<llvm::PHINode>(&at)) return choice_of(*phi);
    if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&at)) return table(*load);
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&at)) return called(*call);
    const auto* compare = llvm::dyn_cast<llvm::CmpInst>(&at);
    return plain(at, at.getOpcode(), compare != nullptr ? compare->getPredicate() : flags_of(at), 0);
  }

  Number choice_of(const llvm::PHINode& phi) {
    std::vector<std::pair<Number, Number>> ways;  // edge, value
    std::map<Block, bool> done;
    for (unsigned k = 0; k < phi.getNumIncomingValues(); ++k) {
      const Block from = phi.getIncomingBlock(k);
      if (reached_.count(from) == 0 || std::exchange(done[from], true)) continue;
      ways.emplace_back(edges_.at({from, phi.getParent()}), value(phi, phi.getIncomingValue(k)));
    }
    if (planted_ == Planted::swapped_edges && ways.size() == 2) std::swap(ways[0].second, ways[1].second);
    Number all = ways.back().second;
    for (std::size_t k = ways.size() - 1; k-- > 0;)
      all = add({Op::select, type_of(all), {ways[k].first, ways[k].second, all}});
    return all;
  }

  Number comparison(llvm::CmpInst::Predicate p, Number a, Number b) {
    using P = llvm::CmpInst::Predicate;
    if (p == P::ICMP_UGT || p == P::ICMP_UGE || p == P::ICMP_SGT || p == P::ICMP_SGE) {
      std::swap(a, b);
      p = llvm::CmpInst::getSwappedPredicate(p);
    }
    Op op = p == P::ICMP_EQ    ? Op::eq
            : p == P::ICMP_NE  ? Op::ne
            : p == P::ICMP_ULT ? Op::ult
            : p == P::ICMP_ULE ? Op::ule
            : p == P::ICMP_SLT ? Op::slt
                               : Op::sle;
    if (planted_ == Planted::signed_compare && op == Op::ult) op = Op::slt;
    return add({op, {false, 1}, {a, b}});
  }

  /// Appends the elements of a constant, all of type `type`; false if some are of another type.
  bool elements(const llvm::Constant* of, Type type, std::vector<std::uint64_t>& into) const {
    if (const auto* k = llvm::dyn_cast<llvm::ConstantInt>(of)) {
      if (type.floating || k->getType()->getIntegerBitWidth() != type.bits) return false;
      into.push_back(k->getZExtValue());
      return true;
    }
    if (const auto* x = llvm::dyn_cast<llvm::ConstantFP>(of)) {
      if (!type.floating || x->getType()->getPrimitiveSizeInBits() != type.bits) return false;
      into.push_back(x->getValueAPF().bitcastToAPInt().getZExtValue());
      return true;
    }
    const llvm::Type* t = of->getType();
    const std::uint64_t count = t->isArrayTy()    ? t->getArrayNumElements()
                                : t->isStructTy() ? t->getStructNumElements()
                                                  : 0;
    if (count == 0 || count > 1 << 16) return false;
    for (unsigned k = 0; k < count; ++k) {
      const llvm::Constant* one = of->getAggregateElement(k);
      if (one == nullptr || !elements(one, type, into)) return false;
    }
    return true;
  }

  Number table(const llvm::LoadInst& load) {
    if (!load.isSimple()) not_known(load, "volatile or atomic");
    const Type type = type_at(load, load.getType());
    const llvm::DataLayout& layout = function_.getParent()->getDataLayout();
    Number offset = word(0, 64);
    const llvm::Value* pointer = load.getPointerOperand();
    while (!llvm::isa<llvm::GlobalVariable>(pointer)) {
      const auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer);
      if (step == nullptr) {
        const auto* call = llvm::dyn_cast<llvm::CallInst>(pointer);
        if (!llvm::isa<llvm::BitCastOperator>(pointer) &&
            (call == nullptr || guarded(*call) != Guarded::address))
          not_known(load, "memory that is no constant table");
        pointer = llvm::cast<llvm::User>(pointer)->getOperand(0);
        continue;
      }
      offset = moved(load, *step, layout, offset);
      pointer = step->getPointerOperand();
    }
    const auto* global = llvm::cast<llvm::GlobalVariable>(pointer);
    if (!global->isConstant() || !global->hasDefinitiveInitializer())
      not_known(load, global->getName().str() + " is no constant");
    Node node{Op::table, type, {offset}, {layout.getTypeStoreSize(load.getType())}};
    if (!elements(global->getInitializer(), type, node.numbers) || node.numbers.size() < 2 ||
        (node.numbers.size() - 1) * node.numbers[0] != layout.getTypeAllocSize(global->getValueType()))
      not_known(load, global->getName().str() + " is no table of elements of one type");
    const Number made = add(std::move(node));
    forbid(load, add({Op::poisoned, {false, 1}, {made}}), "a read outside of a table");
    return made;
  }

  Number moved(const llvm::Instruction& at, const llvm::GEPOperator& step, const llvm::DataLayout& layout,
               Number offset) {
    const auto plus = [&](Number bytes) { offset = add({Op::add, {false, 64}, {offset, bytes}}); };
    const llvm::Type* inside = nullptr;  // the type that the previous step reached
    for (auto part = llvm::gep_type_begin(step); part != llvm::gep_type_end(step); ++part) {
      if (llvm::StructType* record = part.getStructTypeOrNull()) {
        const auto field = llvm::cast<llvm::ConstantInt>(part.getOperand())->getZExtValue();
        plus(word(layout.getStructLayout(record)->getElementOffset(static_cast<unsigned>(field)), 64));
        inside = part.getIndexedType();
        continue;
      }
      Number index = value(at, part.getOperand());
      if (type_of(index).bits < 64) index = add({Op::sext, {false, 64}, {index}});
      if (inside != nullptr && inside->isArrayTy()) {
        const std::uint64_t last = inside->getArrayNumElements() - 1;
        const auto* known = llvm::dyn_cast<llvm::ConstantInt>(part.getOperand());
        if (known == nullptr || known->getValue().ugt(last))
          forbid(at, add({Op::ult, {false, 1}, {word(last, 64), index}}), "a read outside of a table's row");
      }
      plus(add({Op::mul, {false, 64}, {index, word(layout.getTypeAllocSize(part.getIndexedType()), 64)}}));
      inside = part.getIndexedType();
    }
    return offset;
  }

  std::optional<Number> assumed(const llvm::CallInst& call, Number held) {
    forbid(call, add({Op::poisoned, {false, 1}, {held}}), "an assumption on a value that is undefined");
    forbid(call, add({Op::bit_xor, {false, 1}, {held, yes_or_no(true)}}), "an assumption that does not hold");
    return std::nullopt;
  }

  Number plain_sum(const llvm::CallInst& call, unsigned opcode, unsigned flags, Number a, Number b) {
    const Op op = opcode == I::Add ? Op::add : opcode == I::Sub ? Op::sub : Op::mul;
    return add({op, type_at(call, call.getArgOperand(2)->getType()), {a, b}, {}, flags});
  }

  /// The operation of an intrinsic whose operands in the call begin at `first`.
  std::optional<Number> intrinsic(const llvm::CallInst& call, llvm::Intrinsic::ID id, unsigned first) {
    const auto of = [&](unsigned k) { return value(call, call.getArgOperand(first + k)); };
    const auto make = [&](Op op, unsigned count) {
      Node node{op, type_at(call, call.getType())};
      for (unsigned k = 0; k < count; ++k) node.of.push_back(of(k));
      return add(std::move(node));
    };
    const auto flagged = [&](Op op) {
      const Number made = make(op, 1);
      if (word_of(call, first + 1) != 0) program_.nodes[made].flags = defined_at_all_but_zero;
      return made;
    };
    if (const auto known = plain_intrinsic(id)) return make(known->first, known->second);
    switch (id) {
      case llvm::Intrinsic::ctlz: return flagged(Op::ctlz);
      case llvm::Intrinsic::cttz: return flagged(Op::cttz);
      case llvm::Intrinsic::abs: return flagged(Op::abs);
      case llvm::Intrinsic::expect: return of(0);
      case llvm::Intrinsic::lifetime_start:
      case llvm::Intrinsic::lifetime_end:
      case llvm::Intrinsic::experimental_noalias_scope_decl: return std::nullopt;
      default:
        not_known(call, id == llvm::Intrinsic::not_intrinsic ? "" : llvm::Intrinsic::getBaseName(id).str());
    }
  }

  std::optional<Number> called(const llvm::CallInst& call) {
    const auto of = [&](unsigned k) { return value(call, call.getArgOperand(k)); };
    switch (guarded(call)) {
      case Guarded::operation:
        if (word_of(call, 0) == llvm::Instruction::Call)
          return intrinsic(call, static_cast<llvm::Intrinsic::ID>(word_of(call, 1)), 2);
        return plain(call, word_of(call, 0), word_of(call, 1), 2);
      case Guarded::unset: return add({Op::unset, type_at(call, call.getType())});
      case Guarded::overflow: {
        const Number made = plain_sum(call, word_of(call, 0), word_of(call, 1), of(2), of(3));
        forbid(call, add({Op::poisoned, {false, 1}, {made}}),
               "a sum, difference or product that does not fit");
        return std::nullopt;
      }
      case Guarded::branch:
        forbid(call, add({Op::poisoned, {false, 1}, {of(0)}}), "a branch on a value that is undefined");
        return std::nullopt;
      case Guarded::argument:
        forbid(call, add({Op::poisoned, {false, 1}, {of(0)}}), "an argument that is said to be set");
        return std::nullopt;
      case Guarded::outside:
        forbid(call, of(0), said(static_cast<Outside>(word_of(call, 1))));
        return std::nullopt;
      case Guarded::refused:
        throw NotKnown(place_of(call) + ": " + said(static_cast<Refusal>(word_of(call, 0))));
      case Guarded::unreachable:
        forbid(call, yes_or_no(true), "a place that must not be reached");
        return std::nullopt;
      case Guarded::assumption: return assumed(call, of(0));
      default: return intrinsic(call, call.getIntrinsicID(), 0);
    }
  }

  Number division(const llvm::Instruction& at, Op op, Number a, Number b, bool is_signed, unsigned flags) {
    const unsigned bits = type_of(b).bits;
    // The divisor must not be poison, as the condition of a branch must not.
    forbid(at, add({Op::poisoned, {false, 1}, {b}}), "division by a value that is undefined");
    forbid(at, add({Op::eq, {false, 1}, {b, word(0, bits)}}), "division by zero");
    if (is_signed) {
      const std::uint64_t least = std::uint64_t{1} << (bits - 1);
      const Number by_minus_one = add({Op::eq, {false, 1}, {b, word(least | (least - 1), bits)}});
      const Number of_least = add({Op::eq, {false, 1}, {a, word(least, bits)}});
      forbid(at, both(by_minus_one, of_least), "division that overflows");
    }
    return add({op, type_of(a), {a, b}, {}, flags});
  }

  /// The operation of the instruction with that opcode and detail (undefined.hpp). It is `at` itself, or the
  /// call `at` stands for it; its operands begin at `first`.
  Number plain(const llvm::Instruction& at, unsigned opcode, unsigned detail, unsigned first) {
    const unsigned flags = opcode == I::ICmp || opcode == I::FCmp ? 0 : detail;
    const Type type = type_at(at, at.getType());
    const auto of = [&](unsigned k) { return value(at, at.getOperand(first + k)); };
    const auto binary = [&](Op op) { return add({op, type, {of(0), of(1)}, {}, flags}); };
    const auto unary = [&](Op op) { return add({op, type, {of(0)}}); };
    if (const auto known = of_two.find(opcode); known != of_two.end()) return binary(known->second);
    if (const auto known = of_one.find(opcode); known != of_one.end()) return unary(known->second);
    switch (opcode) {
      case I::Add: {
        const Number made = binary(Op::add);
        if (planted_ == Planted::lost_wrap && type.bits == 32)
          return add({Op::bit_and, type, {made, word(0x7fffffff, 32)}});
        return made;
      }
      case I::UDiv: return division(at, Op::udiv, of(0), of(1), false, flags);
      case I::URem: return division(at, Op::urem, of(0), of(1), false, flags);
      case I::SDiv: return division(at, Op::sdiv, of(0), of(1), true, flags);
      case I::SRem: return division(at, Op::srem, of(0), of(1), true, flags);
      case I::LShr: {
        if (planted_ != Planted::shift_by_one_less) return binary(Op::lshr);
        const Number by = add({Op::usub_sat, type, {of(1), word(1, type.bits)}});
        return add({Op::lshr, type, {of(0), by}});
      }
      case I::Select: return add({Op::select, type, {of(0), of(1), of(2)}});
      case I::ZExt: return unary(planted_ == Planted::widened_with_sign ? Op::sext : Op::zext);
      case I::ICmp: return comparison(static_cast<llvm::CmpInst::Predicate>(detail), of(0), of(1));
      case I::FCmp: return add({Op::fcmp, type, {of(0), of(1)}, {detail}});
      case I::BitCast: {
        const Number from = of(0);
        if (type_of(from) == type) return from;
        return add({type.floating ? Op::float_of : Op::bits_of, type, {from}});
      }
      default: not_known(at);
    }
  }

  const llvm::Function& function_;
  Planted planted_;
  Program program_;
  std::map<const llvm::Value*, Number> values_;
  std::map<Block, Number> reached_;
  std::map<std::pair<Block, Block>, Number> edges_;
  std::optional<Number> result_;
};

}  // namespace

Program translate(const llvm::Function& function, Planted planted) {
  return Translation(function, planted).run();
}

}  // namespace mmverify::source
