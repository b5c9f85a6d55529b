/// Answers of the probe's own function, whole lines of JSON, against rational and algebraic oracles.
#include "viz/probe/answer.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "tests/math/sturm.h"
#include "tests/shape/crossing_oracle.h"

namespace sightline {
namespace {

using nlohmann::json;

json list(const Vec3d& v) { return {v.x, v.y, v.z}; }
json question(const Ray<double>& ray, const char* kind, const json& shape) {
  return {{"id", 7}, {"ray", {{"o", list(ray.origin)}, {"d", list(ray.direction)}}}, {kind, shape}};
}
json asked(const json& question, Level level) {
  const probe::Answer answer = probe::answer(question.dump(), 1, level);
  EXPECT_TRUE(answer.is_good) << question << '\n' << answer.text;
  json parsed = json::parse(answer.text);
  EXPECT_EQ(parsed["id"], question["id"]);
  return parsed;
}

constexpr std::array careful{Level::watertight, Level::precise, Level::exact};

bool is_nearest(const Rational& exact, double t) {
  const Rational error = abs(exact - Rational(t));
  return error <= abs(exact - Rational(std::nextafter(t, -INFINITY))) &&
         error <= abs(exact - Rational(std::nextafter(t, INFINITY)));
}

/// What a level promises of a number.
void expect_promised(const Rational& exact, const json& found, Level level) {
  ASSERT_TRUE(found.is_number()) << found;
  const auto t = found.get<double>();
  if (level == Level::exact) {
    EXPECT_TRUE(is_nearest(exact, t)) << t;
  } else {
    const Rational share(1, oracle::Integer(1) << (level == Level::watertight ? 46 : 52));
    EXPECT_LE(abs(exact - Rational(t)), share * abs(exact)) << t;
  }
}

Vec3d lattice_point(Random& random, int size) {
  const auto each = [&] { return static_cast<double>(random.below(static_cast<std::uint32_t>(2 * size + 1))) - size; };
  const double x = each(), y = each(), z = each();
  return {x, y, z};
}
Vec3d any_point(Random& random, double size) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return size * (2.0 * Vec3d(x, y, z) - 1.0);
}

/// On the lattice, where much coincides, and off it, from far and near.
Ray<double> any_ray(Random& random, int i) {
  const double scale = std::ldexp(1., i % 7 == 3 ? 64 : i % 7 == 5 ? -80 : 0);
  if (i % 3 == 0) return {any_point(random, 5), scale * any_point(random, 1)};
  const Vec3d origin = lattice_point(random, 4);
  Vec3d direction = lattice_point(random, 2);
  if (direction == Vec3d(0)) direction.z = 1;
  return {origin, scale * direction};
}

void expect_roots(const json& line, const std::vector<Rational>& coefficients, int& touching) {
  const json exact = asked(line, Level::exact);
  std::vector<oracle::FoundRoot> found;
  for (std::size_t i = 0; i < exact["roots"].size(); ++i) {
    found.push_back({exact["roots"][i], exact["multiplicity"][i]});
    touching += found.back().multiplicity > 1;
    ASSERT_TRUE(i == 0 || found[i - 1].nearest <= found[i].nearest);
  }
  ASSERT_TRUE(oracle::are_all_roots(coefficients, found)) << line << exact;
  const oracle::SturmChain chain(oracle::polynomial_of(coefficients));
  const auto behind = static_cast<std::size_t>(chain.count_to(0) - (chain.has_root(0) ? 1 : 0));
  for (const Level level : careful) {
    const json answer = asked(line, level);
    ASSERT_EQ(answer["multiplicity"], exact["multiplicity"]) << line;
    ASSERT_EQ(answer["roots"].size(), found.size()) << line;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double off = std::fabs(answer["roots"][i].get<double>() - found[i].nearest);
      ASSERT_LE(off, (level == Level::watertight ? 0x1p-45 : 0x1p-51) * std::fabs(found[i].nearest)) << line;
    }
    ASSERT_EQ(answer["t_first"], behind < found.size() ? answer["roots"][behind] : json()) << line << answer;
  }
}

