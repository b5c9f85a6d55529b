#pragma once
/// A stack whose capacity is proven by its owner.

#include <array>
#include <cassert>

namespace sightline {

/// Left uninitialized on purpose: clearing it would cost more than a short traversal. The owner states the invariant
/// that bounds the depth (K3 of the kd-tree, for one); builds with assertions check it.
template <class T, int Capacity>
class FixedStack {
 public:
  bool empty() const { return size_ == 0; }
  int size() const { return size_; }
  void push(const T& item) {
    assert(size_ < Capacity);
    items_[size_++] = item;
  }
  T pop() {
    assert(size_ > 0);
    return items_[--size_];
  }

 private:
  std::array<T, Capacity> items_;
  int size_ = 0;
};

}  // namespace sightline
