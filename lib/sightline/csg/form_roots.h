#pragma once
/// Roots of the polynomials of faces, in any type of numbers that roots are found in.

#include "sightline/math/quadratic.h"
#include "sightline/math/quartic.h"
#include "sightline/math/sized_double.h"
#include "sightline/shape/solid_shape.h"

namespace sightline {

template <class N>
RootList roots_of(const solid::LinearForm<N>& form) {
  return linear_roots(form.slope, form.level);
}
template <class N>
RootList roots_of(const solid::QuadraticForm<N>& form) {
  return quadratic_roots(form.a, form.b, form.c);
}
template <class N>
RootList roots_of(const solid::QuarticForm<N>& form) {
  return quartic_roots(form.coefficients);
}

}  // namespace sightline
