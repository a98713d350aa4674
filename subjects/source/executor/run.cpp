// Calls, blocks and edges: each block runs once for each turn of the loops around it.
#include <llvm/IR/CFG.h>
#include <llvm/IR/IntrinsicInst.h>

#include "subjects/source/executor/executor.hpp"

namespace mmverify::source::executor {
namespace {

constexpr int deepest = 400;
constexpr unsigned most_turns = 1 << 20;
/// The condition for the values of a path that joins others.
Literal side(Literal when) { return planted == Mistake::other_side ? negated(when) : when; }

/// Conflicts for the question whether any input takes an edge.
constexpr int edge_effort = 1000;

}  // namespace

Executor::Executor(llvm::Module& module, Graph& graph, circuit::Sweeper& sweeper, Obligations& obligations)
    : module_(module),
      layout_(module.getDataLayout()),
      graph_(graph),
      sweeper_(sweeper),
      obligations_(obligations) {}

void Executor::run(llvm::Function& law) {
  State state;
  make_globals(state, law.getEntryBlock().front());
  if (module_.getGlobalVariable("llvm.global_ctors") != nullptr)
    throw Unreadable(law.getEntryBlock().front(), "variables that code sets before the program starts");
  call(law, {}, state, nullptr);
}

Literal Executor::condition(const State& s) const { return graph_.both(outer_, s.when); }

void Executor::require_never(Duty duty, Literal broken, const llvm::Instruction& at,
                             const std::string& what) {
  obligations_.require_never(duty, running_, broken, at, what);
}

void Executor::require_set(const ValuePtr& v, const llvm::Instruction& at, const std::string& what) {
  if (v->kind == Value::Kind::number && !v->unset.empty())
    require_never(Duty::unset, graph_.any_of(v->unset), at, what);
}

std::vector<unsigned> Executor::key(const Call& c, const llvm::BasicBlock* block, const State& state) const {
  std::vector<const llvm::Loop*> around;
  for (const llvm::Loop* l = c.shape.loop_of(block); l != nullptr; l = l->getParentLoop())
    around.push_back(l);
  std::vector<unsigned> key;
  for (auto l = around.rbegin(); l != around.rend(); ++l) {
    key.push_back(c.shape.order((*l)->getHeader()));
    key.push_back(state.turns.at(*l));
  }
  key.push_back(c.shape.order(block));
  return key;
}

ValuePtr Executor::call(llvm::Function& called, const std::vector<ValuePtr>& arguments, State& state,
                        const llvm::Instruction* at) {
  llvm::Function& function = stand_in(called, at);
  if (depth_ >= deepest) throw Unreadable(*at, "calls more than " + std::to_string(deepest) + " deep");
  std::unique_ptr<Shape>& shape = shapes_[&function];
  if (shape == nullptr) shape = std::make_unique<Shape>(function);
  const Literal outer = outer_;
  const bool described = describes_;
  // An entry point that calls it may not change it.
  const bool describes = at != nullptr && at->getFunction()->hasFnAttribute(law_attribute) &&
                         function.getName() == "mmverify_subject_v1";
  describes_ = described || describes;
  Call c{function, *shape, condition(state), ++calls_};
  State first;
  first.memory = std::move(state.memory);
  first.caught = state.caught;
  for (unsigned k = 0; k < arguments.size() && k < function.arg_size(); ++k)
    first.values[function.getArg(k)] = arguments[k];
  c.waiting.emplace(std::vector{0U}, std::pair{&function.getEntryBlock(), std::move(first)});
  outer_ = c.outer;
  ++depth_;
  while (!c.waiting.empty()) {
    auto next = c.waiting.extract(c.waiting.begin());
    run_block(c, *next.mapped().first, std::move(next.mapped().second));
  }
  --depth_;
  outer_ = outer;
  describes_ = described;
  if (c.thrown) {
    thrown_ = std::move(c.thrown);
    thrown_->values = state.values;
    thrown_->turns = state.turns;
    thrown_->when = graph_.both(state.when, thrown_->when);
  }
  if (!c.has_returned) {
    state.when = never;
    return nullptr;
  }
  state.memory = std::move(c.returned.memory);
  state.caught = std::move(c.returned.caught);
  state.memory.drop(c.number);
  if (c.lost) state.when = graph_.both(state.when, c.returned.when);
  if (describes) require_described(state, *at);
  return c.result;
}

void Executor::run_block(Call& c, const llvm::BasicBlock& block, State state) {
  for (const llvm::Instruction& i : block) {
    if (llvm::isa<llvm::PHINode>(i) || llvm::isa<llvm::DbgInfoIntrinsic>(i)) continue;
    running_ = condition(state);
    if (each_step_) each_step_();
    if (i.isTerminator() && !llvm::isa<llvm::InvokeInst>(i)) return end_block(c, i, std::move(state));
    const bool goes_on = step(c, state, i);
    if (thrown_) unwind(c, *std::exchange(thrown_, std::nullopt), i);
    if (!goes_on) {
      c.lost = true;
      return;
    }
    if (const auto* invoke = llvm::dyn_cast<llvm::InvokeInst>(&i))
      return go(c, i, *invoke->getNormalDest(), std::move(state));
  }
}

void Executor::end_block(Call& c, const llvm::Instruction& end, State state) {
  if (const auto* i = llvm::dyn_cast<llvm::ReturnInst>(&end)) return come_back(c, *i, std::move(state));
  if (const auto* i = llvm::dyn_cast<llvm::BranchInst>(&end)) return branch(c, *i, std::move(state));
  if (const auto* i = llvm::dyn_cast<llvm::SwitchInst>(&end)) return choose_case(c, *i, std::move(state));
  if (const auto* i = llvm::dyn_cast<llvm::ResumeInst>(&end)) {
    state.exception = value(state, i->getValue(), end)->parts[0];
    return leave(c, std::move(state), end);
  }
  if (!llvm::isa<llvm::UnreachableInst>(end))
    throw Unreadable(end, std::string("the end of a block is ") + end.getOpcodeName());
  require_never(Duty::ends, always, end, "code that is never reached is reached");
  c.lost = true;
}

void Executor::branch(Call& c, const llvm::BranchInst& end, State state) {
  if (end.isUnconditional()) return go(c, end, *end.getSuccessor(0), std::move(state));
  const ValuePtr decides = numeric(state, end.getCondition(), end);
  require_set(decides, end, "a branch on a value that was never set");
  const Literal yes = planted == Mistake::other_branch ? negated(decides->bits[0]) : decides->bits[0];
  if (yes <= always) return go(c, end, *end.getSuccessor(yes == always ? 0 : 1), std::move(state));
  const Literal taken = graph_.both(state.when, yes), passed = graph_.both(state.when, negated(yes));
  // A branch that every input takes leaves the path's condition as it is.
  if (!possible(taken)) return go(c, end, *end.getSuccessor(1), std::move(state));
  if (!possible(passed)) return go(c, end, *end.getSuccessor(0), std::move(state));
  State other = state;
  other.when = taken;
  state.when = passed;
  go(c, end, *end.getSuccessor(0), std::move(other));
  go(c, end, *end.getSuccessor(1), std::move(state));
}

bool Executor::possible(Literal when) {
  return when != never && sweeper_.both_possible(outer_, when, edge_effort) != circuit::Answer::impossible;
}

void Executor::choose_case(Call& c, const llvm::SwitchInst& end, State state) {
  const ValuePtr decides = numeric(state, end.getCondition(), end);
  require_set(decides, end, "a switch on a value that was never set");
  for (const auto& one : end.cases()) {
    const Literal here = circuit::equal(
        graph_, decides->bits, circuit::constant(one.getCaseValue()->getZExtValue(), decides->bits.size()));
    State other = state;
    other.when = graph_.both(state.when, here);
    state.when = graph_.both(state.when, negated(here));
    if (possible(other.when)) go(c, end, *one.getCaseSuccessor(), std::move(other));
  }
  if (possible(state.when)) go(c, end, *end.getDefaultDest(), std::move(state));
}

void Executor::come_back(Call& c, const llvm::ReturnInst& end, State state) {
  ValuePtr result = end.getReturnValue() == nullptr ? nullptr : value(state, end.getReturnValue(), end);
  state.values.clear();
  state.turns.clear();
  // A call's variables end with it; what is left of them need not be merged.
  state.memory.drop(c.number);
  if (!c.has_returned) {
    c.has_returned = true;
    c.result = std::move(result);
    c.returned = std::move(state);
    return;
  }
  if (result != nullptr) c.result = chosen(graph_, state.when, result, c.result);
  merge(c.returned, std::move(state));
}

void Executor::merge(State& into, State&& other) {
  for (auto& [name, v] : other.values) {
    const auto [at, fresh] = into.values.emplace(name, v);
    if (!fresh) at->second = chosen(graph_, side(other.when), v, at->second);
  }
  into.memory.choose(graph_, side(other.when), other.memory);
  if (into.caught.size() != other.caught.size())
    throw Undecided("paths meet inside and outside of a handler of exceptions");
  for (std::size_t k = 0; k < into.caught.size(); ++k)
    into.caught[k] = chosen(graph_, side(other.when), other.caught[k], into.caught[k]);
  if (into.exception != nullptr)
    into.exception = chosen(graph_, side(other.when), other.exception, into.exception);
  into.when = graph_.either(into.when, other.when);
}

void Executor::go(Call& c, const llvm::Instruction& end, const llvm::BasicBlock& to, State state) {
  const llvm::BasicBlock* from = end.getParent();
  std::vector<std::pair<const llvm::Value*, ValuePtr>> phis;
  for (const llvm::PHINode& phi : to.phis())
    phis.emplace_back(&phi, value(state, phi.getIncomingValueForBlock(from), end));
  for (auto& [phi, v] : phis) state.values[phi] = std::move(v);
  std::erase_if(state.values, [&](const auto& entry) { return !c.shape.is_live(&to, entry.first); });
  std::map<const llvm::Loop*, unsigned> turns;
  for (const llvm::Loop* l = c.shape.loop_of(&to); l != nullptr; l = l->getParentLoop()) {
    const auto at = state.turns.find(l);
    turns[l] = at == state.turns.end() ? 0 : at->second;
  }
  const llvm::Loop* loop = c.shape.loop_of(&to);
  if (loop != nullptr && loop->getHeader() == &to && loop->contains(from)) {
    if (++turns[loop] > most_turns)
      throw Undecided(place_of(end) + ": a loop of more than " + std::to_string(most_turns) + " turns");
  } else if (c.shape.order(&to) <= c.shape.order(from)) {
    throw Unreadable(end, "a jump into a loop");
  }
  state.turns = std::move(turns);
  std::vector<unsigned> place = key(c, &to, state);
  const auto at = c.waiting.find(place);
  if (at == c.waiting.end())
    c.waiting.emplace(std::move(place), std::pair{&to, std::move(state)});
  else
    merge(at->second.second, std::move(state));
}

}  // namespace mmverify::source::executor
