// The files that a repaired scene becomes.
#pragma once

#include <string>

#include "cli/output/output_file.hpp"
#include "scene/edit/edited_file.hpp"

namespace mmverify::cli {

/// The output of a repair: one GLB, or a .gltf with the files that it names.  In another folder than the input's, all of
/// them are copied; in the same folder a changed buffer gets the output's name.  The input's files are never written.
class RepairOutput {
 public:
  /// Opens the output, so that a place that cannot be written is found at once.
  /// Errors: UsageError if it is of another kind than the input; EnvironmentError.
  RepairOutput(const std::string& input, const std::string& output);

  /// Renames buffers that are to be written beside their originals.
  void rename_buffers(mmverify::scene::EditedFile& file) const;

  /// Writes everything, or nothing.  Errors: EnvironmentError; BadScene.
  void commit(const mmverify::scene::EditedFile& file, const mmverify::scene::WrittenFile& written);

 private:
  std::string input_, output_;
  bool same_folder_;
  OutputFile file_;
};

}  // namespace mmverify::cli
