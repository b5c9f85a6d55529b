#include <cmath>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"

namespace sightline::bench {
namespace {

/// A rotation, by columns, and a move after it.
template <class T>
struct Step {
  Vec3<T> x, y, z, move;

  Vec3<T> vector(const Vec3<T>& v) const { return v.x * x + v.y * y + v.z * z; }
  /// First `inner`, then this.
  Step after(const Step& inner) const {
    return {vector(inner.x), vector(inner.y), vector(inner.z), vector(inner.move) + move};
  }
  T determinant() const { return glm::dot(x, glm::cross(y, z)); }
};

struct Walk {
  std::array<int, 4> turn;  ///< A quaternion.
  Vec3d move;
};

template <class T>
Step<T> step_of(const Walk& walk) {
  const double w = walk.turn[0], x = walk.turn[1], y = walk.turn[2], z = walk.turn[3];
  const double size = w * w + x * x + y * y + z * z;
  const Vec3d along_x(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y));
  const Vec3d along_y(2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x));
  const Vec3d along_z(2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z);
  return {Vec3<T>(along_x / size), Vec3<T>(along_y / size), Vec3<T>(along_z / size), Vec3<T>(walk.move)};
}

template <class T>
Step<T> identity() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
}

template <class T>
Step<T> one_by_one(const Walk& walk, std::size_t count) {
  const Step<T> step = step_of<T>(walk);
  Step<T> all = identity<T>();
  for (std::size_t i = 0; i < count; ++i) all = step.after(all);
  return all;
}

/// Made orthonormal after every product (Gram and Schmidt).
template <class T>
Step<T> renormalised(const Walk& walk, std::size_t count) {
  const Step<T> step = step_of<T>(walk);
  Step<T> all = identity<T>();
  for (std::size_t i = 0; i < count; ++i) {
    all = step.after(all);
    all.x = glm::normalize(all.x);
    all.y = glm::normalize(all.y - glm::dot(all.x, all.y) * all.x);
    all.z = glm::cross(all.x, all.y);
  }
  return all;
}

/// Premultiplied: squares of the step, as many as its number has digits.
template <class T>
Step<T> by_squares(const Walk& walk, std::size_t count) {
  Step<T> power = step_of<T>(walk), all = identity<T>();
  for (; count > 0; count /= 2) {
    if (count % 2 == 1) all = power.after(all);
    power = power.after(power);
  }
  return all;
}

template <class T>
Choice choice_of(const std::string& name, const std::vector<Walk>& walks,
                 const std::vector<std::array<True, 3>>& truths, std::size_t count,
                 Step<T> (*go)(const Walk&, std::size_t)) {
  ErrorSum sum;
  double determinant = 0;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const Step<double> whole = [&] {
      const Step<T> end = go(walks[i], count);
      return Step<double>{Vec3d(end.x), Vec3d(end.y), Vec3d(end.z), Vec3d(end.move)};
    }();
    Vec3d off;
    for (int axis = 0; axis < 3; ++axis) off[axis] = truths[i][static_cast<std::size_t>(axis)].off(whole.move[axis]);
    sum.add(glm::length(off) / glm::length(walks[i].move));
    determinant = std::max(determinant, std::fabs(whole.determinant() - 1));
  }
  const auto pass = [walks, count, go] {
    double all = 0;
    for (const Walk& walk : walks) all += static_cast<double>(go(walk, count).move.x);
    return all;
  };
  return {name, sum.errors(), pass, {{"lg determinant's error", std::log10(std::max(determinant, 0x1p-60))}}};
}

Panel panel_of(const Effort& effort, std::size_t count) {
  Chance chance(effort.seed);
  std::vector<Walk> walks;
  std::vector<std::array<True, 3>> truths;
  for (std::size_t i = 0; i < effort.count(8, 4); ++i) {
    const auto whole = [&] { return static_cast<int>(chance.below(41)) - 20; };
    walks.push_back({{60, whole(), whole(), whole()}, Vec3d(Vec3f(chance.direction()))});
    truths.push_back(true_walk(walks[i].turn, walks[i].move, count));
  }
  const std::string number = std::to_string(count);
  Panel panel{number + " steps",
              number + " times a turn and a move of length 1",
              "chain",
              "of the position, in moves",
              ErrorKind::maximum,
              static_cast<double>(walks.size())};
  panel.choices = {choice_of<float>("products float", walks, truths, count, one_by_one<float>),
                   choice_of<double>("products double", walks, truths, count, one_by_one<double>),
                   choice_of<float>("renormalised float", walks, truths, count, renormalised<float>),
                   choice_of<double>("renormalised double", walks, truths, count, renormalised<double>),
                   choice_of<float>("premultiplied float", walks, truths, count, by_squares<float>),
                   choice_of<double>("premultiplied double", walks, truths, count, by_squares<double>)};
  return panel;
}

std::vector<Panel> panels(const Effort& effort) {
  std::vector<Panel> all;
  for (const std::size_t count : {std::size_t{10}, std::size_t{1'000}, effort.count(100'000, 10'000)}) {
    effort.say(std::to_string(count) + " exact steps");
    all.push_back(panel_of(effort, count));
  }
  return all;
}

}  // namespace

Axis matrix_axis() { return {"matrix", "how chains of transforms are multiplied", panels}; }

}  // namespace sightline::bench
