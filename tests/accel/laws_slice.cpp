/// Compiled once a slice, with SIGHTLINE_SLICE set by the build: the laws over every fourth structure of the registry.

#include <tuple>

#include "sightline/accel/registry.h"
#include "tests/accel/laws.h"

namespace sightline::laws {

template <std::size_t Index, class List>
struct EveryFourth;
template <std::size_t Index>
struct EveryFourth<Index, TypeList<>> {
  using type = std::tuple<>;
};
template <std::size_t Index, class First, class... Rest>
struct EveryFourth<Index, TypeList<First, Rest...>> {
  using rest = typename EveryFourth<Index + 1, TypeList<Rest...>>::type;
  using type =
      std::conditional_t<Index % 4 == SIGHTLINE_SLICE,
                         decltype(std::tuple_cat(std::declval<std::tuple<First>>(), std::declval<rest>())), rest>;
};
template <class Tuple>
struct TypesOf;
template <class... Types>
struct TypesOf<std::tuple<Types...>> {
  using type = ::testing::Types<Types...>;
};
using Slice = TypesOf<EveryFourth<0, Accelerators>::type>::type;

INSTANTIATE_TYPED_TEST_SUITE_P(Registry, Laws, Slice, NameOf);

}  // namespace sightline::laws
