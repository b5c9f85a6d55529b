#include "matrix_stack.h"

namespace {

/// What a check has the stack do, one after the other.
struct Step {
  std::int32_t kind = 0;  ///< 0 push, 1 pop, 2 translate, 3 scale, 4 rotate by a quarter.
  std::int32_t axis = 0, amount = 0;
};

student::Matrix matrix_of(const Step& step) {
  sightline::Vec3d along(step.kind == 3 ? 1.0 : 0.0);
  along[step.axis] = step.amount;
  if (step.kind == 2) return student::translation(along);
  if (step.kind == 3) return student::scaling(along);
  return student::rotation(step.axis, 0, step.amount < 0 ? -1 : 1);
}

/// The matrix after all steps; nothing where a pop() had nothing to bring back.
std::optional<student::Matrix> after(const std::vector<Step>& steps) {
  student::MatrixStack stack;
  try {
    for (const Step& step : steps) {
      if (step.kind == 0) {
        stack.push();
      } else if (step.kind == 1) {
        stack.pop();
      } else {
        stack.multiply(matrix_of(step));
      }
    }
  } catch (const sightline::labs::NotYet&) {
    throw;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
  return stack.current();
}

}  // namespace

void sightline::labs::offer(Service& service) {
  service.on("multiply", student::multiply);
  service.on("translation", student::translation);
  service.on("scaling", student::scaling);
  service.on("rotation", student::rotation);
  service.on("point", student::transform_point);
  service.on("direction", student::transform_direction);
  service.on("normal", student::transform_normal);
  service.on("stack", after);
  service.on("all", student::transform_all);
  service.on("work", [](const std::vector<student::Matrix>& chain, const std::vector<Vec3d>& points) {
    student::work = {};
    student::transform_all(chain, points);
    return student::work;
  });
  service.on("plant", [](int age) {
    student::MatrixStack stack;
    std::vector<student::Stroke> strokes;
    student::grow(stack, age, strokes);
    return strokes;
  });
}
