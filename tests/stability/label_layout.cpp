#include "tests/stability/label_layout.h"

#include <algorithm>
#include <array>
#include <limits>

#include "tests/stability/text.h"

namespace sightline::stability {
namespace {

constexpr double border = 4;  // between the frame and a label

double overlap(const TextBox& a, const TextBox& b) {
  const double x = std::min(a.hi.x, b.hi.x) - std::max(a.lo.x, b.lo.x);
  const double y = std::min(a.hi.y, b.hi.y) - std::max(a.lo.y, b.lo.y);
  return x > 0 && y > 0 ? x * y : 0;
}

/// As few lines as `width` allows, and of these the narrowest.
std::vector<std::string> balanced(std::string_view text, double width) {
  const double per_character = text_width(text) / static_cast<double>(std::max<std::size_t>(1, width_of(text)));
  std::size_t most = std::max<std::size_t>(1, static_cast<std::size_t>(width / per_character));
  auto lines = wrapped(text, most);
  for (auto narrower = lines; most > 1 && narrower.size() <= lines.size(); narrower = wrapped(text, --most)) {
    lines = narrower;
  }
  return lines;
}

std::vector<std::string> lines_of(const std::string& text, double width) {
  if (text.find('\n') == std::string::npos && text_width(text) <= width) return {text};
  std::vector<std::string> lines;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const auto own = balanced(std::string_view(text).substr(start, end - start), width);
    lines.insert(lines.end(), own.begin(), own.end());
    start = end + 1;
  }
  return lines;
}

}  // namespace

double text_width(std::string_view text, double size) {
  double ems = 0;
  for (const char c : text) {
    if ((c & 0xc0) == 0x80) continue;
    if (static_cast<unsigned char>(c) >= 0x80) {
      ems += 0.86;
    } else if (std::string_view("ijl.,:;'|!()[] ").find(c) != std::string_view::npos) {
      ems += 0.4;
    } else if (std::string_view("mwMW@%").find(c) != std::string_view::npos) {
      ems += 1;
    } else {
      ems += c >= 'A' && c <= 'Z' ? 0.78 : std::string_view("+=<>~").find(c) != std::string_view::npos ? 0.84 : 0.645;
    }
  }
  return ems * size;
}

double LabelLayout::cost(const TextBox& box) const {
  double sum = 0;
  for (const TextBox& other : taken_) sum += overlap(box, other);
  for (const auto& [at, weight] : obstacles_) {
    if (at.x > box.lo.x && at.x < box.hi.x && at.y > box.lo.y && at.y < box.hi.y) sum += weight;
  }
  return sum;
}

PlacedLabel LabelLayout::place(const glm::dvec2& at, const std::string& text) {
  // Of all sides of the point, nearer ones and those beside it first; x and y: where the box lies, from -1 to 1.
  constexpr std::array<glm::dvec2, 8> sides{{{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}};
  PlacedLabel best{lines_of(text, 0.66 * frame_.x), {}, 0};
  double width = 0, least = std::numeric_limits<double>::infinity();
  for (const std::string& line : best.lines) width = std::max(width, text_width(line));
  const glm::dvec2 size(std::min(width, frame_.x - 2 * border), label_leading * static_cast<double>(best.lines.size()));
  for (const double distance : {8.0, 18.0, 32.0, 52.0}) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const glm::dvec2 reach = sides[i] * (0.5 * size + distance);
      const glm::dvec2 room = frame_ - size - border;
      const glm::dvec2 wish = at + reach - 0.5 * size;
      const glm::dvec2 lo(std::clamp(wish.x, border, std::max(border, room.x)),
                          std::clamp(wish.y, border, std::max(border, room.y)));
      const TextBox box{lo, lo + size};
      const double own = cost(box) + 2 * distance + 3 * static_cast<double>(i);
      if (own >= least) continue;
      least = own;
      best.box = box;
      best.align = 0.5 - 0.5 * sides[i].x;
    }
  }
  taken_.push_back(best.box);
  return best;
}

}  // namespace sightline::stability
