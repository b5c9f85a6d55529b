#include <nlohmann/json.hpp>
#include <stdexcept>

#include "viz/drawing/drawing.h"

namespace sightline {

using nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(Role, {{Role::scene, "scene"},
                                    {Role::cell, "cell"},
                                    {Role::ray, "ray"},
                                    {Role::right, "right"},
                                    {Role::wrong, "wrong"},
                                    {Role::missed, "missed"},
                                    {Role::note, "note"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel::Triangle, corners, role, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel::Box, lo, hi, role, order, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel::Ball, center, radius, role, order, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel::Line, points, role, is_arrow, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel::Dot, at, role, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpacePanel, triangles, boxes, balls, lines, dots)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChartPanel::Curve, name, role, points, is_dots)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChartPanel, x_label, y_label, is_log_x, is_log_y, curves)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LadderPanel::Row, name, role, intervals)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LadderPanel, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ImagePanel, width, height, bytes)

namespace {

/// Numbers that JSON cannot hold become null, which no panel takes: whoever draws nothing sensible is told.
void check(const ImagePanel& image) {
  const auto size = std::int64_t(image.width) * image.height * 3;
  if (image.width < 1 || image.height < 1 || size != static_cast<std::int64_t>(image.bytes.size())) {
    throw std::invalid_argument("an image of " + std::to_string(image.width) + " by " + std::to_string(image.height) +
                                " pixels: expected " + std::to_string(size) + " bytes, found " +
                                std::to_string(image.bytes.size()));
  }
}

void to_json(json& to, const Panel& panel) {
  to["title"] = panel.title;
  if (const auto* space = std::get_if<SpacePanel>(&panel.content)) to["space"] = *space;
  if (const auto* chart = std::get_if<ChartPanel>(&panel.content)) to["chart"] = *chart;
  if (const auto* ladder = std::get_if<LadderPanel>(&panel.content)) to["ladder"] = *ladder;
  if (const auto* image = std::get_if<ImagePanel>(&panel.content)) to["image"] = *image;
}

Panel panel_of(const json& from) {
  Panel panel{from.at("title").get<std::string>(), {}};
  if (from.contains("space")) {
    panel.content = from["space"].get<SpacePanel>();
  } else if (from.contains("chart")) {
    panel.content = from["chart"].get<ChartPanel>();
  } else if (from.contains("ladder")) {
    panel.content = from["ladder"].get<LadderPanel>();
  } else if (from.contains("image")) {
    panel.content = from["image"].get<ImagePanel>();
    check(std::get<ImagePanel>(panel.content));
  } else {
    throw std::invalid_argument("expected a panel with space, chart, ladder or image, found none of them");
  }
  return panel;
}

}  // namespace

void to_json(json& to, const Drawing& drawing) {
  to = {{"title", drawing.title}, {"caption", drawing.caption}, {"panels", json::array()}};
  for (const Panel& panel : drawing.panels) {
    json entry;
    to_json(entry, panel);
    to["panels"].push_back(std::move(entry));
  }
}

void from_json(const json& from, Drawing& drawing) {
  drawing = {from.at("title").get<std::string>(), from.at("caption").get<std::string>(), {}};
  for (const json& panel : from.at("panels")) drawing.panels.push_back(panel_of(panel));
}

}  // namespace sightline
