#pragma once
/// Where labels of a drawing go: near what they tell of, in the frame, apart from each other.

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::stability {

struct TextBox {
  glm::dvec2 lo{0}, hi{0};
};

/// A text, laid out: y down, in pixels.
struct PlacedLabel {
  std::vector<std::string> lines;
  TextBox box;
  double align = 0;  ///< Where lines are flush: 0 left, 0.5 middle, 1 right.
};

inline constexpr double label_size = 14, label_leading = 18;

/// An upper estimate for the usual sans-serif fonts; there is none of theirs to ask.
double text_width(std::string_view text, double size = label_size);

class LabelLayout {
 public:
  explicit LabelLayout(const glm::dvec2& frame) : frame_(frame) {}

  /// Points to keep clear of where that is possible, such as those along a line.
  void avoid(const glm::dvec2& point, double weight) { obstacles_.push_back({point, weight}); }
  PlacedLabel place(const glm::dvec2& at, const std::string& text);

 private:
  struct Obstacle {
    glm::dvec2 at;
    double weight;
  };
  double cost(const TextBox& box) const;

  glm::dvec2 frame_;
  std::vector<Obstacle> obstacles_;
  std::vector<TextBox> taken_;
};

}  // namespace sightline::stability
