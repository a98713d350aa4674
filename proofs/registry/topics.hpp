// The table of topics.
#pragma once

#include <span>

#include "proofs/pipe/questions.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs {

/// One of a library's subjects.
struct PluginSubject {
  std::string kind;  ///< distinguishes it from the library's other subjects: FILE:KIND
  SubjectPtr subject;
};

struct Topic {
  const char* name;
  std::vector<std::string> families;  ///< the beginnings of its laws' ids, up to the dot
  std::vector<Law> (*laws)();         ///< in the order of `list` and `prove`
  std::vector<SubjectPtr> (*subjects)();
  std::vector<std::string> kinds;  ///< the kinds of a library's subjects
  /// The library's subjects of this topic; none if it has no entry point of the topic.  `first`: no subject of the
  /// library has its plain name yet.
  std::vector<PluginSubject> (*of_library)(const dock::LibraryPtr& library, bool first);
  dock::Call first_entry;  ///< the first of its entry points in the header, which orders a library's subjects
  Level highest;           ///< the highest level of any of its laws
  const char* bench = nullptr;  ///< the name of its bench in `mmverify bench` and the schemas; null: none
  const pipe::Dialogue* dialogue =
      nullptr;  ///< the dialogue of a program on a pipe; null: none, or another form
};

/// The topics in the order of `list` and `prove`.
std::span<const Topic> topics();

}  // namespace mmverify::proofs
