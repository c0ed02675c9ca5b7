#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace washtub {

/// Zeroed memory for one array of grid values, aligned for vector loads. Large arrays sit in huge
/// pages, and starts are staggered by cache lines so that arrays do not compete for the same sets.
template <class T>
class Storage {
 public:
  Storage() = default;
  explicit Storage(std::size_t count) : count_(count) {
    static std::size_t turn = 0;
    const std::size_t stagger = 64 * (1 + turn++ % 16);
    std::size_t bytes = count * sizeof(T) + stagger;
    const std::size_t page = bytes > huge ? huge : 64;
    bytes = (bytes + page - 1) / page * page;
    memory_.reset(static_cast<std::byte*>(std::aligned_alloc(page, bytes)));
    if (!memory_) throw std::bad_alloc();
    if (page == huge) madvise(memory_.get(), bytes, MADV_HUGEPAGE);
    std::memset(memory_.get(), 0, bytes);
    data_ = reinterpret_cast<T*>(memory_.get() + stagger);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return count_; }
  T& operator[](long i) { return data_[i]; }
  const T& operator[](long i) const { return data_[i]; }
  void fill(T value) {
    for (std::size_t i = 0; i < count_; ++i) data_[i] = value;
  }
  void swap(Storage& other) noexcept {
    memory_.swap(other.memory_);
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
  }

 private:
  static constexpr std::size_t huge = std::size_t{2} << 20;
  struct Free {
    void operator()(std::byte* p) const { std::free(p); }
  };
  std::unique_ptr<std::byte[], Free> memory_;
  T* data_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace washtub