std::vector<Rational> sphere_along(const ExactLine& line, const ExactVector& center, const Rational& radius) {
  const ExactVector away = line.origin - center;
  return {dot(away, away) - radius * radius, 2 * dot(away, line.direction), dot(line.direction, line.direction)};
}

TEST(Probe, SpheresHaveTheirRoots) {
  Random random(1);
  int touching = 0;
  for (int i = 0; i < 1500; ++i) {
    Ray<double> ray = any_ray(random, i);
    const Vec3d center = i % 4 == 0 ? any_point(random, 3) : lattice_point(random, 2);
    const double radius = i % 4 == 0 ? random.uniform_double() : random.below(4);
    if (i % 5 == 0) ray.origin = center + radius * Vec3d(0.28, 0.96, 0);  // on it, but for rounding
    const json line = question(ray, "sphere", {{"c", list(center)}, {"r", radius}});
    expect_roots(line, sphere_along(exact(ray), exact(center), Rational(radius)), touching);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(touching, 30);
}

/// Origins that are on the sphere exactly, though their squares are not doubles.
TEST(Probe, OriginsOnSpheresAreFirst) {
  for (const double n : {3., 101., 4097., 65537., 1000003., 16777259.}) {
    const double m = n - 1, x = n * n - m * m, y = 2 * n * m, r = n * n + m * m;
    int touching = 0;
    const Ray<double> ray{{x, y, 0}, {0.1, -0.7, 0.3}};
    expect_roots(question(ray, "sphere", {{"c", {0, 0, 0}}, {"r", r}}),
                 sphere_along(exact(ray), exact(Vec3d(0)), Rational(r)), touching);
    for (const Level level : careful) {
      const json sphere = asked(question(ray, "sphere", {{"c", {0, 0, 0}}, {"r", r}}), level);
      const json tree = asked(question(ray, "tree", {{"prim", "sphere"}, {"c", {0, 0, 0}}, {"r", r}}), level);
      EXPECT_EQ(sphere["t_first"], 0.) << n;
      EXPECT_EQ(tree["t_first"], 0.) << n;
    }
  }
}

TEST(Probe, ToriHaveTheirRoots) {
  Random random(2);
  int touching = 0;
  for (int i = 0; i < 700; ++i) {
    const Ray<double> ray = any_ray(random, i);
    const double major = i % 4 == 0 ? 2 * random.uniform_double() : random.below(5),
                 minor = i % 4 == 0 ? random.uniform_double() : random.below(4);
    const ExactLine line = exact(ray);
    const Rational major2 = Rational(major) * Rational(major), minor2 = Rational(minor) * Rational(minor);
    const auto& [o, d] = line;
    const Rational g[] = {dot(o, o) + major2 - minor2, 2 * dot(o, d), dot(d, d)};
    std::vector<Rational> coefficients(5);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) coefficients[a + b] += g[a] * g[b];
    }
    coefficients[0] -= 4 * major2 * (o.x * o.x + o.y * o.y);
    coefficients[1] -= 8 * major2 * (o.x * d.x + o.y * d.y);
    coefficients[2] -= 4 * major2 * (d.x * d.x + d.y * d.y);
    expect_roots(question(ray, "torus", {{"R", major}, {"r", minor}}), coefficients, touching);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(touching, 30);
}

