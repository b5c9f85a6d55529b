#pragma once
/// Polynomials asked of the library's solvers.

#include <array>

#include "sightline/math/random.h"
#include "tests/hard_cases/root_question.h"

namespace sightline::hard {

/// Coefficients from the highest on.
using Quadratic = std::array<double, 3>;
using Quartic = std::array<double, 5>;

/// As a quadric along a ray at all levels, which settles what a level asks for; and the solver itself, in float (fast),
/// double (watertight), balls (precise) and integers (exact).
void ask_quadratic(Trial& trial, const Quadratic& coefficients);

/// The solver in float (fast), in balls of double, and of some 100 bits where these are not certain (precise), and in
/// integers (exact). In double alone it promises nothing: solids ask it in balls, and integers where these fail.
RootQuestion ask_quartic(Trial& trial, const Quartic& coefficients);

/// By the formula from school, in double.
void judge_school(Trial& trial, const Quadratic& coefficients);
/// By Ferrari's way, in double.
void judge_ferrari(Trial& trial, const RootQuestion& question, const Quartic& coefficients);

/// Each coefficient a few ulps away.
Quartic nudged(const Quartic& coefficients, Random& random);

RootQuestion quartic_question(const Quartic& coefficients);

}  // namespace sightline::hard
