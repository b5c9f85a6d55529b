/// Frames, turns and bent rays at the edge of what they are defined for.

#include <array>
#include <cmath>

#include "sightline/math/random.h"
#include "sightline/math/slerp.h"
#include "sightline/render/scattering.h"
#include "sightline/scene/camera.h"
#include "tests/hard_cases/matrix_parts.h"
#include "tests/hard_cases/wide_vector.h"

namespace sightline::hard {
namespace {

// ---- mat-lookat

void ask_camera(Trial& trial, const Vec3d& way, const Vec3d& up) {
  const Camera camera = Camera::looking_at(Vec3d(0), way, up, 40, 4, 3);
  const std::string inputs = "towards " + vector_text(way) + ", up " + vector_text(up);
  // Rounding of 2^-51 beside a side that is no shorter than 2^-20, or is made anew (scene/camera.cpp): 2^-30 with all.
  const std::array axes{camera.forward, camera.right, camera.up};
  judge_frame(trial.of("Camera::looking_at"), axes, inputs, false, 0x1p-30);
  const bool looks_there = dot(unit(wide(camera.forward)), unit(wide(way))) > 1 - Wide(frame_bound);
  const bool is_right_hand = dot(cross(wide(camera.right), wide(camera.up)), wide(camera.forward)) < 0;
  trial.of("Camera::looking_at, its sides").decide(looks_there && is_right_hand, [&] {
    return Example{inputs, "forward along the way, right x up backward", vector_text(camera.right)};
  });
  const Vec3d forward = glm::normalize(way), right = glm::normalize(glm::cross(forward, up));
  judge_frame(trial.naive("normalize(forward x up)"), {forward, right, glm::cross(right, forward)}, inputs, false,
              0x1p-19);
}

void run_look_at(Trial& trial) {
  Random random(111);
  for (std::uint64_t i = 0, count = trial.count(2000); i < count; ++i) {
    Vec3d way = random_on_sphere(random);
    if (i % 4 == 0) way = Vec3d(0), way[static_cast<int>(i / 4 % 3)] = i % 8 == 0 ? 1 : -5;
    const double length = i % 5 == 0 ? 0x1p-600 : i % 5 == 1 ? 3 : 1;
    ask_camera(trial, way, (i % 2 == 0 ? 1 : -1) * length * way);
    ask_camera(trial, way, way + std::ldexp(1.0, -static_cast<int>(i % 70)) * random_on_sphere(random));
    ask_camera(trial, way, i % 3 == 0 ? Vec3d(0) : Vec3d(0, 1, 0));
  }
}

Sketch draw_look_at() {
  Sketch sketch{"A camera that looks straight up: forward and up are one direction, and to the right is anywhere.", {}};
  return sketch.polygon({{-0.5, -0.3}, {0.5, -0.3}, {0.5, 0.3}, {-0.5, 0.3}})
      .line({0, 0.3}, {0, 2}, Role::ray)
      .line({0.06, 0.3}, {0.06, 1.6}, Role::aid)
      .line({0.5, 0}, {1.7, 0}, Role::truth)
      .dot({0, 0}, Role::naive)
      .label({-1, 1.8}, "forward")
      .label({0.2, 1.4}, "up")
      .label({1.8, 0}, "an axis across, as close as may be", Role::truth)
      .label({-1.6, -0.7}, "forward x up = 0: normalized NaN", Role::naive);
}

// ---- slerp-antipodal

using WideQuat = std::array<Wide, 4>;

Wide inner(const WideQuat& a, const WideQuat& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
WideQuat wide_quat(const glm::dquat& q) { return {Wide(q.w), Wide(q.x), Wide(q.y), Wide(q.z)}; }
WideQuat unit_quat(const glm::dquat& q) {
  WideQuat made = wide_quat(q);
  const Wide length = sqrt(inner(made, made));
  for (Wide& x : made) x /= length;
  return made;
}

/// Shoemake's formula, the shorter way.
WideQuat slerp_truth(const glm::dquat& from, const glm::dquat& to, double share) {
  const WideQuat a = unit_quat(from);
  WideQuat b = unit_quat(to);
  if (inner(a, b) < 0) {
    for (Wide& x : b) x = -x;
  }
  const Wide cosine = inner(a, b);
  if (cosine >= 1) return a;
  const Wide angle = acos(cosine), first = sin((1 - Wide(share)) * angle), second = sin(Wide(share) * angle);
  WideQuat mixed;
  for (std::size_t i = 0; i < 4; ++i) mixed[i] = (a[i] * first + b[i] * second) / sin(angle);
  return mixed;
}

std::string quat_text(const glm::dquat& q) { return all_digits(q.w) + " + " + vector_text(Vec3d(q.x, q.y, q.z)); }

/// Up to the sign, which is no part of a rotation.
void judge_turn(Tally& tally, const glm::dquat& got, const WideQuat& truth, double bound, const std::string& inputs) {
  const bool is_sound = is_finite(Vec3d(got.x, got.y, got.z)) && std::isfinite(got.w);
  Wide off = is_sound ? 0 : 1;
  bool is_nearest = is_sound;
  for (std::size_t i = 0; is_sound && i < 4; ++i) {
    const WideQuat found = wide_quat(got);
    const Wide component = inner(found, truth) < 0 ? Wide(-truth[i]) : truth[i];
    is_nearest = is_nearest && found[i].convert_to<double>() == component.convert_to<double>();
    off = std::max<Wide>(off, abs(found[i] - component));
  }
  tally.add(is_nearest     ? Verdict::exact
            : off <= bound ? Verdict::within_bound
                           : Verdict::wrong,
            off.convert_to<double>(), [&] {
              return Example{inputs,
                             quat_text({truth[0].convert_to<double>(), truth[1].convert_to<double>(),
                                        truth[2].convert_to<double>(), truth[3].convert_to<double>()}),
                             quat_text(got)};
            });
}

glm::dquat naive_slerp(const glm::dquat& a, const glm::dquat& b, double share) {
  const double angle = std::acos(glm::dot(a, b));
  return a * (std::sin((1 - share) * angle) / std::sin(angle)) + b * (std::sin(share * angle) / std::sin(angle));
}

void run_slerp(Trial& trial) {
  Random random(112);
  for (std::uint64_t i = 0, count = trial.count(800); i < count; ++i) {
    const auto any = [&] {
      const Vec3d v = random_in_cube(random);
      return glm::normalize(glm::dquat(2 * random.uniform_double() - 1, v.x, v.y, v.z));
    };
    const glm::dquat q = any(), aside = any();
    // Antipodal, almost so by 2^-1 to 2^-60, and the same.
    glm::dquat to = i % 3 == 0 ? -q : -q + aside * std::ldexp(1.0, -static_cast<int>(1 + i % 60));
    if (i % 9 == 1) to = aside;
    if (i % 3 == 2) to = q + aside * std::ldexp(1.0, -static_cast<int>(1 + i % 60));
    const double share = i == 0 ? 0.5 : random.uniform_double();
    const std::string inputs = quat_text(q) + " to " + quat_text(to) + ", " + all_digits(share);
    const WideQuat truth = slerp_truth(q, to, share);
    const glm::dquat got = slerp(q, to, share);
    // Both ends are off by 6 roundings, the angle and the sines by as many (tests/math/slerp_test.cpp).
    judge_turn(trial.of("slerp"), got, truth, 0x1p-48, inputs);
    const bool is_same = got == slerp(-q, to, share) && got == slerp(q, -to, share) && got == slerp(-q, -to, share);
    trial.of("slerp, any signs").decide(is_same, [&] { return Example{inputs, "the same bits", "others"}; });
    judge_turn(trial.naive("acos of the dot product"), naive_slerp(q, to, share), truth, 0x1p-19, inputs);
  }
}

Sketch draw_slerp() {
  Sketch sketch{"Unit quaternions: q and -q are one rotation, half a circle apart.", {}};
  return sketch.circle({0, 0}, 1)
      .dot({0.8, 0.6})
      .dot({-0.8, -0.6})
      .line({-0.8, -0.6}, {0.8, 0.6}, Role::aid)
      .path({{0.8, 0.6}, {-0.6, 0.8}, {-0.8, -0.6}}, Role::naive)
      .label({0.9, 0.7}, "q")
      .label({-1.1, -0.8}, "-q")
      .label({0.9, 0.3}, "truth: stay", Role::truth)
      .label({-2.4, 1.1}, "sin(pi) = 1.2e-16: weights of 8e15", Role::naive);
}

// ---- refract-critical

/// What the true answer may be for a sin^2 beyond that is off by as much as its roundings: 1 - c^2 is off by one of c^2
/// and one of its own, the square of eta and the quotient by one each.
struct Bent {
  Wide cosine, least, most;
};
Bent bent(double cos_in, double eta) {
  const Wide c(cos_in), n(eta), beyond = (1 - c * c) / (n * n);
  const Wide off = (c * c / (n * n) + 4 * beyond) * 0x1p-53;
  const auto cosine = [](const Wide& sin2) { return sin2 >= 1 ? Wide(0) : Wide(sqrt(1 - sin2)); };
  return {cosine(beyond), cosine(beyond + off), cosine(beyond - off)};
}

Wide fresnel_truth(const Wide& cos_in, const Wide& eta, const Wide& cos_out) {
  const Wide across = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
  const Wide along = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
  return (across * across + along * along) / 2;
}

void judge_between(Tally& tally, double got, const Wide& truth, const Wide& a, const Wide& b, const Wide& slack,
                   const std::string& inputs) {
  const bool is_there = std::isfinite(got) && got >= std::min(a, b) - slack && got <= std::max(a, b) + slack;
  const bool is_nearest = got == truth.convert_to<double>();
  const double off = std::isfinite(got) ? static_cast<double>(Wide(abs(got - truth))) : 1;
  tally.add(is_nearest ? Verdict::exact
            : is_there ? Verdict::within_bound
                       : Verdict::wrong,
            off, [&] {
              return Example{inputs, all_digits(truth.convert_to<double>()), all_digits(got)};
            });
}

void run_refract(Trial& trial) {
  Random random(113);
  for (std::uint64_t i = 0, count = trial.count(3000); i < count; ++i) {
    const double eta = i % 4 == 0 ? 1 / 1.5 : 0.4 + 0.6 * random.uniform_double();
    const double critical = std::sqrt(1 - eta * eta);
    double cos_in = critical;
    for (int k = static_cast<int>(random.below(9)) - 4; k != 0; k += k > 0 ? -1 : 1) {
      cos_in = std::nextafter(cos_in, k > 0 ? 2 : -2);
    }
    if (i % 5 == 0) cos_in = random.uniform_double();
    const std::string inputs = "cosine " + all_digits(cos_in) + ", eta " + all_digits(eta);
    const Bent way = bent(cos_in, eta);
    const auto reflects = [&](const Wide& cos_out) { return fresnel_truth(cos_in, eta, cos_out); };
    // A dozen roundings of numbers up to 1 besides.
    judge_between(trial.of("fresnel"), fresnel(cos_in, eta), reflects(way.cosine), reflects(way.least),
                  reflects(way.most), 12 * 0x1p-53, inputs);
    const Vec3d view(std::sqrt(1 - cos_in * cos_in), 0, cos_in), out = refracted(view, {0, 0, 1}, eta);
    // c / eta is taken from c / eta, so that what they round is left.
    judge_between(trial.of("refracted"), -out.z, way.cosine, way.least, way.most, Wide(4 + 4 * cos_in / eta) * 0x1p-53,
                  inputs);
    const double side = -view.x / eta;
    trial.of("refracted, aside").decide(out.x == side && out.y == 0, [&] {
      return Example{inputs, all_digits(side), all_digits(out.x)};
    });
    const double sin2 = (1 - cos_in * cos_in) / (eta * eta), naive = cos_in < critical ? 0 : std::sqrt(1 - sin2);
    judge_between(trial.naive("the critical angle first, then the root"), naive, way.cosine, way.least, way.most,
                  0x1p-51, inputs);
  }
}

Sketch draw_refract() {
  Sketch sketch{"Light in glass at the critical angle: it leaves along the surface, or not at all.", {}};
  return sketch.line({-3, 0}, {3, 0}, Role::shape)
      .line({-1.34, -1.5}, {0, 0}, Role::ray)
      .line({0, 0}, {2.6, 0.03}, Role::truth)
      .line({0, 0}, {1.34, -1.5}, Role::truth)
      .line({0, -1.6}, {0, 1.2}, Role::aid)
      .label({-2.9, -0.3}, "glass")
      .label({0.4, 0.25}, "sin^2 = 1: cosine 0", Role::truth)
      .label({1.5, -1.3}, "all is reflected", Role::truth)
      .label({-2.9, 0.8}, "sin^2 = 1 + 2^-52: the root of -2^-52 is NaN", Role::naive);
}

}  // namespace

HardCase matrix_look_at() {
  return {.id = "mat-lookat",
          .group = "matrix",
          .inputs = "up along the direction, against it, of lengths to 2^-600, off it by 1 to 2^-69, and 0",
          .expected = "a frame at right angles that looks there; where up says nothing, an axis is across",
          .why =
              "forward x up is 0 where both are parallel, and normalizing it gives NaN for every ray. Next to it the "
              "product is all rounding: a frame that is finite, but leans, so that the picture is sheared.",
          .oracle = Oracle::closed_form,
          .reference = {},
          .is_policy = false,
          .run = run_look_at,
          .draw = draw_look_at};
}

HardCase slerp_antipodal() {
  return {
      .id = "slerp-antipodal",
      .group = "matrix",
      .inputs = "q to -q, to such as are off q and -q by 2^-1 to 2^-60, and to any, at any share of the way",
      .expected = "q and -q are one rotation: the way there is to stay; the same bits for any signs",
      .why =
          "The angle between q and -q is pi, and its sine, by which the weights are divided, is 1.2e-16: weights of "
          "8e15 that cancel to noise. Where the product rounds below -1 the arc cosine is NaN. And acos loses "
          "half the digits of all small angles.",
      .oracle = Oracle::closed_form,
      .reference = "Shoemake, Animating rotation with quaternion curves, 1985",
      .is_policy = false,
      .run = run_slerp,
      .draw = draw_slerp};
}

HardCase refract_critical() {
  return {
      .id = "refract-critical",
      .group = "matrix",
      .inputs = "cosines within four steps of double of the critical angle, and any; refractive indices of 0.4 to 1",
      .expected = "a share from 0 to 1 and a finite direction: that of some sin^2 which is off by its roundings",
      .why =
          "At the critical angle sin^2 is 1, or 1 + 2^-52 when rounded, and the root of -2^-52 is NaN. Testing the "
          "angle beforehand does not help: that test and the root round differently. What is below 0 has to be "
          "taken for 0 where the root is.",
      .oracle = Oracle::closed_form,
      .reference = {},
      .is_policy = false,
      .run = run_refract,
      .draw = draw_refract};
}

}  // namespace sightline::hard
