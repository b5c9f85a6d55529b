/// Lab 00: what is asked of a student's first picture.

#include <algorithm>
#include <cmath>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/quadratic.h"
#include "sightline/math/ray.h"

namespace sightline::labs {
namespace {

/// As the student's file has it.
struct Ball {
  Vec3d center{0};
  double radius = 1;
};

using labs::text_of;
std::string text_of(const std::optional<double>& t) { return t ? "t = " + number(*t) : "no hit"; }

/// Whether a number is what it should be but for a few roundings of numbers as large as `size`.
bool is_close(double got, double expected, double size) { return std::fabs(got - expected) <= 0x1p-48 * size; }

// ---- Rays of pixels

Ray<double> true_camera_ray(int x, int y, int width, int height) {
  Ray<double> ray;
  ray.direction = {(2 * x + 1.0 - width) / height, (height - 2 * y - 1.0) / height, -1};
  return ray;
}

Check camera_check() {
  Check check{"camera-ray",
              "1. A ray through a pixel",
              "A picture that is upside down, mirrored, stretched or half a pixel off begins here.",
              {"Which pixel is (0, 0), and does y grow upward or downward in a picture?",
               "A ray goes through the middle of its pixel: add half a pixel before anything is divided.",
               "Pixels are square: both coordinates are divided by the same length."},
              {4, 0, 0, 9},
              200,
              false,
              {},
              {},
              {}};
  struct Pixel {
    int x, y, width, height;
  };
  const auto pixel_of = [](const Case& at) {
    const int width = 1 + std::abs(at.head[0]), height = 1 + std::abs(at.head[1]);
    return Pixel{std::abs(at.head[2]) % width, std::abs(at.head[3]) % height, width, height};
  };
  check.describe = [pixel_of](const Case& at) {
    const Pixel p = pixel_of(at);
    return "pixel (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ") of a picture of " +
           std::to_string(p.width) + " by " + std::to_string(p.height);
  };
  check.ask = [pixel_of](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Pixel p = pixel_of(at);
    const auto expected = true_camera_ray(p.x, p.y, p.width, p.height);
    const auto got = subject.ask<Ray<double>>("camera-ray", p.x, p.y, p.width, p.height);
    bool is_right = got.origin == expected.origin && got.direction.z == -1;
    for (int axis = 0; axis < 2; ++axis) is_right &= is_close(got.direction[axis], expected.direction[axis], 20);
    if (is_right) return std::nullopt;
    return Trouble{"from (0 0 0) along " + text_of(expected.direction),
                   "from " + text_of(got.origin) + " along " + text_of(got.direction)};
  };
  return check;
}

// ---- Rays and spheres

struct Meeting {
  Ray<double> ray;
  Ball ball;
};

Meeting meeting_of(const Case& at) {
  const auto vector = [&](std::size_t i) { return Vec3d(at.head[i], at.head[i + 1], at.head[i + 2]); };
  Meeting m{{vector(0), vector(3), 0, std::numeric_limits<double>::infinity()},
            {vector(6), double(1 + std::abs(at.head[9]))}};
  if (m.ray.direction == Vec3d(0)) m.ray.direction = {0, 0, 1};
  return m;
}

std::string describe(const Meeting& m) {
  return "ray from " + text_of(m.ray.origin) + " along " + text_of(m.ray.direction) + "\nball around " +
         text_of(m.ball.center) + " of radius " + number(m.ball.radius);
}

/// Of whole numbers: the discriminant is exact, so that a ray which touches is told from one that misses.
std::optional<double> true_hit(const Meeting& m) {
  const Vec3d from_center = m.ray.origin - m.ball.center;
  const auto a = glm::dot(m.ray.direction, m.ray.direction), b = glm::dot(from_center, m.ray.direction);
  const auto c = glm::dot(from_center, from_center) - m.ball.radius * m.ball.radius;
  const RootList roots = quadratic_roots(DoubleBall(a), DoubleBall(b), DoubleBall(c));
  for (int i = 0; i < roots.count; ++i) {
    const double t = roots.roots[static_cast<std::size_t>(i)].t;
    if (t > m.ray.t_min && t <= m.ray.t_max) return t;
  }
  return std::nullopt;
}

Drawing draw_meeting(const Meeting& m, const std::optional<double>& got) {
  SpacePanel panel;
  const auto point = [](const Vec3d& p) { return Point3{p.x, p.y, p.z}; };
  panel.balls.push_back({point(m.ball.center), m.ball.radius, Role::scene, -1, ""});
  const double far = (glm::distance(m.ray.origin, m.ball.center) + 2 * m.ball.radius) / glm::length(m.ray.direction);
  panel.lines.push_back({{point(m.ray.origin), point(m.ray.at(far))}, Role::ray, true, "ray"});
  if (const auto t = true_hit(m)) panel.dots.push_back({point(m.ray.at(*t)), Role::right, "expected"});
  if (got && std::isfinite(*got)) panel.dots.push_back({point(m.ray.at(*got)), Role::wrong, "got"});
  return {"A ray and a ball", "", {{"", std::move(panel)}}};
}

Check hit_check(std::string name, std::string why, std::vector<std::string> hints, const Recipe& recipe,
                Meeting (*meeting)(const Case&)) {
  Check check{std::move(name),
              "2. Where a ray meets a sphere",
              std::move(why),
              std::move(hints),
              recipe,
              600,
              false,
              {},
              {},
              {}};
  check.describe = [meeting](const Case& at) { return describe(meeting(at)); };
  check.ask = [meeting](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Meeting m = meeting(at);
    const auto expected = true_hit(m), got = subject.ask<std::optional<double>>("hit", m.ray, m.ball);
    if (!expected && !got) return std::nullopt;
    // Roots lose digits where the ray nearly touches; how many, the size of what is subtracted tells.
    const double reach = (glm::distance(m.ray.origin, m.ball.center) + m.ball.radius) / glm::length(m.ray.direction);
    if (expected && got && std::fabs(*got - *expected) <= 0x1p-40 * reach) return std::nullopt;
    return Trouble{text_of(expected), text_of(got)};
  };
  check.draw = [meeting](const Case& at, Subject& subject) {
    const Meeting m = meeting(at);
    return draw_meeting(m, subject.ask<std::optional<double>>("hit", m.ray, m.ball));
  };
  return check;
}

/// Rays that touch: along an axis, as far from the center as the radius.
Meeting touching_of(const Case& at) {
  const double radius = 1 + std::abs(at.head[0]), away = 1 + std::abs(at.head[1]);
  const Vec3d center(at.head[2], at.head[3], at.head[4]);
  return {{center + Vec3d(radius, 0, away), {0, 0, -1}, 0, std::numeric_limits<double>::infinity()}, {center, radius}};
}

/// Rays that begin within the ball, and on it.
Meeting inside_of(const Case& at) {
  Meeting m = meeting_of(at);
  m.ball.radius = 1 + std::fabs(glm::length(m.ray.origin - m.ball.center));
  const Vec3d from = m.ray.origin - m.ball.center;
  if (at.head[9] % 2 != 0 && (from.x == 0) + (from.y == 0) + (from.z == 0) >= 2) m.ball.radius = glm::length(from);
  if (m.ball.radius == 0) m.ball.radius = 1;
  m.ball.radius = std::ceil(m.ball.radius);
  return m;
}

// ---- Shading and the picture

Check normal_check() {
  Check check{"normal",
              "3. Which way a surface faces",
              "With normals of another length everything is too bright or too dark.",
              {"From the center to the point, at unit length."},
              {7, 0, 0, 9},
              100,
              false,
              {},
              {},
              {}};
  const auto ball_of = [](const Case& at) {
    return std::pair{Ball{Vec3d(at.head[0], at.head[1], at.head[2]), double(1 + std::abs(at.head[6]))}, [&] {
                       const Vec3d way(at.head[3], at.head[4], at.head[5]);
                       return way == Vec3d(0) ? Vec3d(0, 0, 1) : way;
                     }()};
  };
  const auto point_of = [](const Ball& ball, const Vec3d& way) {
    return ball.center + ball.radius / glm::length(way) * way;
  };
  check.describe = [=](const Case& at) {
    const auto [ball, way] = ball_of(at);
    return "ball around " + text_of(ball.center) + " of radius " + number(ball.radius) + ", at " +
           text_of(point_of(ball, way));
  };
  check.ask = [=](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto [ball, way] = ball_of(at);
    const Vec3d expected = glm::normalize(way), got = subject.ask<Vec3d>("normal", ball, point_of(ball, way));
    bool is_right = true;
    for (int axis = 0; axis < 3; ++axis) is_right &= is_close(got[axis], expected[axis], 16);
    if (is_right) return std::nullopt;
    return Trouble{text_of(expected), text_of(got)};
  };
  return check;
}

Check shade_check() {
  Check check{"shade",
              "4. Light",
              "A surface that faces away from the light is dark, not darker than dark.",
              {"The cosine of the angle between vectors of unit length is their dot product.",
               "What is it where the surface faces away, and what may it be?"},
              {2, 0, 0, 180},
              200,
              false,
              {},
              {},
              {}};
  const auto direction = [](int degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return Vec3d(std::sin(angle), 0, std::cos(angle));
  };
  check.describe = [](const Case& at) {
    return "a normal at " + std::to_string(at.head[0]) + " degrees, light from " + std::to_string(at.head[1]) +
           " degrees";
  };
  check.ask = [direction](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Vec3d normal = direction(at.head[0]), light = direction(at.head[1]);
    const double expected = std::max(0.0, glm::dot(normal, light)), got = subject.ask<double>("shade", normal, light);
    if (is_close(got, expected, 1)) return std::nullopt;
    return Trouble{number(expected), number(got)};
  };
  return check;
}

constexpr Ball balls[] = {{{0, 0, -3}, 1}, {{-1.6, -0.4, -4}, 0.7}, {{1.3, 0.5, -2.6}, 0.45}, {{0, -101, -3}, 100}};

double true_pixel(int x, int y, int width, int height) {
  const Ray<double> ray = true_camera_ray(x, y, width, height);
  double nearest = std::numeric_limits<double>::infinity(), brightness = 0.05;
  for (const Ball& ball : balls) {
    const auto t = true_hit({ray, ball});
    if (!t || *t >= nearest) continue;
    nearest = *t;
    const Vec3d normal = (ray.at(*t) - ball.center) / ball.radius;
    brightness = std::max(0.0, glm::dot(normal, glm::normalize(Vec3d(0.5, 1, 0.7))));
  }
  return brightness;
}

constexpr int picture_width = 320, picture_height = 240;

ImagePanel image_of(const std::vector<double>& pixels) {
  ImagePanel image{picture_width, picture_height, {}};
  for (const double light : pixels) {
    const double screen = std::pow(std::clamp(light, 0.0, 1.0), 1 / 2.2);
    image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(std::lround(255 * screen)));
  }
  return image;
}

