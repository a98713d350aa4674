// Runs a function of LLVM's bitcode on all values of its choices at once. Paths that meet are merged, loops end when no
// input goes on, calls are followed, and whatever C leaves undefined is an obligation.
#pragma once

#include <llvm/IR/DataLayout.h>
#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/Operator.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "subjects/source/executor/memory.hpp"
#include "subjects/source/executor/obligations.hpp"
#include "subjects/source/executor/shape.hpp"

namespace mmverify::source::executor {

/// The attribute of the law's own functions and variables. The law's buffers of bytes may lie at any address.
inline constexpr const char* law_attribute = "mmverify-law";

/// The functions that laws call and that no codec may define.
inline constexpr std::array<const char*, 7> law_functions{"any",        "any_state",      "assume",   "check",
                                                          "stands_for", "watched_memory", "only_read"};

/// A number that the law chose: what a counterexample consists of.
struct Choice {
  Literal when;  ///< the choice is made
  Word bits;
};

/// A path, or several that met.
struct State {
  Literal when = always;  ///< the path is taken, given that its call is
  std::unordered_map<const llvm::Value*, ValuePtr> values;
  Memory memory;
  std::map<const llvm::Loop*, unsigned> turns;  ///< of the loops around the block
  ValuePtr exception;                           ///< on its way from a throw to where it lands; else null
  std::vector<ValuePtr> caught;  ///< exceptions in whose handlers the path is, the last one innermost
};

class Executor {
 public:
  Executor(llvm::Module& module, Graph& graph, circuit::Sweeper& sweeper, Obligations& obligations);

  /// Runs it, without arguments. Throws Unreadable, Refuted, Undecided.
  void run(llvm::Function& law);
  /// Called now and then; it may throw.
  void each_step(std::function<void()> call) { each_step_ = std::move(call); }

  const std::vector<Choice>& choices() const { return choices_; }

 private:
  /// A running call.
  struct Call {
    llvm::Function& function;
    const Shape& shape;
    Literal outer;  ///< the call is made
    int number;
    std::map<std::vector<unsigned>, std::pair<const llvm::BasicBlock*, State>> waiting = {};
    State returned = {};
    ValuePtr result = nullptr;
    bool has_returned = false;
    bool lost = false;                 ///< a path ended without a return
    std::optional<State> thrown = {};  ///< the paths that an exception ended
  };

  // run.cpp: calls, blocks and edges.
  /// The function's result; the state goes on after its return, or has the condition `never`.
  ValuePtr call(llvm::Function& called, const std::vector<ValuePtr>& arguments, State& state,
                const llvm::Instruction* at);
  void run_block(Call& c, const llvm::BasicBlock& block, State state);
  void end_block(Call& c, const llvm::Instruction& end, State state);
  /// Some input may take the path.
  bool possible(Literal when);
  void branch(Call& c, const llvm::BranchInst& end, State state);
  void choose_case(Call& c, const llvm::SwitchInst& end, State state);
  void come_back(Call& c, const llvm::ReturnInst& end, State state);
  void go(Call& c, const llvm::Instruction& end, const llvm::BasicBlock& to, State state);
  std::vector<unsigned> key(const Call& c, const llvm::BasicBlock* block, const State& state) const;
  void merge(State& into, State&& other);

  // values.cpp: constants and operands.
  ValuePtr value(State& s, const llvm::Value* v, const llvm::Instruction& at);
  ValuePtr constant(State& s, const llvm::Constant& c, const llvm::Instruction& at);
  ValuePtr unset_of(const llvm::Type& type, const llvm::Instruction& at) const;
  /// The number; throws Unreadable for a pointer.
  ValuePtr numeric(State& s, const llvm::Value* v, const llvm::Instruction& at);
  int object_of(const llvm::GlobalVariable& global, const llvm::Instruction& at) const;
  /// Throws Unreadable if a call of mmverify_subject_v1 leaves other variables than the first one did.
  void require_described(const State& s, const llvm::Instruction& at);
  /// Adds the global variables with their first values.
  void make_globals(State& s, const llvm::Instruction& at);
  void initialize(State& s, Object& object, std::size_t at, const llvm::Constant& c,
                  const llvm::Instruction& where);

  // instructions.cpp
  /// False if no path goes on behind the instruction.
  bool step(Call& c, State& s, const llvm::Instruction& i);
  bool step_on_numbers(State& s, const llvm::Instruction& i);
  ValuePtr binary(State& s, const llvm::BinaryOperator& i);
  ValuePtr shifted(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b);
  ValuePtr divided(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b);
  ValuePtr on_pointers(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b);
  void require_no_overflow(const llvm::BinaryOperator& i, const ValuePtr& a, const ValuePtr& b);
  ValuePtr compared(State& s, const llvm::ICmpInst& i);
  ValuePtr compared_pointers(State& s, const llvm::ICmpInst& i, const ValuePtr& a, const ValuePtr& b);
  /// The order of the addresses of two objects, as numbers: any order, the same at each comparison.
  Literal in_order(const State& s, llvm::CmpInst::Predicate p, const Target& x, const Target& y);
  ValuePtr cast(State& s, const llvm::CastInst& i);

