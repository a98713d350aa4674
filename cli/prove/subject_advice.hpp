// Advice on a name that is no subject: a source, an object file, a library without its entry point.
#pragma once

#include <string>

namespace mmverify::cli {

/// Whether the name ends as a shared library's or a shader's file does.
bool is_library_or_shader(const std::string& name);

/// The file's name with ./ before it if it has no folder.
std::string as_path(const std::string& name);

/// The way to make a subject of a source, an object file or an archive, as a sentence; empty for other names.
std::string way_to_build(const std::string& name);

/// "; did you mean --subject ./mine.so?" about a law's name that is a file's; empty for other names.
std::string meant_as_subject(const std::string& name);

/// The likely mistake behind a library that cannot be loaded: a C++ name, a hidden function, another version, or
/// a symbol that is defined nowhere. why: the error. Empty if it is none of these.
std::string advice_on_library(const std::string& file, const std::string& why);

}  // namespace mmverify::cli