TEST(Probe, BoxesAreClosed) {
  Random random(3);
  int hits = 0, corners = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray<double> ray = any_ray(random, i);
    const Vec3d a = i % 4 == 0 ? any_point(random, 3) : lattice_point(random, 2),
                b = i % 4 == 0 ? any_point(random, 3) : lattice_point(random, 2);
    const Vec3d lo = glm::min(a, b), hi = glm::max(a, b);
    const json line = question(ray, "box", {{"lo", list(lo)}, {"hi", list(hi)}});
    std::optional<Rational> enter, exit;
    bool is_hit = true;
    for (int axis = 0; axis < 3; ++axis) {
      const Rational o(ray.origin[axis]), d(ray.direction[axis]);
      if (d == 0) {
        is_hit = is_hit && Rational(lo[axis]) <= o && o <= Rational(hi[axis]);
        continue;
      }
      Rational in = (Rational(lo[axis]) - o) / d, out = (Rational(hi[axis]) - o) / d;
      if (in > out) std::swap(in, out);
      if (!enter || in > *enter) enter = in;
      if (!exit || out < *exit) exit = out;
    }
    is_hit = is_hit && *enter <= *exit;
    hits += is_hit;
    corners += is_hit && *enter == *exit;
    for (const Level level : careful) {
      const json answer = asked(line, level);
      ASSERT_EQ(answer["hit"], is_hit) << line << answer;
      if (!is_hit) {
        ASSERT_TRUE(answer["enter"].is_null() && answer["exit"].is_null() && answer["t_first"].is_null());
        continue;
      }
      expect_promised(*enter, answer["enter"], level);
      expect_promised(*exit, answer["exit"], level);
      ASSERT_EQ(answer["t_first"], *enter >= 0 ? answer["enter"] : *exit >= 0 ? answer["exit"] : json()) << line;
    }
    if (HasFailure()) FAIL() << "case " << i << ": " << line;
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(corners, 10);
}

TEST(Probe, MeshesTellAllTrianglesAtADistance) {
  Random random(4);
  std::size_t together = 0;
  for (int i = 0; i < 1000; ++i) {
    Ray<double> ray = any_ray(random, i);
    const MeshSeed seed = i % 4 == 0 ? folded(6, random, [&] { return any_point(random, 3); })
                                     : folded(6, random, [&] { return lattice_point(random, 2); });
    if (i % 4 == 0) ray.direction = seed.vertices[random.below(6)] - ray.origin;
    json vertices = json::array();
    for (const Vec3d& p : seed.vertices) vertices.push_back(list(p));
    const json line = question(ray, "mesh", {{"v", vertices}, {"f", seed.triangles}});
    const CrossingMap expected = expected_crossings(exact(ray), seed);
    for (const Level level : careful) {
      const json answer = asked(line, level);
      ASSERT_EQ(answer["t"].size(), expected.size());
      ASSERT_EQ(answer["t_first"], expected.empty() ? json() : answer["t"][0]);
      std::size_t k = 0;
      for (const auto& [t, triangles] : expected) {
        expect_promised(t, answer["t"][k], level);
        ASSERT_EQ(answer["tris"][k], triangles);
        together += triangles.size() > 1;
        ++k;
      }
    }
    if (HasFailure()) FAIL() << "case " << i << ": " << line;
  }
  EXPECT_GT(together, 300u);
}

// ---- Trees of planes: between two neighbours of all crossings, one point tells of all

struct FlatTree {
  json question;
  std::vector<std::pair<ExactVector, Rational>> planes;  ///< All that n . x <= w is asked of.
  std::function<bool(const ExactVector&)> is_inside;
};

FlatTree any_tree(Random& random, int depth) {
  FlatTree tree;
  if (depth == 0 || random.below(4) == 0) {
    if (random.below(3) == 0) {
      Vec3d n = lattice_point(random, 2);
      if (n == Vec3d(0)) n.x = 1;
      const double w = double(random.below(5)) - 2;
      tree.question = {{"prim", "half"}, {"n", list(n)}, {"w", w}};
      tree.planes = {{exact(n), Rational(w)}};
    } else {
      const Vec3d a = lattice_point(random, 2), b = lattice_point(random, 2);
      const Vec3d lo = glm::min(a, b), hi = glm::max(a, b);
      tree.question = {{"prim", "box"}, {"lo", list(lo)}, {"hi", list(hi)}};
      for (int axis = 0; axis < 3; ++axis) {
        Vec3d n(0);
        n[axis] = 1;
        tree.planes.push_back({exact(n), Rational(hi[axis])});
        tree.planes.push_back({exact(-n), Rational(-lo[axis])});
      }
    }
    tree.is_inside = [planes = tree.planes](const ExactVector& p) {
      for (const auto& [n, w] : planes) {
        if (dot(n, p) > w) return false;
      }
      return true;
    };
    return tree;
  }
  static constexpr std::array ops{"union", "inter", "diff", "xor", "compl"};
  const std::string op = ops[random.below(5)];
  std::vector<FlatTree> args;
  for (std::uint32_t count = op == "compl" ? 1 : 1 + random.below(3); count > 0; --count)
    args.push_back(any_tree(random, depth - 1));
  tree.question = {{"op", op}, {"args", json::array()}};
  for (const FlatTree& arg : args) {
    tree.question["args"].push_back(arg.question);
    tree.planes.insert(tree.planes.end(), arg.planes.begin(), arg.planes.end());
  }
  tree.is_inside = [op, args](const ExactVector& p) {
    bool is_inside = args[0].is_inside(p) != (op == "compl");
    for (std::size_t i = 1; i < args.size(); ++i) {
      const bool other = args[i].is_inside(p);
      is_inside = op == "union"   ? is_inside || other
                  : op == "inter" ? is_inside && other
                  : op == "diff"  ? is_inside && !other
                                  : is_inside != other;
    }
    return is_inside;
  };
  return tree;
}

