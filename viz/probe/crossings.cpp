#include "viz/probe/crossings.h"

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "sightline/csg/evaluator.h"
#include "sightline/csg/face_roots.h"
#include "sightline/csg/primitive_bounds.h"
#include "sightline/scene/solid_file.h"
#include "sightline/scene/solid_frame.h"
#include "sightline/shape/triangle_crossings.h"

namespace sightline::probe {
namespace {

using nlohmann::ordered_json;

template <Level level>
using LevelTag = std::integral_constant<Level, level>;

template <class Do>
auto at_level(Level level, Do&& act) {
  switch (level) {
    case Level::fast:
      return act(LevelTag<Level::fast>());
    case Level::watertight:
      return act(LevelTag<Level::watertight>());
    case Level::precise:
      return act(LevelTag<Level::precise>());
    case Level::exact:
      break;
  }
  return act(LevelTag<Level::exact>());
}

/// What JSON has no number for, as text.
ordered_json number(double t) {
  if (std::isinf(t)) return t > 0 ? "inf" : "-inf";
  return t + 0.0;  // -0 is 0
}
ordered_json number(std::optional<double> t) { return t ? number(*t) : ordered_json(); }

/// A root as accurate as a level promises. Its sign is certain: of one that is known too roughly, the nearest double is
/// taken.
struct Place {
  double t;
  int sign;  ///< Of the root itself, of which t may be too small a one for doubles.
};

template <Level level>
Place place_of(const Root& root, const SurfaceRoot& surface) {
  constexpr double share = level == Level::watertight ? 0x1p-46 : 0x1p-52;
  const int sign = (root.t > 0) - (root.t < 0);
  if (level == Level::fast || root.radius <= share * std::fabs(root.t)) return {root.t, sign};
  return {nearest_root(surface), settled_order(surface, 0)};
}

/// The first that is not behind the origin.
template <class Places>
std::optional<double> first_of(const Places& places) {
  for (const Place& place : places) {
    if (place.sign >= 0) return place.t;
  }
  return std::nullopt;
}

template <class S>
void answer_roots(const S& surface, const Ray<double>& ray, Level level, ordered_json& answer) {
  check(SolidShape(surface));
  at_level(level, [&]<Level chosen>(LevelTag<chosen>) {
    const LocalRay<chosen> local(ray);
    const RootList list = face_roots<chosen>(surface, local);
    std::vector<Place> places;
    ordered_json roots = ordered_json::array(), multiplicities = ordered_json::array();
    for (int i = 0; i < list.count; ++i) {
      const Root& root = list.roots[static_cast<std::size_t>(i)];
      places.push_back(place_of<chosen>(root, {surface, local, i}));
      roots.push_back(number(places.back().t));
      multiplicities.push_back(root.multiplicity);
    }
    answer["roots"] = roots;
    answer["multiplicity"] = multiplicities;
    answer["t_first"] = number(first_of(places));
  });
}

// ---- Boxes

/// Where the line crosses the plane of a face.
struct PlaneCrossing {
  Root root;
  solid::AxisPlane plane;
};

/// Whether a comes after b, exactly but at level fast.
template <Level level>
bool is_after(const PlaneCrossing& a, const PlaneCrossing& b, const FramedRay& ray) {
  const double reach = (a.root.radius + b.root.radius) * (1 + 0x1p-50);
  if (level == Level::fast || std::fabs(a.root.t - b.root.t) * (1 - 0x1p-50) > reach) return a.root.t > b.root.t;
  return settled_order(SurfaceRoot{a.plane, ray, 0}, SurfaceRoot{b.plane, ray, 0}) > 0;
}

struct Passage {
  PlaneCrossing enter, exit;
};

/// By slabs (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). A line in the plane of a face is within that slab.
template <Level level>
std::optional<Passage> passage(const solid::Box& box, const LocalRay<level>& ray) {
  std::optional<PlaneCrossing> enter, exit;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<int>(axis);
    const double from = ray.ray().origin[k];
    const bool is_falling = ray.ray().direction[k] < 0;
    const solid::AxisPlane first = face_of(box, 2 * axis + (is_falling ? 1 : 0)),
                           last = face_of(box, 2 * axis + (is_falling ? 0 : 1));
    const RootList in = face_roots<level>(first, ray), out = face_roots<level>(last, ray);
    if (in.count == 0) {
      if (from < box.lo[k] || from > box.hi[k]) return std::nullopt;
      continue;
    }
    const PlaneCrossing entered{in.roots[0], first}, left{out.roots[0], last};
    if (!enter || is_after<level>(entered, *enter, ray)) enter = entered;
    if (!exit || is_after<level>(*exit, left, ray)) exit = left;
  }
  if (!enter || is_after<level>(*enter, *exit, ray)) return std::nullopt;
  return Passage{*enter, *exit};
}

// ---- Trees

SurfaceRoot root_of(const Boundary& boundary, const Solid& solid, const Ray<double>& ray) {
  const Primitive& primitive = solid.primitives()[boundary.primitive];
  return {surface_of(primitive.shape, boundary.face), FramedRay(ray, solid.frame_of(primitive)),
          static_cast<int>(boundary.root)};
}

}  // namespace

