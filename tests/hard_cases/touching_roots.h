#pragma once
/// Roots of one face that are touched, asked at every level: no span tells of them.

#include <optional>
#include <string_view>

#include "sightline/csg/face_roots.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {

/// What is expected of a face: one double root at the number, or none.
template <Level level, class S>
void ask_touch_at(Trial& trial, std::string_view who, const S& surface, const Ray<double>& ray, double touch) {
  const RootList list = face_roots<level>(surface, LocalRay<level>(ray));
  Verdict verdict = Verdict::wrong;
  double error = 0;
  if (list.count == 1 && list.roots[0].multiplicity == 2) {
    const double off = std::fabs(list.roots[0].t - touch), size = std::fabs(touch);
    error = off == 0 ? 0 : off / size;
    // lib/README.md; `fast` promises no double roots, but a float is near its number.
    const double share = level == Level::fast ? 0x1p-19 : level == Level::watertight ? 0x1p-46 : 0x1p-52;
    if (off == 0) {
      verdict = Verdict::exact;
    } else if (level != Level::exact && off <= share * size) {
      verdict = Verdict::within_bound;
    }
  }
  trial.of(who, level).add(verdict, error, [&] {
    std::string got;
    for (int i = 0; i < list.count; ++i) {
      const Root& root = list.roots[static_cast<std::size_t>(i)];
      got += (i > 0 ? ", " : "") + all_digits(root.t) + (root.multiplicity == 2 ? " twice" : "");
    }
    return Example{text_of(SolidTree(surface)) + ", " + text_of(ray), all_digits(touch) + " twice",
                   got.empty() ? "none" : got};
  });
}

/// At `touch`, a double: of a line that only touches the surface there.
template <class S>
void ask_touch(Trial& trial, std::string_view who, const S& surface, const Ray<double>& ray, double touch) {
  ask_touch_at<Level::fast>(trial, who, surface, ray, touch);
  ask_touch_at<Level::watertight>(trial, who, surface, ray, touch);
  ask_touch_at<Level::precise>(trial, who, surface, ray, touch);
  ask_touch_at<Level::exact>(trial, who, surface, ray, touch);
}

}  // namespace sightline::hard
