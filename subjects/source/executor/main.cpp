// mmverify-codec: decides a law on a codec in LLVM's bitcode for all values of the law's choices at once. It is a
// process of its own: no other one contains LLVM or the SAT solver.
//
//   mmverify-codec CODEC.bc LAW.bc FUNCTION [--budget SECONDS] [--certificate FILE] [--merge CONFLICTS] [--plain]
//                  [--statistics]
//   mmverify-codec --odd LAW.bc OUT.bc     writes the law with its buffers of bytes at odd addresses
//
// The answer is a line on standard output, after lines of progress:
//   progress LEMMAS OPEN SECONDS   merges proved, and obligations that are open
//   proved NODES LEMMAS OBLIGATIONS
//   refuted FILE:LINE: TEXT        then a line `choice BITS NUMBER` for each choice, in the order of the calls
//   unknown TEXT
// Exit codes: 0 an answer; 2 a bad file; 3 code that cannot be followed; 4 any other error.
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Support/SourceMgr.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

#include "subjects/source/executor/executor.hpp"
#include "subjects/source/executor/odd.hpp"

namespace {

using namespace mmverify::source;
using executor::Refuted;
using Clock = std::chrono::steady_clock;

struct BadFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::string codec, law, function, certificate;
  double budget = 0;
  int merge_conflicts = 200;
  std::string planted = "none";
  bool merging = true, statistics = false;
};

Options options_of(int count, char** words) {
  Options o;
  std::vector<std::string> plain;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--statistics") {
      o.statistics = true;
    } else if (word == "--plain") {
      o.merging = false;
    } else if (word.starts_with("--")) {
      if (k + 1 == count) throw BadFile(word + " takes a value");
      if (word == "--certificate" || word == "--plant") {
        (word == "--plant" ? o.planted : o.certificate) = words[++k];
        continue;
      }
      const double value = std::strtod(words[++k], nullptr);
      if (word == "--budget")
        o.budget = value;
      else if (word == "--merge")
        o.merge_conflicts = static_cast<int>(value);
      else
        throw BadFile("no option is called " + word);
    } else {
      plain.push_back(word);
    }
  }
  if (plain.size() != 3)
    throw BadFile(
        "usage: mmverify-codec CODEC.bc LAW.bc FUNCTION [--budget SECONDS] [--merge CONFLICTS] "
        "[--statistics]");
  o.codec = plain[0], o.law = plain[1], o.function = plain[2];
  return o;
}

std::unique_ptr<llvm::Module> read(const std::string& file, llvm::LLVMContext& context) {
  llvm::SMDiagnostic wrong;
  std::unique_ptr<llvm::Module> module = llvm::parseIRFile(file, wrong, context);
  if (module == nullptr) throw BadFile(file + ": " + wrong.getMessage().str());
  return module;
}

void say_choices(const std::vector<executor::Choice>& choices, const circuit::Graph& graph,
                 const circuit::Inputs& inputs) {
  // The value of each node, from the inputs up.
  std::vector<bool> values(graph.size(), false);
  std::size_t input = 0;
  const auto value = [&](circuit::Literal l) {
    return values[circuit::node_of(l)] != circuit::is_negated(l);
  };
  for (circuit::Node n = 1; n < graph.size(); ++n) {
    if (graph.is_input(n)) {
      values[n] = input < inputs.size() && inputs[input];
      ++input;
    } else {
      values[n] = value(graph.first(n)) && value(graph.second(n));
    }
  }
  for (const executor::Choice& choice : choices) {
    if (!value(choice.when)) continue;
    unsigned long long number = 0;
    for (std::size_t k = 0; k < choice.bits.size(); ++k)
      if (value(choice.bits[k])) number |= 1ULL << k;
    std::printf("choice %zu %llu\n", choice.bits.size(), number);
  }
}

/// The law and the codec as one module.
std::unique_ptr<llvm::Module> linked(const Options& o, llvm::LLVMContext& context) {
  std::unique_ptr<llvm::Module> module = read(o.law, context);
  for (llvm::Function& f : *module)
    if (!f.isDeclaration()) f.addFnAttr(executor::law_attribute);
  for (llvm::GlobalVariable& g : module->globals()) g.addAttribute(executor::law_attribute);
  std::unique_ptr<llvm::Module> codec = read(o.codec, context);
  for (const char* name : executor::law_functions)
    if (const llvm::Function* f = codec->getFunction(name); f != nullptr && !f->hasLocalLinkage())
      throw BadFile(o.codec + ": it " + (f->isDeclaration() ? "uses " : "defines ") + name +
                    ", which is a function of the laws; " +
                    (f->isDeclaration() ? "a codec may not" : "make it static"));
  // A law that sees the codec's headers has inline functions of it; the codec's own are judged.
  for (llvm::Function& f : *module)
    if (const llvm::Function* own = codec->getFunction(f.getName());
        own != nullptr && !own->isDeclaration() && f.hasLinkOnceLinkage())
      f.deleteBody();
  // Bitcode that is given as such may say of itself what it likes.
  for (llvm::Function& f : *codec) f.removeFnAttr(executor::law_attribute);
  for (llvm::GlobalVariable& g : codec->globals()) g.setAttributes({});
  if (llvm::Linker::linkModules(*module, std::move(codec)))
    throw BadFile(o.codec + ": it does not link with " + o.law);
  return module;
}