TEST(Probe, TreesAreRegularisedSets) {
  Random random(5);
  std::size_t spans = 0, all = 0;
  for (int i = 0; i < 2000; ++i) {
    const FlatTree tree = any_tree(random, 3);
    const Ray<double> ray = any_ray(random, i);
    const ExactLine line = exact(ray);
    std::set<Rational> crossings;
    bool is_in_face = false;
    for (const auto& [n, w] : tree.planes) {
      const Rational slope = dot(n, line.direction), rise = w - dot(n, line.origin);
      if (slope != 0) crossings.insert(rise / slope);
      is_in_face |= slope == 0 && rise == 0;
    }
    if (is_in_face) continue;  // what is inside there, these points cannot tell
    std::vector<Rational> ends(crossings.begin(), crossings.end());
    const Rational unit = ends.empty() ? Rational(1) : ends.back() - ends.front() + 1;
    bool was_inside = false;
    std::vector<std::optional<Rational>> expected;  // without a number: infinite
    for (std::size_t k = 0; k <= ends.size(); ++k) {
      const Rational t = ends.empty()       ? Rational(0)
                         : k == 0           ? Rational(ends[0] - unit)
                         : k == ends.size() ? Rational(ends.back() + unit)
                                            : Rational((ends[k - 1] + ends[k]) / 2);
      const bool is_inside = tree.is_inside(line.origin + t * line.direction);
      if (is_inside != was_inside) expected.push_back(k == 0 ? std::nullopt : std::optional(ends[k - 1]));
      was_inside = is_inside;
    }
    if (was_inside) expected.push_back(std::nullopt);
    all += expected.size() == 2 && !expected[0] && !expected[1];
    for (const Level level : careful) {
      const json answer = asked(question(ray, "tree", tree.question), level);
      ASSERT_EQ(answer["intervals"].size() * 2, expected.size()) << question(ray, "tree", tree.question) << answer;
      json first;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const json found = answer["intervals"][k / 2][k % 2];
        if (!expected[k]) {
          ASSERT_EQ(found, k == 0 ? "-inf" : "inf");
          continue;
        }
        expect_promised(*expected[k], found, level);
        if (*expected[k] >= 0 && first.is_null()) first = found;
      }
      ASSERT_EQ(answer["t_first"], first);
      spans += answer["intervals"].size();
    }
    if (HasFailure()) FAIL() << "case " << i << ": " << question(ray, "tree", tree.question);
  }
  EXPECT_GT(spans, 1000u);
  EXPECT_GT(all, 10u);
}

TEST(Probe, FramesAreExactForQuarterTurns) {
  const json ball = {{"prim", "box"}, {"lo", {0, 0, 0}}, {"hi", {1, 2, 3}}};
  json turned = ball;
  turned["frame"] = {
      {"rotate", {{"axis", {0, 0, 5}}, {"degrees", 90}}}, {"translate", {0.1, 0, 0}}, {"scale", {2, 1, 1}}};
  const Ray<double> ray{{-5, 0.5, 1}, {1, 0, 0}};
  const json answer =
      asked(question(ray, "tree", {{"op", "union"}, {"args", {turned}}, {"frame", {{"translate", {1, 0, 0}}}}}),
            Level::exact);
  EXPECT_EQ(answer["intervals"].dump(), "[[4.1,6.1]]");
}

}  // namespace
}  // namespace sightline
