#pragma once
#include <string>

namespace washtub {

/// Keeps every other run out of a directory of results for as long as it lives, or a child process
/// that has inherited it. The kernel holds it, so nothing has to be cleared after a crash.
class DirectoryLock {
 public:
  static constexpr const char* name = "run.lock";  ///< of its file in the directory

  DirectoryLock() = default;  ///< locks nothing
  /// @throws InputError that names the process that holds the directory
  explicit DirectoryLock(const std::string& directory);
  ~DirectoryLock();
  DirectoryLock(DirectoryLock&& other) noexcept;
  DirectoryLock& operator=(DirectoryLock&& other) noexcept;

  /// What there is to say where the directory's file system knows no locks; else "".
  const std::string& note() const { return note_; }

 private:
  bool try_lock();
  void sign() const;

  std::string path_, note_;
  int file_ = -1;
};

}  // namespace washtub
