/// Lab 03: what is asked of a student's normal mapping.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/texture/normal_map.h"

namespace sightline::labs {
namespace {

/// Whole numbers up to 9 make vectors whose angle has a sine above 2^-14 where it is not 0, and so much is what taking
/// the part along a normal away may cancel: of 2^-53, with a few roundings, 2^-36 is left.
std::optional<Trouble> compare(const Vec3d& got, const Vec3d& expected) {
  if (max_norm(got - expected) <= 0x1p-36) return std::nullopt;
  return Trouble{text_of(expected), text_of(got)};
}

Vec3d vector_of(const Case& at, std::size_t first) { return {at.head[first], at.head[first + 1], at.head[first + 2]}; }
Vec3d unit_of(const Case& at, std::size_t first) {
  const Vec3d v = vector_of(at, first);
  return v == Vec3d(0) ? Vec3d(0, 0, 1) : glm::normalize(v);
}

Check make_check(std::string name, std::string section, std::string why, std::vector<std::string> hints, int head,
                 int range) {
  return {std::move(name),
          std::move(section),
          std::move(why),
          std::move(hints),
          {head, 0, 0, range},
          300,
          false,
          {},
          {},
          {}};
}

Check decode_check() {
  Check check =
      make_check("decode", "1. A color is a direction",
                 "Normals of another length make the surface too bright or too dark, and speckled.",
                 {"0 is -1, 255 is 1: which line goes through both?", "Eight bits round: normalize."}, 3, 255);
  check.describe = [](const Case& at) {
    return "red, green, blue " + std::to_string(std::abs(at.head[0])) + ", " + std::to_string(std::abs(at.head[1])) +
           ", " + std::to_string(std::abs(at.head[2]));
  };
  check.ask = [](const Case& at, Subject& subject) {
    const int r = std::abs(at.head[0]), g = std::abs(at.head[1]), b = std::abs(at.head[2]);
    const Vec3d odd(2 * r - 255, 2 * g - 255, 2 * b - 255);  // never 0
    return compare(subject.ask<Vec3d>("decode", r, g, b), odd / std::sqrt(glm::dot(odd, odd)));
  };
  return check;
}

struct Patch {
  std::array<Vec3d, 3> corners;
  std::array<glm::dvec2, 3> uv;
  Vec3d n;

