#include "subjects/source/reader/spirv/spirv.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <map>
#include <set>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/spirv/decorations.hpp"
#include "subjects/source/reader/spirv/functions.hpp"
#include "subjects/source/reader/spirv/module.hpp"
#include "subjects/source/reader/spirv/names.hpp"
#include "subjects/source/reader/spirv/types.hpp"
#include "subjects/source/reader/spirv/values.hpp"

namespace mmverify::source {
namespace {

/// The name without glslang's parameters: "index" for "index(u1;f1;f1;".
std::string plain_name(const std::string& name) { return name.substr(0, name.find('(')); }

/// The body of one function.
class Body {
 public:
  Body(const SpirvModule& module, const Types& types, Functions& functions, Lines& lines,
       const SpirvFunction& from, llvm::Function& into, Planted planted)
      : module_(module),
        types_(types),
        functions_(functions),
        lines_(lines),
        from_(from),
        into_(into),
        planted_(planted),
        values_(module, types, into.getContext(), planted),
        build_(values_.build()) {}

  void make() {
    lines_.begin(into_);
    look_at(from_.head, [&] {
      refuse_function_control(from_.head);
      refuse_promises_of(module_, from_.head.result);
    });
    unsigned argument = 0;
    for (const Instruction& p : from_.parameters) {
      Scalars all;
      for (std::size_t k = functions_.arguments(p.type); k > 0; --k) all.push_back(into_.getArg(argument++));
      look_at(p, [&] {
        if (module_.is_decorated(p.result, spv::RelaxedPrecision)) throw NotKnown(relaxed);
        refuse_promises_of(module_, p.result);
        values_.set(p, std::move(all));
      });
    }
    find_tables();
    for (const Instruction& i : from_.body)
      if (i.opcode == spv::Label)
        blocks_[i.result] = llvm::BasicBlock::Create(into_.getContext(), "", &into_);
    if (blocks_.empty()) invalid("a function without a body");
    for (const Instruction& i : from_.body) {
      build_.SetCurrentDebugLocation(lines_.at(i));
      look_at(i, [&] { instruction(i); });
    }
    for (const auto& [i, phis] : phis_) join(*i, phis);
  }

 private:
  static std::uint32_t operand(const Instruction& i, std::size_t k) { return Types::operand(i, k); }

  /// Adds the instruction's place to what is not known of it.
  template <class Look>
  void look_at(const Instruction& i, const Look& look) const {
    try {
      look();
    } catch (const NotKnown& why) {
      throw NotKnown(lines_.text(i) + ": " + why.what());
    }
  }

  llvm::BasicBlock* block(Id id) const {
    const auto found = blocks_.find(id);
    if (found == blocks_.end()) invalid("there is no label " + std::to_string(id));
    return found->second;
  }
  Id pointee_of(Id pointer) const { return types_.pointee(values_.type_of(pointer)); }

  /// Finds tables: variables that get one whole constant before they are read, and are only read afterwards.
  void find_tables() {
    std::map<Id, Id> roots;  // a pointer's variable
    std::map<Id, std::vector<Id>> stored;
    std::map<Id, int> stored_in;  // the block, by number; the first one comes before all
    std::set<Id> others;
    int block = 0;
    for (const Instruction& i : from_.body) {
      const auto root = [&](Id p) {
        const auto known = roots.find(p);
        return known != roots.end() ? known->second : 0;
      };
      const auto read = [&](Id variable) {
        const auto in = stored_in.find(variable);
        if (in == stored_in.end() || (in->second != block && in->second > 1)) others.insert(variable);
      };
      if (i.opcode == spv::Label) ++block;
      if (i.opcode == spv::Variable) {
        roots[i.result] = i.result;
        if (i.operands.size() > 1) {
          stored[i.result].push_back(i.operands[1]);
          stored_in[i.result] = 1;
        }
      } else if (i.opcode == spv::AccessChain || i.opcode == spv::InBoundsAccessChain) {
        roots[i.result] = root(operand(i, 0));
        read(roots[i.result]);
      } else if (i.opcode == spv::Load) {
        read(root(operand(i, 0)));
      } else if (i.opcode == spv::Store && root(operand(i, 0)) == operand(i, 0)) {
        stored[operand(i, 0)].push_back(operand(i, 1));
        stored_in[operand(i, 0)] = block;
      } else {
        for (const Id p : i.operands) others.insert(root(p));
      }
    }
    for (const auto& [variable, with] : stored)
      if (with.size() == 1 && types_.is_constant(with[0]) && others.count(variable) == 0)
        tables_[variable] = with[0];
  }

