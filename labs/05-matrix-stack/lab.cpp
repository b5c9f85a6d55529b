/// Lab 05: what is asked of a student's matrices. All numbers are small and whole, so that every result is exact.

#include <array>
#include <cmath>
#include <string>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/vec.h"

namespace sightline::labs {
namespace matrix_stack {
namespace {

/// As the student's files have them.
struct Matrix {
  std::array<std::array<double, 4>, 4> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  friend bool operator==(const Matrix&, const Matrix&) = default;
};
struct Work {
  std::uint64_t products = 0, points = 0;
};
struct Step {
  std::int32_t kind = 0, axis = 0, amount = 0;
};
struct Stroke {
  Vec3d from, to;
};

using labs::text_of;
std::string text_of(const Matrix& m) {
  std::string text;
  for (const auto& row : m.rows) {
    text += text.empty() ? "" : "\n";
    for (const double x : row) text += number(x) + " ";
  }
  return text;
}

// ---- The truth: column by column, where the student is asked to go row by row

Vec3d moved(const Matrix& m, const Vec3d& p, double w) {
  Vec3d sum(0);
  for (std::size_t column = 0; column < 4; ++column) {
    const double factor = column == 3 ? w : p[static_cast<int>(column)];
    sum += factor * Vec3d(m.rows[0][column], m.rows[1][column], m.rows[2][column]);
  }
  return sum;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix m;
  for (std::size_t column = 0; column < 4; ++column) {
    const Vec3d of_b(b.rows[0][column], b.rows[1][column], b.rows[2][column]);
    const Vec3d of_a = moved(a, of_b, column == 3 ? 1 : 0);
    for (std::size_t row = 0; row < 3; ++row) m.rows[row][column] = of_a[static_cast<int>(row)];
  }
  return m;
}

Matrix matrix_of(const Step& step) {
  Matrix m;
  const auto axis = static_cast<std::size_t>(step.axis);
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  if (step.kind == 2) m.rows[axis][3] = step.amount;
  if (step.kind == 3) m.rows[axis][axis] = step.amount;
  if (step.kind == 4) {
    const double sine = step.amount < 0 ? -1 : 1;
    m.rows[next][next] = m.rows[last][last] = 0;
    m.rows[next][last] = -sine, m.rows[last][next] = sine;
  }
  return m;
}

/// Twelve numbers from the case's `first` on.
Matrix matrix_at(const std::vector<int>& numbers, std::size_t first) {
  Matrix m;
  for (std::size_t i = 0; i < 12; ++i) m.rows[i / 4][i % 4] += numbers[first + i];
  return m;
}
Vec3d vector_at(const std::vector<int>& numbers, std::size_t first) {
  return {double(numbers[first]), double(numbers[first + 1]), double(numbers[first + 2])};
}

template <class X>
std::optional<Trouble> trouble_between(const X& got, const X& expected) {
  if (got == expected) return std::nullopt;
  return Trouble{text_of(expected), text_of(got)};
}

Check plain(std::string name, std::string section, std::string why, std::vector<std::string> hints,
            const Recipe& recipe) {
  return {std::move(name), std::move(section), std::move(why), std::move(hints), recipe, 300, false, {}, {}, {}};
}

constexpr const char* one = "1. Rows times columns";
constexpr const char* two = "2. Move, stretch, turn";
constexpr const char* three = "3. Points, directions, normals";

Check multiply_check() {
  Check check = plain("multiply", one,
                      "The order of a product is the order of what happens: an arm turns about its shoulder, or the "
                      "world about its hand.",
                      {"A row of a, times a column of b, number by number, added up."}, {24, 0, 0, 3});
  check.describe = [](const Case& at) {
    return "a\n" + text_of(matrix_at(at.head, 0)) + "\nb\n" + text_of(matrix_at(at.head, 12));
  };
  check.ask = [](const Case& at, Subject& subject) {
    const Matrix a = matrix_at(at.head, 0), b = matrix_at(at.head, 12);
    return trouble_between(subject.ask<Matrix>("multiply", a, b), product(a, b));
  };
  return check;
}

Check steps_check() {
  Check check =
      plain("steps", two, "Three kinds of steps, and every pose of every figure is made of them.",
            {"What becomes of (1 0 0)? That is the first column.",
             "A quarter turn about z takes x to y. Which two numbers of the matrix say so, and which has the minus?",
             "About y the turn goes from z to x: the axes follow each other in a circle, x y z x."},
            {3, 0, 0, 4});
  const auto step_of = [](const Case& at) {
    return Step{2 + std::abs(at.head[0]) % 3, std::abs(at.head[1]) % 3, at.head[2]};
  };
  check.describe = [step_of](const Case& at) {
    const Step step = step_of(at);
    const std::string axis(1, "xyz"[step.axis]);
    if (step.kind == 2) return "translation by " + std::to_string(step.amount) + " along " + axis;
    if (step.kind == 3) return "scaling by " + std::to_string(step.amount) + " along " + axis;
    return std::string("a quarter turn about ") + axis + (step.amount < 0 ? ", clockwise" : "");
  };
  check.ask = [step_of](const Case& at, Subject& subject) {
    const Step step = step_of(at);
    Vec3d along(step.kind == 3 ? 1.0 : 0.0);
    along[step.axis] = step.amount;
    const Matrix got = step.kind == 2 ? subject.ask<Matrix>("translation", along)
                       : step.kind == 3
                           ? subject.ask<Matrix>("scaling", along)
                           : subject.ask<Matrix>("rotation", int(step.axis), 0.0, step.amount < 0 ? -1.0 : 1.0);
    return trouble_between(got, matrix_of(step));
  };
  return check;
}

Check vector_check(const char* name, std::string why, std::vector<std::string> hints, double w) {
  Check check = plain(name, three, std::move(why), std::move(hints), {15, 0, 0, 4});
  check.describe = [](const Case& at) {
    return text_of(vector_at(at.head, 0)) + " by\n" + text_of(matrix_at(at.head, 3));
  };
  check.ask = [name, w](const Case& at, Subject& subject) {
    const Vec3d v = vector_at(at.head, 0);
    const Matrix m = matrix_at(at.head, 3);
    return trouble_between(subject.ask<Vec3d>(name, m, v), moved(m, v, w));
  };
  return check;
}

/// A normal is what stands upright on the surface, and on its side: both are asked after the transform.
Check normal_check() {
  Check check = plain(
      "normal", three,
      "With normals that are transformed like directions, a stretched ball is lit as if it were round.",
      {"What is perpendicular to the surface before has to be so afterwards. Try a ball that is stretched along x.",
       "Cross products of the matrix's columns are perpendicular to what the columns are.",
       "A matrix with a negative determinant mirrors: then cross products point to the other side."},
      {15, 0, 0, 3});
  check.describe = [](const Case& at) {
    return "normal " + text_of(vector_at(at.head, 0)) + " by\n" + text_of(matrix_at(at.head, 3));
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Vec3d n = vector_at(at.head, 0);
    const Matrix m = matrix_at(at.head, 3);
    const Vec3d x = moved(m, {1, 0, 0}, 0), y = moved(m, {0, 1, 0}, 0), z = moved(m, {0, 0, 1}, 0);
    if (n == Vec3d(0) || glm::dot(x, glm::cross(y, z)) == 0) return std::nullopt;  // nothing is promised
    const Vec3d got = subject.ask<Vec3d>("normal", m, n);
    // Two tangents of the surface, whole as well.
    const Vec3d tangent = n.x != 0 || n.y != 0 ? Vec3d(-n.y, n.x, 0) : Vec3d(1, 0, 0), other = glm::cross(n, tangent);
    const double size = glm::length(got) * 1000;
    for (const Vec3d& t : {tangent, other}) {
      const Vec3d afterwards = moved(m, t, 0);
      // Exact where no inverse was divided by, and within a few roundings where one was.
      if (std::fabs(glm::dot(got, afterwards)) > 0x1p-44 * size) {
        return Trouble{"perpendicular to " + text_of(afterwards) + ", which lies in the surface", text_of(got)};
      }
    }
    if (!(glm::dot(got, moved(m, n, 0)) > 0)) {
      return Trouble{"on the same side of the surface as " + text_of(moved(m, n, 0)), text_of(got)};
    }
    return std::nullopt;
  };
  return check;
}

std::vector<Step> steps_of(const Case& at) {
  std::vector<Step> steps;
  for (const auto& item : at.items) steps.push_back({std::abs(item[0]) % 5, std::abs(item[1]) % 3, item[2]});
  return steps;
}

Check stack_check() {
  Check check =
      plain("stack", "4. The stack", "After the left arm is drawn, the right one has to begin at the trunk again.",
            {"The step goes to the right of what is current: current times step.",
             "pop() brings back what was kept; nothing is computed, so nothing is rounded.",
             "pop() without push() is refused: throw std::logic_error."},
            {0, 3, 12, 4});
  check.describe = [](const Case& at) {
    std::string text;
    for (const Step& step : steps_of(at)) {
      constexpr const char* kinds[] = {"push", "pop", "translate", "scale", "rotate"};
      text += (text.empty() ? "" : ", ") + std::string(kinds[step.kind]);
      if (step.kind > 1) text += std::string(" ") + "xyz"[step.axis] + " " + std::to_string(step.amount);
    }
    return text.empty() ? "nothing" : text;
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto steps = steps_of(at);
    std::vector<Matrix> kept;
    std::optional<Matrix> current = Matrix();
    for (const Step& step : steps) {
      if (step.kind == 0) {
        kept.push_back(*current);
      } else if (step.kind == 1) {
        if (kept.empty()) {
          current.reset();
          break;
        }
        current = kept.back();
        kept.pop_back();
      } else {
        current = product(*current, matrix_of(step));
      }
    }
    const auto got = subject.ask<std::optional<Matrix>>("stack", steps);
    if (got == current) return std::nullopt;
    const auto text = [](const std::optional<Matrix>& m) { return m ? text_of(*m) : "std::logic_error"; };
    return Trouble{text(current), text(got)};
  };
  check.count = 600;
  return check;
}

std::vector<Matrix> chain_of(std::size_t count) {
  std::vector<Matrix> chain;
  for (std::size_t i = 0; i < count; ++i) {
    const int k = static_cast<int>(i);
    chain.push_back(matrix_of({2 + k % 3, k % 3, k % 3 == 1 ? 2 : 1 - 2 * (k % 2)}));
  }
  return chain;
}
std::vector<Vec3d> points_of(std::size_t count) {
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({double(i % 5), double(i % 7), double(i % 3)});
  return points;
}

Check chain_check() {
  Check check =
      plain("chain", "5. Once for all", "The last matrix of a chain is the one next to the point.",
            {"Start with the identity, and multiply from the left end of the chain to the right."}, {1, 0, 0, 8});
  check.describe = [](const Case& at) { return std::to_string(std::abs(at.head[0])) + " matrices, ten points"; };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto chain = chain_of(static_cast<std::size_t>(std::abs(at.head[0])));
    const auto points = points_of(10), got = subject.ask<std::vector<Vec3d>>("all", chain, points);
    if (got.size() != points.size()) return Trouble{"10 points", std::to_string(got.size())};
    Matrix all;
    for (const Matrix& m : chain) all = product(all, m);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (got[i] == moved(all, points[i], 1)) continue;
      return Trouble{text_of(moved(all, points[i], 1)) + " for the point " + text_of(points[i]), text_of(got[i])};
    }
    return std::nullopt;
  };
  return check;
}

Check work_check() {
  Check check =
      plain("work", "5. Once for all",
            "A figure has ten joints and ten thousand points: the joints are multiplied once, not for every point.",
            {"What of the chain does not depend on the point?"}, {});
  check.count = 1;
  check.is_budget = true;
  check.describe = [](const Case&) { return "a chain of 12 matrices, 1000 points"; };
  check.ask = [](const Case&, Subject& subject) -> std::optional<Trouble> {
    const Work work = subject.ask<Work>("work", chain_of(12), points_of(1000));
    if (work.products <= 12 && work.points <= 1000) return std::nullopt;
    return Trouble{"at most 12 products of matrices, and 1000 of a matrix and a point",
                   std::to_string(work.products) + " and " + std::to_string(work.points)};
  };
  return check;
}

Drawing plant(Subject& subject) {
  SpacePanel panel;
  for (const Stroke& stroke : subject.ask<std::vector<Stroke>>("plant", 6)) {
    panel.lines.push_back({{{stroke.from.x, stroke.from.y, 0}, {stroke.to.x, stroke.to.y, 0}}, Role::ray, false, ""});
  }
  return {
      "A plant of plants", "Every stroke is the same stem, placed by the matrix on top of your stack.", {{"", panel}}};
}

}  // namespace
}  // namespace matrix_stack

Lab matrix_stack_lab() {
  using namespace matrix_stack;
  Lab lab{"05", "matrix-stack", "Matrix stack", {"matrix_stack.h"}, {}, plant, ""};
  lab.checks = {multiply_check(),
                steps_check(),
                vector_check("point", "A point that forgets the last column never leaves its place.",
                             {"The fourth number of a point is 1."}, 1),
                vector_check("direction", "A camera that is moved does not look elsewhere.",
                             {"The fourth number of a direction is 0."}, 0),
                normal_check(),
                stack_check(),
                chain_check(),
                work_check()};
  return lab;
}

}  // namespace sightline::labs