  // accesses.cpp: pointers, loads and stores.
  ValuePtr moved(State& s, const llvm::GEPOperator& gep, const llvm::Instruction& at);
  /// The bits are all the same.
  Literal all_alike(const Word& bits) const;
  /// A number that is read as a pointer.
  ValuePtr pointer_of(const ValuePtr& v) const;
  ValuePtr moved_by(const ValuePtr& p, const Word& by) const;
  /// The address is a multiple of so many bytes, wherever the objects lie.
  void require_aligned(const State& s, const ValuePtr& p, std::uint64_t align, Literal when,
                       const llvm::Instruction& at, const char* access);
  ValuePtr load(State& s, const ValuePtr& p, std::size_t bytes, const llvm::Type& type,
                const llvm::Instruction& at);
  /// A part of a struct or an array that is read or written whole.
  struct Part {
    std::uint64_t offset;
    llvm::Type* type;
  };
  std::vector<Part> parts_of(const llvm::Type& type) const;
  ValuePtr load_parts(State& s, const ValuePtr& p, const llvm::Type& type, const llvm::Instruction& at);
  void store_typed(State& s, const ValuePtr& p, const ValuePtr& v, const llvm::Type& type,
                   const llvm::Instruction& at);
  void store(State& s, const ValuePtr& p, const ValuePtr& v, Literal when, const llvm::Instruction& at);
  /// Throws Unreadable where an entry point keeps something for its next call.
  void require_no_state(const Object& object, const llvm::Instruction& at) const;
  /// Each offset within the object with its condition; outside is an obligation.
  std::vector<std::pair<Literal, std::size_t>> offsets(const Object& object, const Word& offset,
                                                       std::size_t bytes, Literal condition,
                                                       const llvm::Instruction& at, const char* access);
  /// The object; null after an obligation that says that no input leads there.
  const Object* object_at(const State& s, const Target& t, Literal condition, const llvm::Instruction& at,
                          const char* access);
  ValuePtr load_from(const Object& object, const Target& t, std::size_t bytes, const llvm::Type& type,
                     Literal condition, const llvm::Instruction& at);

  // exceptions.cpp
  /// A function of C++ that does not promise to throw nothing.
  static bool may_throw(const llvm::Function& f);
  /// The number by which a landing pad's program tells types apart; "" is any type.
  unsigned number_of_type(const std::string& type);
  unsigned number_of_type(const llvm::Value& info, const llvm::Instruction& at);
  bool is_derived(const std::string& type, const std::string& base, const llvm::Instruction& at) const;
  /// The number of the type as which the pad catches an exception, 0 if it only cleans up; nothing if it passes.
  std::optional<unsigned> caught_as(const llvm::LandingPadInst& pad, const std::string& type);
  /// The path ends here, and goes on as thrown_.
  void throws(State& s, ValuePtr exception, const std::string& type, const llvm::Instruction& at);
  /// A thrown path goes on at the pad of the call that it came from, or leaves the function.
  void unwind(Call& c, State thrown, const llvm::Instruction& at);
  void leave(Call& c, State thrown, const llvm::Instruction& at);
  ValuePtr landed(State& s, const llvm::LandingPadInst& pad);
  /// Whether the path goes on behind a call of the runtime's for exceptions; nothing if the call is none.
  std::optional<bool> call_of_exceptions(State& s, const llvm::CallBase& i, const std::string& name);