  void variable(const Instruction& i) {
    const Id type = types_.pointee(i.type);
    if (const auto table = tables_.find(i.result);
        table != tables_.end() && types_.parts(type) != 0 && types_.global(table->second).type == type) {
      std::size_t at = 0;
      Scalars numbers = types_.constant(table->second);
      if (planted_ == Planted::table_of_one) std::fill(numbers.begin(), numbers.end(), numbers.front());
      llvm::Constant* all = types_.joined(type, numbers, at);
      const auto name = module_.names.find(i.result);
      return values_.set(i, {new llvm::GlobalVariable(*into_.getParent(), all->getType(), true,
                                                      llvm::GlobalValue::InternalLinkage, all,
                                                      name != module_.names.end() ? name->second : "table")});
    }
    llvm::BasicBlock& entry = into_.getEntryBlock();
    llvm::IRBuilder<> first(&entry, entry.begin());
    first.SetCurrentDebugLocation(lines_.at(i));
    llvm::Value* address = first.CreateAlloca(types_.llvm_type(type));
    values_.set(i, {address});
    tables_.erase(i.result);
    if (i.operands.size() > 1) {
      std::size_t at = 0;
      const Scalars all = values_.value(i.operands[1]);
      write(address, type, all, at);
    }
  }

  llvm::Value* address_of(llvm::Value* pointer, Id type, std::uint32_t k) {
    return build_.CreateInBoundsGEP(types_.llvm_type(type), pointer,
                                    {build_.getInt32(0), build_.getInt32(k)});
  }
  void read(llvm::Value* pointer, Id type, Scalars& all) {
    const std::uint32_t count = types_.parts(type);
    if (count == 0) all.push_back(build_.CreateLoad(types_.llvm_type(type), pointer));
    for (std::uint32_t k = 0; k < count; ++k) read(address_of(pointer, type, k), types_.part(type, k), all);
  }
  void write(llvm::Value* pointer, Id type, const Scalars& all, std::size_t& at) {
    const std::uint32_t count = types_.parts(type);
    if (count == 0) {
      if (at >= all.size() || all[at]->getType() != types_.llvm_type(type))
        invalid("a value is stored as another type");
      build_.CreateStore(all[at++], pointer);
    }
    for (std::uint32_t k = 0; k < count; ++k)
      write(address_of(pointer, type, k), types_.part(type, k), all, at);
  }

  void chain(const Instruction& i) {
    llvm::Value* base = values_.one(operand(i, 0));
    Id type = pointee_of(operand(i, 0));
    std::vector<llvm::Value*> steps{build_.getInt32(0)};
    llvm::Type* whole = types_.llvm_type(type);
    for (std::size_t k = 1; k < i.operands.size(); ++k) {
      llvm::Value* step = values_.word(i.operands[k]);
      const auto* known = llvm::dyn_cast<llvm::ConstantInt>(step);
      if (types_.global(type).opcode == spv::TypeStruct && known == nullptr)
        invalid("a member by a number that is no constant");
      // LLVM wants 32-bit indices of structures.
      if (known != nullptr) step = build_.getInt32(static_cast<std::uint32_t>(known->getZExtValue()));
      steps.push_back(step);
      type = types_.part(type, known != nullptr && known->getZExtValue() < types_.parts(type)
                                   ? static_cast<std::uint32_t>(known->getZExtValue())
                                   : 0);
    }
    // An access outside is undefined; the step itself only where SPIR-V says so.
    values_.set(i, {i.opcode == spv::AccessChain ? build_.CreateGEP(whole, base, steps)
                                                 : build_.CreateInBoundsGEP(whole, base, steps)});
  }

  void call(const Instruction& i) {
    const Id id = operand(i, 0);
    llvm::Function& to = functions_.declared(id);
    Scalars given;
    for (std::size_t k = 1; k < i.operands.size(); ++k) {
      append(given, values_.value(i.operands[k]));
    }
    llvm::Value* back = nullptr;
    if (functions_.by_pointer(i.type)) {
      llvm::BasicBlock& entry = into_.getEntryBlock();
      back = llvm::IRBuilder<>(&entry, entry.begin()).CreateAlloca(types_.llvm_type(i.type));
      given.push_back(back);
    }
    bool fits = given.size() == to.arg_size();
    for (unsigned k = 0; fits && k < given.size(); ++k) fits = given[k]->getType() == to.getArg(k)->getType();
    if (!fits) invalid("a call with other arguments than its function takes");
    llvm::Value* answer = build_.CreateCall(&to, given);
    if (back != nullptr) {
      Scalars all;
      read(back, i.type, all);
      values_.set(i, std::move(all));
    } else if (!types_.is_void(i.type)) {
      values_.set(i, {answer});
    }
  }