/// A run with its clock.
class Run {
 public:
  Run(const Options& o, llvm::Module& module)
      : options_(o),
        solver_(graph_),
        sweeper_(graph_, solver_, o.merge_conflicts, o.merging),
        obligations_(sweeper_),
        executor_(module, graph_, sweeper_, obligations_) {
    if (o.budget > 0)
      solver_.stop_at(start_ +
                      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(o.budget)));
    if (!o.certificate.empty()) {
      certificate_.reset(std::fopen(o.certificate.c_str(), "w"));
      if (certificate_ == nullptr) throw BadFile(o.certificate + ": it cannot be written");
      solver_.write_certificate(certificate_.get());
    }
    executor_.each_step([this] { tick(); });
    solver_.each_moment([this] { tell_progress(); });
  }

  /// Makes a deliberate mistake: a kind of obligations is dropped, an instruction has another meaning, or merges are
  /// not proved.
  void plant(const std::string& name) {
    const auto duty = std::find(executor::duties.begin(), executor::duties.end(), name);
    const auto mistake = std::find(executor::mistakes.begin(), executor::mistakes.end(), name);
    if (duty != executor::duties.end())
      obligations_.drop(static_cast<executor::Duty>(duty - executor::duties.begin()));
    else if (mistake != executor::mistakes.end())
      executor::planted = static_cast<executor::Mistake>(mistake - executor::mistakes.begin());
    else if (name == "unproved-merges")
      sweeper_.believe_simulation();
    else
      throw BadFile("no mistake is called " + name);
  }

  /// Prints the answer.
  void decide(llvm::Function& law) {
    try {
      executor_.run(law);
      obligations_.settle();
      std::printf("proved %u %llu %llu\n", graph_.size(), count(sweeper_.statistics().merged),
                  count(obligations_.made()));
    } catch (const Refuted& why) {
      std::printf("refuted %s\n", why.what());
      say_choices(executor_.choices(), graph_, why.inputs);
    } catch (const executor::Undecided& why) {
      std::printf("unknown %s\n", why.what());
    }
    if (options_.statistics) tell_statistics();
  }

 private:
  static unsigned long long count(std::uint64_t n) { return n; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  void tick() {
    tell_progress();
    if (options_.budget > 0 && seconds() > options_.budget) throw executor::Undecided("the budget is spent");
  }

  void tell_progress() {
    const Clock::time_point now = Clock::now();
    if (now - told_ < std::chrono::seconds(1)) return;
    told_ = now;
    std::printf("progress %llu %zu %.0f\n", count(sweeper_.statistics().merged), obligations_.open(),
                seconds());
    std::fflush(stdout);
  }

  void tell_statistics() const {
    const circuit::SweepStatistics& t = sweeper_.statistics();
    std::fprintf(stderr, "%.2f s, %u nodes, %zu inputs; merges: %llu, different %llu, undecided %llu; ",
                 seconds(), graph_.size(), graph_.inputs().size(), count(t.merged), count(t.different),
                 count(t.undecided));
    std::fprintf(stderr, "edges and obligations: impossible %llu, possible %llu, open %llu; %llu questions\n",
                 count(t.impossible), count(t.possible), count(t.open), count(solver_.questions()));
  }

  const Options& options_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point told_ = start_;
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> certificate_;
  circuit::Graph graph_;
  circuit::Solver solver_;
  circuit::Sweeper sweeper_;
  executor::Obligations obligations_;
  executor::Executor executor_;
};

int decide(const Options& o) {
  llvm::LLVMContext context;
  const std::unique_ptr<llvm::Module> module = linked(o, context);
  llvm::Function* law = module->getFunction(o.function);
  if (law == nullptr || law->isDeclaration()) throw BadFile(o.law + ": no function is called " + o.function);
  Run run(o, *module);
  run.plant(o.planted);
  run.decide(*law);
  return 0;
}

int write_odd(const std::string& from, const std::string& to) {
  llvm::LLVMContext context;
  const std::unique_ptr<llvm::Module> module = read(from, context);
  executor::move_to_odd_addresses(*module);
  std::error_code error;
  llvm::raw_fd_ostream out(to, error);
  if (error) throw BadFile(to + ": " + error.message());
  llvm::WriteBitcodeToFile(*module, out);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 4 && std::strcmp(words[1], "--odd") == 0) return write_odd(words[2], words[3]);
    return decide(options_of(count, words));
  } catch (const BadFile& why) {
    std::fprintf(stderr, "%s\n", why.what());
    return 2;
  } catch (const executor::Unreadable& why) {
    std::fprintf(stderr, "%s\n", why.what());
    return 3;
  } catch (const std::exception& why) {
    std::fprintf(stderr, "%s\n", why.what());
    return 4;
  }
}
