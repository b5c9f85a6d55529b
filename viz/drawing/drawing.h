#pragma once
/// What a picture shows, as data: points, lines and solids in space, curves, interval ladders, images. Whoever makes
/// one needs nothing that draws; drawing_picture.h draws it.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace sightline {

/// What something is to the reader; its color follows.
enum class Role {
  scene,   ///< What is there anyway.
  cell,    ///< A region of a structure; `order` tells when it was visited.
  ray,     ///< What is asked.
  right,   ///< What was expected.
  wrong,   ///< What was got instead.
  missed,  ///< What was overlooked.
  note     ///< Helping lines.
};

using Point3 = std::array<double, 3>;

/// Things in space, seen from one side; where all z are equal, from above.
struct SpacePanel {
  struct Triangle {
    std::array<Point3, 3> corners;
    Role role = Role::scene;
    std::string label;
  };
  struct Box {
    Point3 lo, hi;
    Role role = Role::cell;
    int order = -1;  ///< Of visits, from 0; -1 where it is not visited.
    std::string label;
  };
  struct Ball {
    Point3 center;
    double radius;
    Role role = Role::scene;
    int order = -1;
    std::string label;
  };
  struct Line {
    std::vector<Point3> points;
    Role role = Role::ray;
    bool is_arrow = false;  ///< With a head at its end.
    std::string label;
  };
  struct Dot {
    Point3 at;
    Role role = Role::right;
    std::string label;
  };
  std::vector<Triangle> triangles;
  std::vector<Box> boxes;
  std::vector<Ball> balls;
  std::vector<Line> lines;
  std::vector<Dot> dots;
};

/// Curves and dots over two axes.
struct ChartPanel {
  struct Curve {
    std::string name;
    Role role = Role::scene;
    std::vector<std::array<double, 2>> points;
    bool is_dots = false;
  };
  std::string x_label, y_label;
  bool is_log_x = false, is_log_y = false;
  std::vector<Curve> curves;
};

/// Intervals of a ray, row under row.
struct LadderPanel {
  struct Row {
    std::string name;
    Role role = Role::scene;
    std::vector<std::array<double, 2>> intervals;
  };
  std::vector<Row> rows;
};

/// Pixels, row by row from the top.
struct ImagePanel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  ///< Red, green and blue.
};

struct Panel {
  std::string title;
  std::variant<SpacePanel, ChartPanel, LadderPanel, ImagePanel> content;
};

/// Panels side by side under a title, a caption below.
struct Drawing {
  std::string title, caption;
  std::vector<Panel> panels;
};

void to_json(nlohmann::json& json, const Drawing& drawing);
/// \throws nlohmann::json::exception or std::invalid_argument where it is no drawing.
void from_json(const nlohmann::json& json, Drawing& drawing);

}  // namespace sightline