std::vector<double> true_picture() {
  std::vector<double> pixels;
  for (int y = 0; y < picture_height; ++y) {
    for (int x = 0; x < picture_width; ++x) pixels.push_back(true_pixel(x, y, picture_width, picture_height));
  }
  return pixels;
}

std::vector<double> picture_by(Subject& subject) {
  auto pixels = subject.ask<std::vector<double>>("picture", picture_width, picture_height);
  if (pixels.size() != std::size_t(picture_width) * picture_height) {
    throw SubjectTrouble(SubjectTrouble::Kind::nonsense, std::to_string(pixels.size()) + " pixels");
  }
  return pixels;
}

Check picture_check() {
  Check check{"picture",
              "5. The nearest one",
              "Of everything that a ray meets, what lies nearest is seen, in whatever order it is asked.",
              {"Look at the picture: which ball covers which, and which should?",
               "Keep the smallest t so far. The ray's t_max is the place for it."},
              {},
              1,
              false,
              {},
              {},
              {}};
  check.describe = [](const Case&) { return "four balls in a picture of 320 by 240"; };
  check.ask = [](const Case&, Subject& subject) -> std::optional<Trouble> {
    const auto got = picture_by(subject), expected = true_picture();
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      // Silhouettes of the floor, a ball of radius 100, lose digits.
      if (std::fabs(got[i] - expected[i]) <= 0x1p-30) continue;
      if (wrong++ == 0) first = i;
    }
    if (wrong == 0) return std::nullopt;
    const std::string at =
        "(" + std::to_string(first % picture_width) + ", " + std::to_string(first / picture_width) + ")";
    return Trouble{number(expected[first]) + " at pixel " + at,
                   number(got[first]) + ", and " + std::to_string(wrong - 1) + " other pixels differ"};
  };
  check.draw = [](const Case&, Subject& subject) {
    return Drawing{"The picture", "", {{"expected", image_of(true_picture())}, {"got", image_of(picture_by(subject))}}};
  };
  return check;
}

}  // namespace

Lab first_picture_lab() {
  Lab lab{"00", "first-picture", "First picture", {"sphere.h"}, {}, {}, ""};
  lab.checks = {camera_check(),
                hit_check("hit", "Everything round in a picture is this function.",
                          {"Put o + t d into |p - c|^2 = r^2 and sort by powers of t.",
                           "Both roots count: where the nearer one is not in the ray's range, the farther one may be."},
                          {10, 0, 0, 9}, meeting_of),
                hit_check("inside", "A camera, or a reflected ray, may begin within a ball, or on it.",
                          {"A root that is not larger than t_min does not count, and then the other one may."},
                          {10, 0, 0, 9}, inside_of),
                hit_check("touch", "A ray that just touches the ball meets it once: there the discriminant is 0.",
                          {"Is a discriminant of 0 a hit?"}, {5, 0, 0, 9}, touching_of),
                normal_check(),
                shade_check(),
                picture_check()};
  lab.picture = [](Subject& subject) {
    return Drawing{
        "First picture", "Four balls, one light: every pixel a ray of yours.", {{"", image_of(picture_by(subject))}}};
  };
  return lab;
}

}  // namespace sightline::labs
