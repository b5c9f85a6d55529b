#pragma once
/// Memory for large arrays that are read at random: on large pages, so that finding a page seldom costs a walk.

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sightline {

/// Aligned to a cache line; from one large page on, to large pages, which Linux is asked for. Elsewhere, or where it
/// refuses, all works the same on small ones.
template <class T>
struct LargePageAllocator {
  using value_type = T;

  static constexpr std::size_t cache_line = 64;
  static constexpr std::size_t large_page = std::size_t{1} << 21;

  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    void* memory = ::operator new(bytes, alignment(bytes));
#ifdef __linux__
    if (bytes >= large_page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count * sizeof(T))); }

  friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t(bytes >= large_page ? large_page : cache_line);
  }
};

template <class T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

/// An array of a fixed size whose elements are left as they are found, so that whoever writes them first, in parallel,
/// makes the pages.
template <class T>
class LargeBuffer {
  static_assert(std::is_trivially_copyable_v<T> && (std::is_aggregate_v<T> || std::is_arithmetic_v<T>));

 public:
  LargeBuffer() = default;
  explicit LargeBuffer(std::size_t size) : size_(size), elements_(LargePageAllocator<T>().allocate(size)) {}
  LargeBuffer(LargeBuffer&& other) noexcept
      : size_(std::exchange(other.size_, 0)), elements_(std::exchange(other.elements_, nullptr)) {}
  LargeBuffer& operator=(LargeBuffer other) noexcept {
    std::swap(size_, other.size_);
    std::swap(elements_, other.elements_);
    return *this;
  }
  ~LargeBuffer() {
    if (elements_) LargePageAllocator<T>().deallocate(elements_, size_);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return elements_; }
  const T* data() const { return elements_; }
  const T* begin() const { return elements_; }
  const T* end() const { return elements_ + size_; }
  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }
  std::span<T> part(std::size_t first, std::size_t count) { return {elements_ + first, count}; }

 private:
  std::size_t size_ = 0;
  T* elements_ = nullptr;
};

}  // namespace sightline
