// Inputs that hold up whoever reads them: so threads are in the subject at once, on a machine with any number
// of processors.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mmverify::dock {

/// Copies of a call's inputs. The first read of them waits until the gate opens. At most one gate exists.
class Gate {
 public:
  /// A copy of each input, in whole pages that it ends with. A gate that is not `closed` holds up nobody.
  /// Throws std::bad_alloc.
  Gate(const std::vector<std::span<const std::byte>>& inputs, bool closed);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  const std::byte* copy(std::size_t k) const { return copies_[k]; }
  /// The number of reads that wait.
  static unsigned waiting();
  void open();

  /// Holds up a thread that touched this address; called by the handler of faults. False if no gate is there.
  static bool holds_up(const void* at);

 private:
  std::byte* base_;
  std::size_t bytes_ = 0;
  std::vector<const std::byte*> copies_;
};

}  // namespace mmverify::dock
