// A shared library of a stranger, as subjects of every topic that it has entry points of.
#pragma once

#include "proofs/registry/topics.hpp"

namespace mmverify::proofs {

/// Opens the library once; an interrupt of the run stops its workers. Throws dock::CannotLoad, dock::NotHere, and
/// std::runtime_error if no process can be started.
dock::LibraryPtr open_library(const std::string& file, dock::Options options);

/// The change of a subject's library file since it was opened, as a sentence; empty if it is the same, or if the
/// subject has no library.
std::string change_of(const Subject& subject);

/// The subjects of a library; the first has the library's name, the others FILE:KIND.
std::vector<PluginSubject> plugin_subjects(const dock::LibraryPtr& library);

/// The subjects of a library that cannot run here: one for each topic of these entry points, or one of topic index if
/// there is none.  Their laws are not_applicable because of `why`.
std::vector<SubjectPtr> absent_subjects(const std::string& name, const std::vector<std::string>& entry_points,
                                        const std::string& why);

/// FILE:KIND, split; the kind is empty if the name has none.
struct PluginName {
  std::string file, kind;
};
PluginName plugin_name(const std::string& name);

}  // namespace mmverify::proofs
