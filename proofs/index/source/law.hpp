// index.floats of a function in somebody's source.
#pragma once

#include "proofs/index/source/statements.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index::source {

/// A function in a source: compiled, to be run, and as formulas, to be proved.
class SourceSubject : public IndexSubject {
 public:
  struct Code {
    Formulas formulas;
    /// Why there are none at a level: an instruction that is not known, with its file and line.
    std::function<std::optional<std::string>(Level)> not_known;
    /// Exponent fields of constants in the code: what it does there and nowhere else is found soonest.
    std::function<std::vector<unsigned>(Level)> fields;
    std::string read_as;  ///< what the formulas were made of, for messages
  };
  SourceSubject(std::string name, std::string about, Functions functions, std::string fingerprint, Code code);
  const Code code;
};

/// For every pair of binary32 numbers of the domain, level by level.  `replayed_by`: as of a Law.
Law law(Dialect dialect, std::string replayed_by = {});

/// The compiled function on one pair, "u=0x1.8p-2,v=-0x0p+0", beside the dialect's index.  Throws BadCase.
Replayed replay(const IndexSubject& subject, Dialect dialect, Level n, const std::string& at);

}  // namespace mmverify::proofs::index::source
