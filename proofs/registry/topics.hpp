// The topics: one table.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dock/library.hpp"
#include "proofs/engine/law.hpp"
#include "proofs/pipe/questions.hpp"

namespace mmverify::proofs {

/// One of a library's subjects.
struct PluginSubject {
  std::string kind;  ///< what tells it from the library's others: FILE:KIND
  SubjectPtr subject;
};

struct Topic {
  const char* name;
  std::vector<std::string> families;  ///< what its laws' ids begin with, up to the dot
  std::vector<Law> (*laws)();         ///< in the order in which `list` and `prove` have them
  std::vector<SubjectPtr> (*subjects)();
  std::vector<std::string> kinds;  ///< of a library's subjects
  /// The library's subjects of this topic; none where it has no entry point of it.  `first`: no subject of
  /// the library has its plain name yet.
  std::vector<PluginSubject> (*of_library)(const dock::LibraryPtr& library, bool first);
  dock::Call first_entry;  ///< of its entry points in the header: a library's subjects come in that order
  Level highest;           ///< that any of its laws is defined at
  const char* bench = nullptr;  ///< its bench, as `mmverify bench` and the schemas name it; null: none
  const pipe::Dialogue* dialogue = nullptr;  ///< of a program on a pipe; null: none, or one of its own
};

/// In the order in which `list` and `prove` have them.
std::span<const Topic> topics();

}  // namespace mmverify::proofs
