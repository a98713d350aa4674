// The files of a folder that the validator judges, and the files that such a file names.
#pragma once

#include <string>
#include <vector>

namespace mmverify::scene {

/// The files below a folder, sorted by path: those that end in .glb or .gltf, sidecars that end in .json, and
/// containers under any name.  Links to folders are not followed.
/// Errors: BadScene if the folder cannot be read, or has no such file.
std::vector<std::string> micromap_files(const std::string& folder);

/// The paths of the buffers and images that a glTF file or a sidecar names; none for other files, and for what cannot be
/// read.
std::vector<std::string> files_named_by(const std::string& file);

}  // namespace mmverify::scene
