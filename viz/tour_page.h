#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

/// One structure on one scene: what the page shows of it. Pictures are file names beside the page.
struct StructureTour {
  std::string name;
  std::string anchor;  ///< By which the page links to it.
  std::string description;
  std::string partition;          ///< Picture of its cells.
  std::string partition_caption;  ///< "63 of 1,234 cells, depth 0 to 5 of 17".
  std::string heat_map;
  double work_per_pixel = 0;
};

struct SceneTour {
  std::string name;
  std::size_t triangles = 0;
  std::string picture;
  std::string page;     ///< To walk in, beside this one; empty where there is none.
  std::string verdict;  ///< How far all structures were found to agree.
  std::vector<StructureTour> structures;
};

/// The page, whole in itself but for the pictures. `bench` is what sightline-bench wrote; what it lacks is left blank.
std::string tour_page(const std::vector<SceneTour>& scenes, const nlohmann::json& bench);

/// Text as it stands in HTML.
std::string escaped(const std::string& text);

}  // namespace sightline::viz
