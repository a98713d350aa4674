#include "subjects/source/circuit/solver.hpp"

#include <array>
#include <cadical.hpp>

namespace mmverify::source::circuit {

class Solver::Clock : public CaDiCaL::Terminator {
 public:
  bool terminate() override {
    if (each_moment) each_moment();
    return passed();
  }
  bool passed() const { return std::chrono::steady_clock::now() >= deadline; }
  std::function<void()> each_moment;
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

Solver::Solver(const Graph& graph)
    : graph_(graph), solver_(std::make_unique<CaDiCaL::Solver>()), clock_(std::make_unique<Clock>()) {
  // Thousands of small questions: work before a search costs more than the search.
  for (const char* name : {"lucky", "walk"}) solver_->set(name, 0);
  solver_->set("quiet", 1);
  solver_->connect_terminator(clock_.get());
}

Solver::~Solver() { solver_->disconnect_terminator(); }

void Solver::stop_at(std::chrono::steady_clock::time_point deadline) { clock_->deadline = deadline; }

void Solver::each_moment(std::function<void()> call) { clock_->each_moment = std::move(call); }

void Solver::clause(std::initializer_list<int> numbers) {
  for (const int n : numbers) solver_->add(n);
  solver_->add(0);
}

void Solver::write_certificate(std::FILE* file) {
  certificate_ = file;
  solver_->set("binary", 0);
  // An eliminated variable's clauses would come back without a line in the certificate. The search takes twice as long.
  for (const char* name : {"elim", "decompose"}) solver_->set(name, 0);
  // The solver writes its own steps, clauses that it derives or deletes, into the same file.
  solver_->trace_proof(file, "certificate");
}

void Solver::write(char kind, std::span<const int> numbers) {
  if (certificate_ == nullptr) return;
  std::fputc(kind, certificate_);
  for (const int n : numbers) std::fprintf(certificate_, " %d", n);
  std::fputs(" 0\n", certificate_);
}

void Solver::define(Node n) {
  const int v = variable_[n] = ++variables_;
  if (n == 0) {
    write('f', std::array{v});
    return clause({-v});
  }
  if (!graph_.is_conjunction(n)) return write('i', std::array{v});
  const int a = number(graph_.first(n)), b = number(graph_.second(n));
  write('n', std::array{v, a, b});
  clause({-v, a});
  clause({-v, b});
  clause({v, -a, -b});
}

int Solver::variable(Node n) {
  if (variable_.size() < graph_.size()) variable_.resize(graph_.size(), 0);
  if (variable_[n] != 0) return variable_[n];
  std::vector<Node> open{n};
  while (!open.empty()) {
    const Node top = open.back();
    bool ready = true;
    if (variable_[top] == 0 && graph_.is_conjunction(top))
      for (const Literal l : {graph_.first(top), graph_.second(top)})
        if (variable_[node_of(l)] == 0) {
          open.push_back(node_of(l));
          ready = false;
        }
    if (!ready) continue;
    open.pop_back();
    if (variable_[top] == 0) define(top);
  }
  return variable_[n];
}

int Solver::number(Literal l) {
  const int v = variable(node_of(l));
  return is_negated(l) ? -v : v;
}

Answer Solver::ask(std::initializer_list<Literal> all, int conflicts) {
  if (clock_->passed()) return Answer::unknown;
  ++questions_;
  for (const Literal l : all) {
    if (l == never) return Answer::impossible;
    (void)number(l);
  }
  if (conflicts != all_conflicts) solver_->limit("conflicts", conflicts);
  for (const Literal l : all)
    if (l != always) solver_->assume(number(l));
  const int got = solver_->solve();
  return got == 10 ? Answer::possible : got == 20 ? Answer::impossible : Answer::unknown;
}

void Solver::learn(std::initializer_list<Literal> some) {
  std::vector<int> numbers;
  for (const Literal l : some) numbers.push_back(number(l));
  write('m', numbers);
  for (const int n : numbers) solver_->add(n);
  solver_->add(0);
}

void Solver::assume(Literal holds) {
  const int n = number(holds);
  write('a', std::array{n});
  clause({n});
}

void Solver::claim_never(Literal a, Literal b) {
  if (a == never || b == never || a == negated(b)) return;
  const int x = number(a), y = number(b);
  write('o', std::array{-x, -y});
}

bool Solver::value(Node input) const { return needed(input) && solver_->val(variable_[input]) > 0; }

}  // namespace mmverify::source::circuit
