#include "labs/04-csg/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "labs/04-csg/true_spans.h"
#include "sightline/csg/evaluator.h"

namespace sightline::labs::csg {
namespace {

constexpr int width = 240, height = 180;

/// From above and to the right of the die, toward its middle.
std::vector<Ray<double>> camera_rays() {
  const Vec3d eye(3.2, 2.5, 4.3), forward = glm::normalize(-eye);
  const Vec3d right = glm::normalize(glm::cross(forward, Vec3d(0, 1, 0))), up = glm::cross(right, forward);
  std::vector<Ray<double>> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double across = (2 * x + 1.0 - width) / height * 0.33, along = (height - 2 * y - 1.0) / height * 0.33;
      rays.push_back({eye, forward + across * right + along * up});
    }
  }
  return rays;
}

/// The student's die_spans, of our own solids; materials are the surfaces' numbers.
Solid true_die() {
  const auto part = [](auto shape, const char* surface) {
    SolidTree tree(shape);
    tree.material = surface;
    return tree;
  };
  SolidTree die = part(solid::Box{Vec3d(-1), Vec3d(1)}, "0") & part(solid::Sphere{Vec3d(0), 1.38}, "1");
  die = std::move(die) - part(solid::Box{{-2, -0.35, -0.35}, {2, 0.35, 0.35}}, "2");
  die = std::move(die) - part(solid::Box{{-0.35, -2, -0.35}, {0.35, 2, 0.35}}, "2");
  die = std::move(die) - part(solid::Box{{-0.35, -0.35, -2}, {0.35, 0.35, 2}}, "2");
  return Solid(std::move(die) | part(solid::Sphere{Vec3d(0), 0.55}, "3"));
}

using Hits = std::vector<std::optional<Boundary>>;

Hits true_hits() {
  const Solid die = true_die();
  NoSolidProbe silent;
  Hits hits;
  for (const Ray<double>& ray : camera_rays()) {
    const auto first =
        SolidEvaluator<Level::watertight>(die, ray, silent).first(0, std::numeric_limits<double>::infinity());
    if (!first) {
      hits.emplace_back();
      continue;
    }
    const auto material = die.primitives()[first->primitive].material;
    hits.push_back(Boundary{first->t, die.materials()[material].front() - '0', first->is_flipped});
  }
  return hits;
}

Hits hits_by(Subject& subject) {
  auto hits = subject.ask<Hits>("die", camera_rays());
  if (hits.size() != std::size_t(width) * height) {
    throw SubjectTrouble(SubjectTrouble::Kind::nonsense, std::to_string(hits.size()) + " pixels");
  }
  return hits;
}

/// Of the surface with this number, outward of its own primitive.
Vec3d normal_of(int surface, const Vec3d& p) {
  if (surface == 1 || surface == 3) return glm::normalize(p);
  // Of a box: the axis on which the point is nearest to a face.
  const double face = surface == 0 ? 1 : 0.35;
  int nearest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::fabs(std::fabs(p[axis]) - face) < std::fabs(std::fabs(p[nearest]) - face)) nearest = axis;
  }
  Vec3d normal(0);
  normal[nearest] = std::copysign(1.0, p[nearest]);
  return normal;
}

ImagePanel image_of(const Hits& hits) {
  // Of Okabe and Ito: cube, ball, walls of the holes, core.
  constexpr double colors[4][3] = {{0.34, 0.71, 0.91}, {0.90, 0.62, 0.0}, {0.85, 0.85, 0.88}, {0.84, 0.37, 0.0}};
  const Vec3d to_light = glm::normalize(Vec3d(0.5, 1, 0.8));
  const auto rays = camera_rays();
  ImagePanel image{width, height, {}};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i] || !std::isfinite(hits[i]->t)) {
      image.bytes.insert(image.bytes.end(), 3, 245);
      continue;
    }
    const int surface = std::clamp(hits[i]->surface, 0, 3);
    const Vec3d normal = (hits[i]->is_flipped != 0 ? -1.0 : 1.0) * normal_of(surface, rays[i].at(hits[i]->t));
    const double light = 0.18 + 0.82 * std::max(0.0, glm::dot(normal, to_light));
    for (const double component : colors[surface]) {
      image.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::pow(light * component, 1 / 2.2))));
    }
  }
  return image;
}

}  // namespace

ImagePanel picture_by(Subject& subject) { return image_of(hits_by(subject)); }
ImagePanel true_picture() { return image_of(true_hits()); }

std::size_t wrong_pixels(Subject& subject) {
  const Hits got = hits_by(subject), expected = true_hits();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    bool is_right = got[i].has_value() == expected[i].has_value();
    // Roots in double differ by some roundings between ways to compute them.
    if (is_right && got[i]) {
      is_right = std::fabs(got[i]->t - expected[i]->t) <= 0x1p-40 && got[i]->surface == expected[i]->surface &&
                 got[i]->is_flipped == expected[i]->is_flipped;
    }
    wrong += !is_right;
  }
  return wrong;
}

}  // namespace sightline::labs::csg