  // library.cpp, intrinsics.cpp: functions without a body.
  bool call_instruction(State& s, const llvm::CallBase& i);
  bool call_library(State& s, const llvm::CallBase& i, const std::string& name);
  /// A call of a function that does not return is an obligation. Returns false.
  bool never_called(State& s, const std::string& symbol, const llvm::Instruction& i);
  /// The next call's own copy of the variable.
  ValuePtr copied(State& s, const ValuePtr& p, const llvm::CallBase& at, unsigned argument);
  bool call_law(State& s, const llvm::CallBase& i, const std::string& name);
  bool call_intrinsic(State& s, const llvm::CallBase& i);
  /// A variable has no value, and while it does not live, none may be read or written.
  void set_life(State& s, const ValuePtr& p, bool lives);
  ValuePtr computed(State& s, const llvm::CallBase& i);
  ValuePtr rotated(const llvm::CallBase& i, const Word& high, const Word& low, const Word& by);
  ValuePtr counted(State& s, const llvm::CallBase& i);
  ValuePtr with_overflow(State& s, const llvm::CallBase& i);
  /// The addresses of a copy or a fill have the alignment that it names, unless it moves no byte.
  void require_aligned(State& s, const llvm::MemIntrinsic& i);
  ValuePtr allocated(State& s, Word size, bool zero, const llvm::Instruction& at);
  void release(State& s, const ValuePtr& p, const llvm::Instruction& at);
  void copy(State& s, const ValuePtr& to, const ValuePtr& from, const Word& size, bool may_overlap,
            const llvm::Instruction& at);
  void copy_cells(State& s, const Target& to, const Target& from, std::size_t bytes,
                  const llvm::Instruction& at);
  void require_not_constant(const Object& object, const llvm::Instruction& at);
  /// k < size.
  Literal is_inside(std::size_t k, const Word& size);
  void fill(State& s, const ValuePtr& to, const ValuePtr& byte, const Word& size,
            const llvm::Instruction& at);
  ValuePtr compared_bytes(State& s, const ValuePtr& a, const ValuePtr& b, const Word& size,
                          const llvm::Instruction& at);
  ValuePtr length_of_text(State& s, const ValuePtr& p, const llvm::Instruction& at);
  void require_apart(const ValuePtr& to, const ValuePtr& from, const Word& size, const llvm::Instruction& at);
  std::size_t most_bytes(const State& s, const ValuePtr& p, const Word& size,
                         const llvm::Instruction& at) const;

  // contracts.cpp: memory of which few bytes are watched, and functions that others stand for.
  /// The function that runs where the codec calls this one.
  llvm::Function& stand_in(llvm::Function& function, const llvm::Instruction* at) const;
  void put_in_place(State& s, const llvm::CallBase& i);
  ValuePtr watched_memory(State& s, const llvm::CallBase& i);
  void make_constant(State& s, const llvm::CallBase& i);
  /// The bytes are within the object.
  void require_within(const Object& object, const Word& offset, std::size_t bytes, Literal condition,
                      const llvm::Instruction& at, const char* access);
  ValuePtr load_watched(const Object& object, const Word& offset, std::size_t bytes);
  void store_watched(Object& object, const Word& offset, const ValuePtr& value, Literal when);
  /// Sets bytes of watched memory; false if the pointer leads to other memory.
  bool fill_watched(State& s, const ValuePtr& to, const ValuePtr& byte, const Word& size,
                    const llvm::Instruction& at);
  /// Copies bytes to or from watched memory; false if both pointers lead to other memory.
  bool copy_watched(State& s, const ValuePtr& to, const ValuePtr& from, const Word& size,
                    const llvm::Instruction& at);
  /// The watched memory that a pointer leads to; null if it leads elsewhere.
  const Object* watched_at(const State& s, const ValuePtr& p) const;
  /// So many bytes from the pointer on are within its object.
  void require_room(const State& s, const ValuePtr& p, const Word& size, const llvm::Instruction& at,
                    const char* what);
  /// from <= place < from + size.
  Literal is_inside(const Word& place, const Word& from, const Word& size);

  /// The path is taken, all calls around it included.
  Literal condition(const State& s) const;
  void require_never(Duty duty, Literal broken, const llvm::Instruction& at, const std::string& what);
  /// No bit of the number may be unset.
  void require_set(const ValuePtr& v, const llvm::Instruction& at, const std::string& what);

  llvm::Module& module_;
  const llvm::DataLayout& layout_;
  Graph& graph_;
  circuit::Sweeper& sweeper_;
  Obligations& obligations_;
  std::map<const llvm::Function*, std::unique_ptr<Shape>> shapes_;
  std::map<const llvm::GlobalVariable*, int> globals_;
  std::map<int, llvm::Function*> functions_;
  std::map<const llvm::Function*, int> function_numbers_;
  std::map<const llvm::Function*, llvm::Function*> stand_ins_;
  /// An exception's type, and the place where it is thrown.
  struct Thrown {
    std::string name, thrown_at;
  };
  std::map<int, Thrown> thrown_types_;  ///< by the exception's object
  std::map<std::string, unsigned> type_numbers_;
  std::optional<State> thrown_;  ///< the path on which the last instruction threw
  std::map<std::pair<int, int>, Literal>
      orders_;  ///< the first object, of the lesser number, lies below the second
  std::vector<Choice> choices_;
  std::function<void()> each_step_;
  Literal outer_ = always;    ///< the calls around are made
  Literal running_ = always;  ///< the condition of the step that runs
  int objects_ = 0, calls_ = 0, depth_ = 0;
  bool describes_ = false;           ///< the law runs mmverify_subject_v1, which may fill the entry points in
  std::map<int, Object> described_;  ///< the variables after that
};

}  // namespace mmverify::source::executor
