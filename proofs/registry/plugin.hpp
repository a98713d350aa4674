// Somebody's shared library, as subjects of every topic that it has entry points of.
#pragma once

#include <string>
#include <vector>

#include "proofs/registry/topics.hpp"

namespace mmverify::proofs {

/// Opens the library once; what stops a run stops its workers.
/// Throws dock::CannotLoad, dock::NotHere, and std::runtime_error where no process can be had.
dock::LibraryPtr open_library(const std::string& file, dock::Options options);

/// What the file of the library that a subject is of has become since it was opened, in a sentence; empty where it is
/// the same, or where the subject is of no library.
std::string change_of(const Subject& subject);

/// The first of its subjects is named as the library, the others FILE:KIND.
std::vector<PluginSubject> plugin_subjects(const dock::LibraryPtr& library);

/// Of a library that cannot run here: a subject for each topic that these entry points are of, for no topic that of index,
/// whose laws are not_applicable for that reason.
std::vector<SubjectPtr> absent_subjects(const std::string& name, const std::vector<std::string>& entry_points,
                                        const std::string& why);

/// FILE:KIND in two; the kind is empty where the name has none.
struct PluginName {
  std::string file, kind;
};
PluginName plugin_name(const std::string& name);

}  // namespace mmverify::proofs
