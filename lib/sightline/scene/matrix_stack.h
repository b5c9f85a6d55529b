#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "sightline/math/transform.h"

namespace sightline {

/// The transform from where one draws to the world, with those to come back to.
///   K1  What pop() brings back is what push() kept, bit for bit: nothing is undone by computing.
///   K2  Each step is done within what is current: it moves a thing before all steps that were taken earlier. So a
///       finger is placed by M_person * M_torso * M_arm * M_hand * M_finger, said in this order.
/// The inverse comes along, as the product of the steps' inverses. After Silicon Graphics' Iris GL, 1984, and OpenGL.
class MatrixStack {
 public:
  const Transform& current() const { return current_; }
  /// How many push() have not been followed by pop().
  std::size_t depth() const { return kept_.size(); }

  void push() { kept_.push_back(current_); }
  /// \throws std::logic_error where nothing is kept.
  void pop() {
    if (kept_.empty()) throw std::logic_error("MatrixStack: expected a push() for each pop()");
    current_ = kept_.back();
    kept_.pop_back();
  }

  void translate(const Vec3d& by) { multiply(Transform::translation(by)); }
  /// Counter-clockwise as seen from the axis' tip. \throws as Transform::rotation does.
  void rotate(const Vec3d& axis, double degrees) { multiply(Transform::rotation(axis, degrees)); }
  /// \throws as Transform::scaling does.
  void scale(const Vec3d& by) { multiply(Transform::scaling(by)); }
  void multiply(const Transform& step) { current_ = current_ * step; }

  /// Keeps the current transform until the end of a scope, however that is left.
  class Scope {
   public:
    explicit Scope(MatrixStack& stack) : stack_(stack), depth_(stack.depth()) { stack.push(); }
    ~Scope() {
      while (stack_.depth() > depth_) stack_.pop();
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    MatrixStack& stack_;
    std::size_t depth_;
  };
  [[nodiscard]] Scope scope() { return Scope(*this); }

 private:
  Transform current_;
  std::vector<Transform> kept_;
};

}  // namespace sightline
