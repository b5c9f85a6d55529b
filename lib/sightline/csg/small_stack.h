#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace sightline {

/// A stack that takes no memory from the heap while it is short. Of values that need no destruction, since what is not
/// yet pushed stays uninitialized.
template <class T, std::uint32_t small>
class SmallStack {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  SmallStack() {}  // the values stay as they are: most queries write a few
  SmallStack(const SmallStack&) = delete;
  SmallStack& operator=(const SmallStack&) = delete;

  std::uint32_t size() const { return size_; }
  T& operator[](std::uint32_t i) { return data_[i]; }
  const T& operator[](std::uint32_t i) const { return data_[i]; }
  const T* begin() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }

  [[gnu::always_inline]] void push(const T& value) {
    if (size_ == capacity_) [[unlikely]] {
      const T kept = value;  // it may be one of these
      grow();
      data_[size_++] = kept;
    } else {
      data_[size_++] = value;
    }
  }
  void truncate(std::uint32_t size) { size_ = size; }

  /// Removes the values in [first, last); those behind move up.
  void erase(std::uint32_t first, std::uint32_t last) {
    for (; last < size_; ++first, ++last) data_[first] = data_[last];
    size_ = first;
  }

 private:
  [[gnu::noinline]] void grow() {
    std::vector<T> larger(2 * static_cast<std::size_t>(capacity_));
    std::copy(data_, data_ + size_, larger.data());
    heap_ = std::move(larger);
    data_ = heap_.data();
    capacity_ *= 2;
  }

  union {
    std::array<T, small> small_;
  };
  std::vector<T> heap_;
  T* data_ = small_.data();
  std::uint32_t size_ = 0, capacity_ = small;
};

}  // namespace sightline
