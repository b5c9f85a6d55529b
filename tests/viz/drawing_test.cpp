#include "viz/drawing/drawing.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace sightline {
namespace {

Drawing drawing_of_all() {
  SpacePanel space;
  space.triangles.push_back({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, Role::missed, "0"});
  space.boxes.push_back({{0, 0, 0}, {1, 2, 3}, Role::cell, 4, "4"});
  space.balls.push_back({{1, 1, 1}, 0.5, Role::scene, -1, ""});
  space.lines.push_back({{{0, 0, 0}, {1, 1, 1}}, Role::ray, true, "ray"});
  space.dots.push_back({{0.25, 0.25, 0}, Role::wrong, "got"});
  ChartPanel chart{"x", "y", false, true, {{"curve", Role::right, {{0, 1}, {1, 10}}, false}}};
  LadderPanel ladder{{{"A", Role::scene, {{0, 1}, {2, 3}}}}};
  return {"title",
          "caption",
          {{"space", space}, {"chart", chart}, {"ladder", ladder}, {"image", ImagePanel{1, 2, {1, 2, 3, 4, 5, 6}}}}};
}

TEST(Drawing, ComesBackFromJson) {
  const nlohmann::json json = drawing_of_all();
  const auto back = json.get<Drawing>();
  EXPECT_EQ(nlohmann::json(back), json);
  ASSERT_EQ(back.panels.size(), 4u);
  const auto& space = std::get<SpacePanel>(back.panels[0].content);
  EXPECT_EQ(space.triangles[0].role, Role::missed);
  EXPECT_EQ(space.boxes[0].order, 4);
  EXPECT_EQ(std::get<ImagePanel>(back.panels[3].content).bytes.size(), 6u);
}

TEST(Drawing, RefusesWhatIsNone) {
  nlohmann::json json = drawing_of_all();
  json["panels"][3]["image"]["width"] = 7;
  EXPECT_THROW(json.get<Drawing>(), std::invalid_argument);
  json = drawing_of_all();
  json["panels"][0].erase("space");
  EXPECT_THROW(json.get<Drawing>(), std::invalid_argument);
  EXPECT_THROW(nlohmann::json::parse("[1]").get<Drawing>(), nlohmann::json::exception);
}

}  // namespace
}  // namespace sightline
