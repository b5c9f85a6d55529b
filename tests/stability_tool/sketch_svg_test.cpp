#include "tests/stability/sketch_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "tests/stability/label_layout.h"
#include "tests/stability_tool/fake_table.h"

namespace sightline::stability {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

double attribute(const std::string& svg, const std::string& element, const std::string& name) {
  std::smatch match;
  const std::regex pattern("<" + element + " [^>]*\\b" + name + "=\"([-0-9.]+)\"");
  if (!std::regex_search(svg, match, pattern)) throw std::runtime_error("no " + element + " with " + name);
  return std::stod(match[1]);
}

/// Numbers of the first path's d.
std::vector<double> path_numbers(const std::string& svg) {
  const std::size_t start = svg.find(" d=\"") + 4, end = svg.find('"', start);
  std::vector<double> numbers;
  const std::string d = svg.substr(start, end - start);
  const std::regex number("-?[0-9.]+");
  for (std::sregex_iterator it(d.begin(), d.end(), number), last; it != last; ++it)
    numbers.push_back(std::stod(it->str()));
  return numbers;
}

TEST(SketchSvg, ScalesTheSameInXAndYWithYUp) {
  for (const double size : {1e-30, 1.0, 1e30}) {
    Sketch sketch;
    sketch.rectangle({size, 2 * size}, {3 * size, 3 * size});
    const auto p = path_numbers(svg_of(sketch));
    ASSERT_EQ(p.size(), 8u);
    const double width = p[2] - p[0], height = p[1] - p[5];
    EXPECT_GT(width, 300);
    EXPECT_NEAR(height, width / 2, 0.02);  // hundredths of a pixel are kept
    EXPECT_GT(p[1], p[5]) << "the lower edge is below";
  }
}

TEST(SketchSvg, KeepsEverythingInTheFrame) {
  Sketch sketch;
  sketch.circle({5, 5}, 3).line({-100, 0}, {0, 2000}, Role::ray);
  const std::string svg = svg_of(sketch);
  const double width = attribute(svg, "svg", "width"), height = attribute(svg, "svg", "height");
  const auto p = path_numbers(svg);
  for (std::size_t i = 0; i < p.size(); i += 2) {
    EXPECT_GE(p[i], 0);
    EXPECT_LE(p[i], width);
    EXPECT_GE(p[i + 1], 0);
    EXPECT_LE(p[i + 1], height);
  }
  EXPECT_GE(attribute(svg, "circle", "r"), 0.5) << "never too small to be seen";
}

TEST(SketchSvg, DrawsWhatHasNoExtent) {
  Sketch dot, line, nothing;
  dot.dot({1e20, -3});
  line.line({0, 5}, {9, 5}, Role::aid);
  for (const Sketch* sketch : {&dot, &line, &nothing}) {
    const std::string svg = svg_of(*sketch);
    EXPECT_GT(attribute(svg, "svg", "height"), 100);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
  EXPECT_EQ(attribute(svg_of(dot), "circle", "cx"), attribute(svg_of(dot), "svg", "width") / 2);
}

TEST(SketchSvg, LeavesOutWhatIsNotFinite) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Sketch sketch, same;
  sketch.line({0, 0}, {1, 1}, Role::ray).path({{0, 0}, {nan, 1}, {1, 1}}).circle({0, 0}, inf).circle({nan, 0}, 1);
  sketch.dot({inf, 0}).label({0, -inf}, "nowhere");
  same.line({0, 0}, {1, 1}, Role::ray).path({{0, 0}, {1, 1}});
  EXPECT_EQ(svg_of(sketch), svg_of(same));
}

TEST(SketchSvg, EscapesText) {
  Sketch sketch{"a < b & c", {}};
  sketch.label({0, 0}, "<script>\"x\"</script>");
  for (const bool has_caption : {true, false}) {
    const std::string svg = svg_of(sketch, has_caption);
    EXPECT_EQ(svg.find("<script>"), std::string::npos);
    EXPECT_NE(svg.find("&lt;script&gt;&quot;x&quot;&lt;/script&gt;"), std::string::npos);
    EXPECT_EQ(svg.find("a < b"), std::string::npos);
    EXPECT_EQ(count(svg, "a &lt; b &amp; c"), has_caption ? 2u : 1u) << "the title, and the caption where wanted";
  }
}

TEST(SketchSvg, LegendHasTheRolesThatAreUsed) {
  Sketch sketch;
  sketch.circle({0, 0}, 1).dot({1, 0}, Role::naive).label({0, 0}, "a note", Role::ray);
  const std::string svg = svg_of(sketch), legend = svg.substr(svg.find("class=\"legend\""));
  EXPECT_NE(legend.find(">shape<"), std::string::npos);
  EXPECT_NE(legend.find(">naive code<"), std::string::npos);
  for (const char* other : {">ray<", ">true<", ">for orientation<"}) EXPECT_EQ(legend.find(other), std::string::npos);
}

TEST(SketchSvg, RolesDifferInMoreThanColor) {
  constexpr std::array roles{Role::shape, Role::ray, Role::truth, Role::naive, Role::aid};
  for (const Role a : roles) {
    EXPECT_EQ(look_of(a).role, a);
    for (const Role b : roles) {
      if (a == b) continue;
      EXPECT_NE(look_of(a).color, look_of(b).color);
      EXPECT_NE(std::pair(look_of(a).width, look_of(a).dashes), std::pair(look_of(b).width, look_of(b).dashes));
    }
  }
}

TEST(SketchSvg, RaysEndInArrows) {
  Sketch ray, aid, still;
  ray.line({0, 0}, {1, 0}, Role::ray);
  aid.line({0, 0}, {1, 0}, Role::aid);
  still.line({0, 0}, {0, 0}, Role::ray);
  EXPECT_EQ(count(svg_of(ray), "<path"), 3u);  // with that of the legend
  EXPECT_EQ(count(svg_of(aid), "<path"), 2u);
  EXPECT_EQ(count(svg_of(still), "<path"), 2u);
}

// ---- Labels

bool are_apart(const TextBox& a, const TextBox& b) {
  return a.hi.x <= b.lo.x || b.hi.x <= a.lo.x || a.hi.y <= b.lo.y || b.hi.y <= a.lo.y;
}

TEST(LabelLayout, StaysInTheFrame) {
  const glm::dvec2 frame(480, 150);
  for (const double x : {-1000.0, 0.0, 240.0, 480.0, 1e6}) {
    for (const double y : {0.0, 75.0, 150.0}) {
      for (const std::size_t length : {1, 30, 90, 200}) {
        LabelLayout layout(frame);
        std::string text;
        while (text.size() < length) text += "word ";
        const PlacedLabel placed = layout.place({x, y}, text);
        EXPECT_GE(placed.box.lo.x, 0);
        EXPECT_LE(placed.box.hi.x, frame.x);
        EXPECT_GE(placed.box.lo.y, 0);
        EXPECT_LE(placed.box.hi.y, frame.y);
        for (const std::string& line : placed.lines) EXPECT_LE(text_width(line), frame.x) << line;
      }
    }
  }
}

TEST(LabelLayout, KeepsLabelsApart) {
  LabelLayout layout({480, 300});
  std::vector<TextBox> boxes;
  for (int i = 0; i < 6; ++i) boxes.push_back(layout.place({240, 150}, "the same place").box);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(are_apart(boxes[i], boxes[j])) << i << " and " << j;
  }
}

TEST(LabelLayout, KeepsClearOfLines) {
  LabelLayout layout({480, 300});
  for (int x = 0; x <= 480; x += 4) layout.avoid({x, 150}, 60);
  const TextBox box = layout.place({240, 150}, "beside the line").box;
  EXPECT_TRUE(box.hi.y <= 150 || box.lo.y >= 150);
}

TEST(LabelLayout, TakesLinesAsTheyAre) {
  LabelLayout layout({480, 300});
  EXPECT_EQ(layout.place({100, 100}, "one\ntwo three").lines, (std::vector<std::string>{"one", "two three"}));
}

}  // namespace
}  // namespace sightline::stability
