#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace sightline {

/// Room for `count` objects, none of which is made: for what is written before it is read, where starting all of them
/// would cost more than using some.
template <class T, std::size_t count>
class RawArray {
 public:
  static_assert(std::is_trivially_destructible_v<T>);

  RawArray() {}  // NOLINT: a defaulted one would be deleted
  RawArray(const RawArray&) = delete;
  RawArray& operator=(const RawArray&) = delete;

  template <class... A>
  T& make(std::size_t i, A&&... arguments) {
    return *std::construct_at(items_ + i, std::forward<A>(arguments)...);
  }
  T& operator[](std::size_t i) { return items_[i]; }
  const T& operator[](std::size_t i) const { return items_[i]; }
  /// Of trivially copyable objects, to be assigned to.
  std::span<T> first(std::size_t n) requires std::is_trivially_copyable_v<T> { return {items_, n}; }

 private:
  union {
    T items_[count];
  };
};

}  // namespace sightline
