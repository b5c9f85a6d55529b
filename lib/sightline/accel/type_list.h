#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace sightline {

/// A list of types to run templates over.
template <class... Types>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Types);

  /// Calls visit.operator()<Type>(index) for each type, in order, the index as a compile-time constant.
  template <class Visit>
  static constexpr void for_each(Visit&& visit) {
    for_each(visit, std::index_sequence_for<Types...>{});
  }

  template <template <class...> class Other>
  using apply = Other<Types...>;

 private:
  template <class Visit, std::size_t... Index>
  static constexpr void for_each(Visit& visit, std::index_sequence<Index...>) {
    (visit.template operator()<Types>(std::integral_constant<std::size_t, Index>{}), ...);
  }
};

}  // namespace sightline