void answer_sphere(const JsonValue& json, const Ray<double>& ray, Level level, ordered_json& answer) {
  const solid::Sphere sphere{vector_of(json["c"]), json["r"].real()};
  if (sphere.radius < 0) json["r"].fail("a radius that is not negative");
  answer_roots(sphere, ray, level, answer);
}

void answer_torus(const JsonValue& json, const Ray<double>& ray, Level level, ordered_json& answer) {
  const auto center = json.find("c");
  const solid::Torus torus{center ? vector_of(*center) : Vec3d(0), Vec3d(0, 0, 1), json["R"].real(), json["r"].real()};
  for (const char* radius : {"R", "r"}) {
    if (json[radius].real() < 0) json[radius].fail("a radius that is not negative");
  }
  answer_roots(torus, ray, level, answer);
}

void answer_box(const JsonValue& json, const Ray<double>& ray, Level level, ordered_json& answer) {
  const solid::Box box{vector_of(json["lo"]), vector_of(json["hi"])};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.lo[axis] <= box.hi[axis]))
      json["hi"][static_cast<std::size_t>(axis)].fail("a number that is not below that of lo");
  }
  at_level(level, [&]<Level chosen>(LevelTag<chosen>) {
    const LocalRay<chosen> local(ray);
    const auto found = passage<chosen>(box, local);
    std::vector<Place> places;
    if (found) {
      for (const PlaneCrossing& crossing : {found->enter, found->exit})
        places.push_back(place_of<chosen>(crossing.root, {crossing.plane, local, 0}));
    }
    answer["hit"] = found.has_value();
    answer["enter"] = found ? number(places[0].t) : ordered_json();
    answer["exit"] = found ? number(places[1].t) : ordered_json();
    answer["t_first"] = number(first_of(places));
  });
}

void answer_mesh(const JsonValue& json, const Ray<double>& ray, Level level, ordered_json& answer) {
  const TriangleList list = triangles_of(json);
  const auto find = level == Level::fast ? rounded_triangle_crossings : triangle_crossings;
  const auto crossings = find(FramedRay(ray), list.vertices, list.triangles);
  ordered_json ts = ordered_json::array(), triangles = ordered_json::array();
  for (const TriangleCrossing& crossing : crossings) {
    ts.push_back(number(crossing.t));
    triangles.push_back(crossing.triangles);
  }
  answer["t"] = ts;
  answer["tris"] = triangles;
  answer["t_first"] = crossings.empty() ? ordered_json() : number(crossings.front().t);
}

void answer_tree(const JsonValue& json, const Ray<double>& ray, Level level, ordered_json& answer) {
  if (!is_valid(ray)) {
    throw std::invalid_argument(":/ray/d: expected a direction whose largest number is from 2^-500 to 2^500, found " +
                                std::to_string(max_norm(ray.direction)));
  }
  const Solid solid(solid_of(json));
  at_level(level, [&]<Level chosen>(LevelTag<chosen>) {
    NoSolidProbe probe;
    SolidEvaluator<chosen> evaluator(solid, ray, probe);
    const SpanList list = evaluator.spans();
    const std::span<const Boundary> boundaries = evaluator[list];
    std::vector<Place> places;
    for (const Boundary& boundary : boundaries) {
      places.push_back(place_of<chosen>(Root{boundary.t, boundary.radius, 1}, root_of(boundary, solid, ray)));
    }
    // Bounded ones may stand in the wrong order, though theirs is certain; the nearest doubles do not.
    const auto is_before = [](const Place& a, const Place& b) { return a.t < b.t; };
    if (chosen != Level::fast && !std::is_sorted(places.begin(), places.end(), is_before)) {
      for (std::size_t i = 0; i < places.size(); ++i) places[i].t = nearest_root(root_of(boundaries[i], solid, ray));
    }
    ordered_json intervals = ordered_json::array();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double enter = -infinity;
    bool is_inside = list.begins_inside;
    for (const Place& place : places) {
      if (is_inside) intervals.push_back(ordered_json::array({number(enter), number(place.t)}));
      enter = place.t;
      is_inside = !is_inside;
    }
    if (is_inside) intervals.push_back(ordered_json::array({number(enter), number(infinity)}));
    answer["intervals"] = intervals;
    answer["t_first"] = number(first_of(places));
  });
}

}  // namespace sightline::probe
