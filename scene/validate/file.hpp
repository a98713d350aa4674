// What is wrong with a file of micromaps, whatever its kind.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/read/file.hpp"
#include "scene/validate/draft.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// Told by a file's bytes, never by its name.
enum class FileKind : std::uint8_t {
  sidecar,  ///< JSON with a schema "mmverify.array/...", or with records or apis and no asset: docs/VALIDATE.md
  gltf,     ///< GLB, or any other JSON
  array,    ///< "MMARRAYS": docs/ARRAYS.md, Files
  tree,     ///< "mmtr": impl/tree/container.hpp
  dag,      ///< "mmdg": docs/DAG.md, The container
  attributes,  ///< "mmat": docs/ATTRIBUTE_FORMAT.md
};

const char* name_of(FileKind kind) noexcept;

struct Judged {
  FileKind kind;
  std::vector<Draft> drafts = {};            ///< of glTF: those whose rules were asked
  std::vector<FileViolation> findings = {};  ///< each rule is a code of issues()

  std::uint64_t count(Severity severity) const;
};

/// The bytes of a file that a sidecar names, by its name there.  Errors: BadScene.
using Beside = std::function<Bytes(const std::string& name)>;

/// Every finding, in the order of the file; of one code at one place eight, then how many more there are.
///   - A pointer is one of JSON; of a container "byte N", and within an array file as in a sidecar.
///   - glTF: EXT's name is judged by the newest draft, KHR's by its own, unless `draft` says which.
///   - A container that its reader takes is one that its writer writes; of an array file's content the rules of glTF
///     are asked.
/// Domain: everything.  O(n log n) in the bytes; of a sidecar in those of its buffers too, counting indices once for
/// each geometry that names them.
/// Errors: BadScene where the file is missing, empty, too large, or of no kind that is known.
Judged validate_file(const std::string& file, std::optional<Draft> draft = {});

/// The same of bytes in memory: a glTF file has no other files beside it, a sidecar those of `beside`.
Judged validate_file(const std::string& name, std::span<const unsigned char> bytes,
                     std::optional<Draft> draft, const Beside& beside);

}  // namespace mmverify::scene
