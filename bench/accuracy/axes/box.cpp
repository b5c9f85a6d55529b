#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "sightline/accel/padded_ray.h"

namespace sightline::bench {
namespace {

constexpr std::size_t boxes_a_ray = 8;

struct Question {
  Ray<float> ray;
  std::array<Aabb, boxes_a_ray> boxes;
  Aabb bounds;
};
using Questions = std::vector<Question>;

Vec3f corner_of(const Aabb& box, std::uint64_t number) {
  return {number & 1 ? box.hi.x : box.lo.x, number & 2 ? box.hi.y : box.lo.y, number & 4 ? box.hi.z : box.lo.z};
}

/// Rays at points of the first box's edges; the other boxes touch that point as well, or nearly. Every sixteenth ray
/// runs along an axis in a face.
Questions questions_of(const Effort& effort) {
  Chance chance(effort.seed);
  Questions questions(effort.count(40'000, 8'000));
  for (std::size_t i = 0; i < questions.size(); ++i) {
    Question& question = questions[i];
    const auto size = [&] { return chance.scale(0x1p-6, 1); };
    Aabb& first = question.boxes[0];
    first.lo = Vec3f(chance.point(10)), first.hi = first.lo + Vec3f(Vec3d(size(), size(), size()));
    const std::uint64_t corner = chance.below(8);
    const int axis = static_cast<int>(chance.below(3));
    Vec3f at = corner_of(first, corner);
    at[axis] = static_cast<float>(chance.between(first.lo[axis], first.hi[axis]));
    for (Aabb& box : question.boxes) {
      if (&box == &first) continue;
      for (int k = 0; k < 3; ++k) {
        const auto wide = static_cast<float>(size());
        (chance.sign() > 0 ? box.lo : box.hi)[k] = at[k];
        box.lo[k] = std::min(box.lo[k], at[k]), box.hi[k] = std::max(box.hi[k], at[k]);
        if (box.lo[k] == at[k] && box.hi[k] == at[k]) (chance.sign() > 0 ? box.hi[k] += wide : box.lo[k] -= wide);
        if (!std::isfinite(box.lo[k])) box.lo[k] = at[k] - wide;
        if (!std::isfinite(box.hi[k])) box.hi[k] = at[k] + wide;
      }
    }
    for (const Aabb& box : question.boxes) question.bounds.extend(box);
    Vec3d direction = chance.direction();
    if (i % 16 == 0) direction = Vec3d(0), direction[axis] = chance.sign();
    const Vec3f from(Vec3d(at) - chance.scale(3, 30) * direction);
    question.ray = {from, i % 16 == 0 ? Vec3f(direction) : at - from};
    if (i % 16 == 0) question.ray.origin[(axis + 1) % 3] = at[(axis + 1) % 3];
  }
  return questions;
}

/// As they are first written: divides by the direction, and orders each pair of planes.
struct Dividing {
  const Ray<float>& ray;
  explicit Dividing(const Question& question) : ray(question.ray) {}
  bool operator()(const Aabb& box) const {
    float lo = ray.t_min, hi = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis];
      const float b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
      lo = std::max(lo, std::min(a, b)), hi = std::min(hi, std::max(a, b));
    }
    return lo <= hi;
  }
};

/// Kay and Kajiya, "Ray Tracing Complex Scenes", 1986, with reciprocals of the direction.
struct Multiplying {
  const Ray<float>& ray;
  Vec3f inverse;
  explicit Multiplying(const Question& question) : ray(question.ray), inverse(1.0f / ray.direction) {}
  bool operator()(const Aabb& box) const {
    const Vec3f a = (box.lo - ray.origin) * inverse, b = (box.hi - ray.origin) * inverse;
    const Vec3f near = glm::min(a, b), far = glm::max(a, b);
    return std::max({ray.t_min, near.x, near.y, near.z}) <= std::min({ray.t_max, far.x, far.y, far.z});
  }
};

/// Williams, Barrus, Morley and Shirley, "An Efficient and Robust Ray-Box Intersection Algorithm", 2005: planes by the
/// direction's sign, and an order of comparisons in which a NaN keeps what was there. Ize, "Robust BVH Ray Traversal",
/// 2013, has the far plane taken 2 units in the last place farther.
template <bool is_padded>
struct Ordered {
  const Ray<float>& ray;
  Vec3f inverse;
  bool is_negative[3];
  explicit Ordered(const Question& question) : ray(question.ray), inverse(1.0f / ray.direction) {
    for (int axis = 0; axis < 3; ++axis) is_negative[axis] = std::signbit(ray.direction[axis]);
  }
  bool operator()(const Aabb& box) const {
    float lo = ray.t_min, hi = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const float near = ((is_negative[axis] ? box.hi : box.lo)[axis] - ray.origin[axis]) * inverse[axis];
      float far = ((is_negative[axis] ? box.lo : box.hi)[axis] - ray.origin[axis]) * inverse[axis];
      if constexpr (is_padded) far *= 1 + 0x1p-22f;
      lo = near > lo ? near : lo, hi = far < hi ? far : hi;
    }
    return lo <= hi;
  }
};

template <class T>
struct Ours {
  PaddedRay<T> ray;
  explicit Ours(const Question& question)
      : ray(Ray<T>{Vec3<T>(question.ray.origin), Vec3<T>(question.ray.direction)}, question.bounds) {}
  bool operator()(const Aabb& box) const { return !ray.clip(box, ray.t_max).is_empty(); }
};

using Truths = std::vector<std::array<bool, boxes_a_ray>>;

template <class Test>
Choice choice_of(const std::string& name, const std::shared_ptr<const Questions>& questions, const Truths& truths) {
  ErrorSum misses;
  std::size_t false_hits = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Test test((*questions)[i]);
    for (std::size_t k = 0; k < boxes_a_ray; ++k) {
      const bool is_met = test((*questions)[i].boxes[k]);
      misses.decide(is_met || !truths[i][k]);
      false_hits += is_met && !truths[i][k];
    }
  }
  const auto pass = [questions] {
    std::size_t met = 0;
    for (const Question& question : *questions) {
      const Test test(question);
      for (const Aabb& box : question.boxes) met += test(box);
    }
    return static_cast<double>(met);
  };
  const double per_million = ErrorSum::million / static_cast<double>(truths.size() * boxes_a_ray);
  return {name, misses.errors(), pass, {{"false hits/million", per_million * static_cast<double>(false_hits)}}};
}

std::vector<Panel> panels(const Effort& effort) {
  const auto questions = std::make_shared<const Questions>(questions_of(effort));
  Truths truths(questions->size());
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Question& question = (*questions)[i];
    for (std::size_t k = 0; k < boxes_a_ray; ++k) {
      truths[i][k] = truly_meets(question.boxes[k], to_double(question.ray));
    }
  }
  Panel panel{
      "at silhouettes",
      "rays at points of edges that eight boxes share, every sixteenth in a face of one; wrong is what is missed",
      "test",
      "",
      ErrorKind::wrong,
      static_cast<double>(truths.size() * boxes_a_ray)};
  panel.choices = {choice_of<Dividing>("min and max, divided", questions, truths),
                   choice_of<Multiplying>("min and max, reciprocals", questions, truths),
                   choice_of<Ordered<false>>("order that keeps NaN", questions, truths),
                   choice_of<Ordered<true>>("Ize, 2 ulp", questions, truths),
                   choice_of<Ours<float>>("ours float", questions, truths),
                   choice_of<Ours<double>>("ours double", questions, truths)};
  return {panel};
}

}  // namespace

Axis box_axis() { return {"box", "how a ray is tested against a box", panels}; }

}  // namespace sightline::bench
