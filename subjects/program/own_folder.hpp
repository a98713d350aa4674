// The folder of this program's file.
#pragma once

#include <filesystem>

namespace mmverify::program {

/// The folder in which this program's file lies.
/// Errors: std::runtime_error where /proc, which names the file, is not mounted.
/// Test: tests/transcripts/prove/no_proc.txt
std::filesystem::path own_folder();

}  // namespace mmverify::program