  void phi(const Instruction& i) {
    Scalars all;
    std::vector<llvm::PHINode*> phis;
    for (llvm::Value* like : types_.filled(i.type, false)) {
      phis.push_back(build_.CreatePHI(like->getType(), static_cast<unsigned>(i.operands.size() / 2)));
      all.push_back(phis.back());
    }
    values_.set(i, std::move(all));
    phis_.emplace_back(&i, std::move(phis));
  }
  void join(const Instruction& i, const std::vector<llvm::PHINode*>& phis) {
    for (std::size_t k = 0; k + 1 < i.operands.size(); k += 2) {
      const Scalars all = values_.constant_or_value(i.operands[k]);
      if (all.size() != phis.size()) invalid("a choice of values of different types");
      for (std::size_t s = 0; s < phis.size(); ++s) {
        if (all[s]->getType() != phis[s]->getType()) invalid("a choice of values of different types");
        // SPIR-V has one entry a block, LLVM one an edge.
        llvm::BasicBlock* from = block(i.operands[k + 1]);
        for (llvm::BasicBlock* to : llvm::successors(from))
          if (to == phis[s]->getParent()) phis[s]->addIncoming(all[s], from);
      }
    }
  }

  void control(const Instruction& i) {
    switch (i.opcode) {
      case spv::Branch: build_.CreateBr(block(operand(i, 0))); return;
      case spv::BranchConditional: {
        llvm::Value* condition = values_.one(operand(i, 0));
        if (!condition->getType()->isIntegerTy(1)) invalid("a branch on no condition");
        build_.CreateCondBr(condition, block(operand(i, 1)), block(operand(i, 2)));
        return;
      }
      case spv::Switch: {
        llvm::Value* of = values_.word(operand(i, 0));
        if (of->getType()->getIntegerBitWidth() > 32) throw NotKnown("OpSwitch on more than 32 bits");
        auto* choice = build_.CreateSwitch(of, block(operand(i, 1)));
        for (std::size_t k = 2; k + 1 < i.operands.size(); k += 2)
          choice->addCase(llvm::ConstantInt::get(llvm::cast<llvm::IntegerType>(of->getType()), i.operands[k]),
                          block(i.operands[k + 1]));
        return;
      }
      case spv::Return: build_.CreateRetVoid(); return;
      case spv::ReturnValue: {
        const Scalars all = values_.value(operand(i, 0));
        if (functions_.by_pointer(from_.head.type)) {
          std::size_t at = 0;
          write(into_.getArg(static_cast<unsigned>(into_.arg_size() - 1)), from_.head.type, all, at);
          build_.CreateRetVoid();
          return;
        }
        if (all.size() != 1 || all[0]->getType() != into_.getReturnType())
          invalid("a return of another type");
        build_.CreateRet(all[0]);
        return;
      }
      default: build_.CreateUnreachable();
    }
  }

  void instruction(const Instruction& i) {
    refuse_promises_in(module_, i);
    switch (i.opcode) {
      case spv::Label: build_.SetInsertPoint(block(i.result)); return;
      case spv::LoopMerge:
      case spv::SelectionMerge:
      case spv::Line:
      case spv::NoLine:
      case 0: return;
      default: break;
    }
    if (i.result != 0 && module_.is_decorated(i.result, spv::RelaxedPrecision)) throw NotKnown(relaxed);
    if (build_.GetInsertBlock() == nullptr || build_.GetInsertBlock()->getTerminator() != nullptr)
      invalid("an instruction outside of a block");
    switch (i.opcode) {
      case spv::Variable: return variable(i);
      case spv::Load: {
        Scalars all;
        read(values_.one(operand(i, 0)), pointee_of(operand(i, 0)), all);
        return values_.set(i, std::move(all));
      }
      case spv::Store: {
        const Id pointer = operand(i, 0);
        if (tables_.count(pointer) != 0) return;
        std::size_t at = 0;
        llvm::Value* address = values_.one(pointer);
        return write(address, pointee_of(pointer), values_.value(operand(i, 1)), at);
      }
      case spv::AccessChain:
      case spv::InBoundsAccessChain: return chain(i);
      case spv::FunctionCall: return call(i);
      case spv::Phi: return phi(i);
      case spv::CopyObject: return values_.set(i, values_.value(operand(i, 0)));
      case spv::Undef: return values_.set(i, types_.filled(i.type, true));
      case spv::ExtInst: return values_.extended(i);
      case spv::Branch:
      case spv::BranchConditional:
      case spv::Switch:
      case spv::Return:
      case spv::ReturnValue:
      case spv::Unreachable: return control(i);
      default:
        if (!values_.arithmetic(i) && !values_.conversion(i) && !values_.composite(i) && !values_.of_bits(i))
          throw NotKnown(opcode_name(i.opcode));
    }
  }