  /// Whether u has a direction beside n.
  bool is_good(const Case& at) const {
    const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const Vec3d du = b.y * (corners[1] - corners[0]) - a.y * (corners[2] - corners[0]);
    const Vec3d along = vector_of(at, 6) == Vec3d(0) ? Vec3d(0, 0, 1) : vector_of(at, 6);
    return a.x * b.y != a.y * b.x && glm::cross(du, along) != Vec3d(0);  // exact
  }
};

Patch patch_of(const Case& at) {
  const auto uv = [&](std::size_t i) { return glm::dvec2(at.head[i], at.head[i + 1]); };
  return {{Vec3d(0), vector_of(at, 0), vector_of(at, 3)}, {glm::dvec2(0), uv(9), uv(11)}, unit_of(at, 6)};
}

Check tangent_check() {
  Check check =
      make_check("tangent", "2. Which way u grows", "With a tangent that is turned, bumps are lit from the wrong side.",
                 {"Solve edge1 = a.x T + a.y B, edge2 = b.x T + b.y B for T, up to its length.",
                  "The determinant's sign decides between T and -T.", "Take the part along n away, then normalize."},
                 13, 9);
  check.describe = [](const Case& at) {
    const Patch p = patch_of(at);
    std::string text = "normal " + text_of(p.n);
    for (std::size_t i = 0; i < 3; ++i) {
      text += "\ncorner " + text_of(p.corners[i]) + " at u = " + number(p.uv[i].x) + ", v = " + number(p.uv[i].y);
    }
    return text;
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Patch p = patch_of(at);
    if (!p.is_good(at)) return std::nullopt;
    return compare(subject.ask<Vec3d>("tangent", p.corners, p.uv, p.n), triangle_frame(p.n, p.corners, p.uv).tangent);
  };
  check.draw = [](const Case& at, Subject& subject) {
    const Patch p = patch_of(at);
    const auto point = [](const Vec3d& v) { return Point3{v.x, v.y, v.z}; };
    const auto arrow = [&](const Vec3d& v, Role role, const char* label) {
      return SpacePanel::Line{{point(Vec3d(0)), point(v)}, role, true, label};
    };
    SpacePanel panel;
    panel.triangles.push_back({{point(p.corners[0]), point(p.corners[1]), point(p.corners[2])}, Role::scene, ""});
    panel.lines = {arrow(p.n, Role::ray, "normal"),
                   arrow(triangle_frame(p.n, p.corners, p.uv).tangent, Role::right, "expected"),
                   arrow(subject.ask<Vec3d>("tangent", p.corners, p.uv, p.n), Role::wrong, "got")};
    return Drawing{"The way in which u grows", "", {{"", std::move(panel)}}};
  };
  return check;
}

Check bitangent_check() {
  Check check = make_check(
      "bitangent", "3. Left hands", "On the mirrored half of a face, dents become bumps.",
      {"x cross y = z, y cross z = x, z cross x = y: which two give the bitangent?", "Mirrored: the other way."}, 2, 2);
  const auto axes = [](const Case& at) {
    Vec3d n(0), t(0);
    n[std::abs(at.head[0])] = 1;
    t[(std::abs(at.head[0]) + 1 + std::abs(at.head[1]) % 2) % 3] = 1;
    return std::array{n, t};
  };
  check.describe = [axes](const Case& at) {
    return "normal " + text_of(axes(at)[0]) + ", tangent " + text_of(axes(at)[1]) +
           (at.head[1] < 0 ? ", mirrored" : "");
  };
  check.ask = [axes](const Case& at, Subject& subject) {
    const auto [n, t] = axes(at);
    const double sign = (std::abs(at.head[1]) % 2 == 0) == (at.head[1] < 0) ? -1 : 1;
    const Vec3d third = sign * (Vec3d(1) - n - t);
    return compare(subject.ask<Vec3d>("bitangent", n, t, at.head[1] < 0), third);
  };
  return check;
}

Check world_check() {
  Check check = make_check("to-world", "4. Into space", "Every lit pixel goes through this.",
                           {"x along the tangent, y along the bitangent, z along the normal."}, 12, 9);
  check.describe = [](const Case& at) {
    return text_of(vector_of(at, 0)) + " with tangent " + text_of(vector_of(at, 3)) + ", bitangent " +
           text_of(vector_of(at, 6)) + ", normal " + text_of(vector_of(at, 9));
  };
  check.ask = [](const Case& at, Subject& subject) {
    const Vec3d v = vector_of(at, 0), t = vector_of(at, 3), b = vector_of(at, 6), n = vector_of(at, 9);
    Vec3d expected;
    for (int k = 0; k < 3; ++k) expected[k] = glm::dot(v, Vec3d(t[k], b[k], n[k]));  // exact: whole numbers
    return compare(subject.ask<Vec3d>("to-world", v, t, b, n), expected);
  };
  return check;
}

Check heights_check() {
  Check check = make_check("heights", "5. From heights to normals",
                           "With a sign turned, hills look like holes; without wrapping, tiles show their seams.",
                           {"The normal of z = h(x, y) leans away from where h grows: (-dh/dx, -dh/dy, 1).",
                            "Central differences are over two units.", "Left of column 0 lies the last column."},
                           14, 9);
  const auto place = [](const Case& at) { return std::array{std::abs(at.head[12]) % 4, std::abs(at.head[13]) % 3}; };
  check.describe = [place](const Case& at) {
    std::string text = "at x = " + std::to_string(place(at)[0]) + ", y = " + std::to_string(place(at)[1]) + " of";
    for (int i = 0; i < 12; ++i) text += (i % 4 == 0 ? "\n" : " ") + std::to_string(at.head[std::size_t(i)]);
    return text;
  };
  check.ask = [place](const Case& at, Subject& subject) {
    const auto [x, y] = place(at);
    const auto h = [&](int i, int j) { return at.head[std::size_t(j % 3 * 4 + i % 4)]; };
    const Vec3d twice(h(x + 3, y) - h(x + 1, y), h(x, y + 2) - h(x, y + 1), 2);
    const std::vector<double> heights(at.head.begin(), at.head.begin() + 12);
    return compare(subject.ask<Vec3d>("heights", heights, 4, x, y), twice / std::sqrt(glm::dot(twice, twice)));
  };
  return check;
}

Check facing_check() {
  Check check = make_check("facing", "6. Normals that face away",
                           "Normals that face away from the viewer make black spots along silhouettes.",
                           {"The dot product tells on which side n is.",
                            "Take away twice the part along the viewer's direction; -n would turn the bumps around."},
                           6, 9);
  check.describe = [](const Case& at) {
    return "normal " + text_of(unit_of(at, 0)) + ", viewer in direction " + text_of(unit_of(at, 3));
  };
  check.ask = [](const Case& at, Subject& subject) {
    const Vec3d n = unit_of(at, 0), v = unit_of(at, 3);
    const double cosine = glm::dot(n, v);
    return compare(subject.ask<Vec3d>("facing", n, v), n + (std::fabs(cosine) - cosine) * v);
  };
  return check;
}

}  // namespace

Lab normal_mapping_lab() {
  Lab lab{"03", "normal-mapping", "Normal mapping", {"normal_map.h"}, {}, {}, ""};
  lab.checks = {decode_check(), tangent_check(), bitangent_check(), world_check(), heights_check(), facing_check()};
  lab.picture = [](Subject& subject) {
    constexpr int size = 256;
    std::vector<double> heights;
    for (int i = 0; i < size * size; ++i) {
      const double x = i % size * 0x1p-5, y = i / size * 0x1p-5, turn = 6.283185307179586 / 2;
      heights.push_back(8 * std::fabs(std::sin(turn * x) * std::sin(turn * y)));
    }
    const auto pixels = subject.ask<std::vector<double>>("picture", heights, size);
    if (pixels.size() != heights.size()) {
      throw SubjectTrouble(SubjectTrouble::Kind::nonsense, std::to_string(pixels.size()) + " pixels");
    }
    ImagePanel image{size, size, {}};
    for (const double light : pixels) {
      image.bytes.insert(image.bytes.end(), 3,
                         static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(light, 0.0, 1.0)))));
    }
    return Drawing{"Normal mapping", "A flat square: only its normals are not.", {{"", std::move(image)}}};
  };
  return lab;
}

}  // namespace sightline::labs