  const SpirvModule& module_;
  const Types& types_;
  Functions& functions_;
  Lines& lines_;
  const SpirvFunction& from_;
  llvm::Function& into_;
  Planted planted_;
  Values values_;
  llvm::IRBuilder<>& build_;
  std::map<Id, llvm::BasicBlock*> blocks_;
  std::map<Id, Id> tables_;  ///< the constants of variables that are tables
  std::vector<std::pair<const Instruction*, std::vector<llvm::PHINode*>>> phis_;
};

/// Makes a function that takes the pointer parameters of `inner` by value.
void by_value(llvm::Function& inner, const std::string& name) {
  std::vector<llvm::Type*> takes;
  for (const llvm::Argument& a : inner.args())
    takes.push_back(a.getType()->isPointerTy() ? a.getType()->getPointerElementType() : a.getType());
  llvm::Function* f = llvm::Function::Create(llvm::FunctionType::get(inner.getReturnType(), takes, false),
                                             llvm::Function::ExternalLinkage, name, inner.getParent());
  llvm::IRBuilder<> build(llvm::BasicBlock::Create(inner.getContext(), "", f));
  Scalars given;
  for (unsigned k = 0; k < takes.size(); ++k) {
    given.push_back(f->getArg(k));
    if (!inner.getArg(k)->getType()->isPointerTy()) continue;
    given.back() = build.CreateAlloca(takes[k]);
    build.CreateStore(f->getArg(k), given.back());
  }
  llvm::Value* answer = build.CreateCall(&inner, given);
  if (answer->getType()->isVoidTy())
    build.CreateRetVoid();
  else
    build.CreateRet(answer);
}

/// Whether the function takes a level, u and v, in the order of index_function for bitcode.
bool takes_a_point(const SpirvFunction& f, const Types& types) {
  if (f.parameters.size() != 3) return false;
  const auto opcode = [&](std::size_t k) {
    const Id type = f.parameters[k].type;
    return types.global(types.is_pointer(type) ? types.pointee(type) : type).opcode;
  };
  return opcode(1) == spv::TypeFloat && ((opcode(0) == spv::TypeInt && opcode(2) == spv::TypeFloat) ||
                                         (opcode(0) == spv::TypeFloat && opcode(2) == spv::TypeInt));
}

/// The function of that name; if there are several, the one that takes a point.
Id index_function(const SpirvModule& from, const Types& types, const std::string& name) {
  std::vector<const SpirvFunction*> found, fit;
  std::string others;
  for (const SpirvFunction& f : from.functions) {
    const auto named = from.names.find(f.head.result);
    if (named == from.names.end()) continue;
    if (plain_name(named->second) != name && named->second != name) {
      others += (others.empty() ? "" : ", ") + plain_name(named->second);
      continue;
    }
    found.push_back(&f);
    if (takes_a_point(f, types)) fit.push_back(&f);
  }
  if (found.empty())
    throw CannotRead("no function is called '" + name + "'; there " +
                     (others.empty() ? "is none with a name" : "are: " + others));
  if (fit.size() > 1)
    throw CannotRead("'" + name + "' is " + from.names.at(fit[0]->head.result) + " and " +
                     from.names.at(fit[1]->head.result));
  return (fit.empty() ? found : fit).front()->head.result;
}

/// Throws NotKnown if the module declares modes that change binary32 operations.
void check_promises(const SpirvModule& module, const std::string& file) {
  for (const std::string& promise : module.foreign_promises) throw NotKnown(file + ": " + promise);
}

}  // namespace

std::unique_ptr<llvm::Module> read_spirv(const std::string& bytes, const std::string& file,
                                         const std::string& name, llvm::LLVMContext& context, Planted planted,
                                         bool shifts_wrap) {
  SpirvModule from = read_spirv_module(bytes);
  from.shifts_wrap = shifts_wrap;
  auto module = std::make_unique<llvm::Module>("spirv", context);
  module->setSourceFileName(file);
  const Types types(from, context);
  Functions functions(from, types, *module);
  Lines lines(*module, from, file);
  const Id index = index_function(from, types, name);
  by_value(functions.declared(index), name);
  check_promises(from, file);
  while (const auto id = functions.next())
    Body(from, types, functions, lines, functions.of(*id), functions.declared(*id), planted).make();
  lines.finish();
  std::string why;
  llvm::raw_string_ostream out(why);
  if (llvm::verifyModule(*module, &out)) invalid(out.str());
  return module;
}

}  // namespace mmverify::source
