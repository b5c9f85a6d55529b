#pragma once
/// Pages as command lines: what they share, and the words that open each.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::viz {

struct PageInfo {
  std::string_view name;   ///< The subcommand's.
  std::string_view title;  ///< In the bar.
  bool tells_command;      ///< Its picture does.
  bool has_structure, has_scene, has_ray, has_camera, has_zoom;
};
inline constexpr std::array<PageInfo, 8> page_infos{{
    {"partitions", "partitions", false, true, true, false, true, true},
    {"walk", "walk", true, true, true, true, true, true},
    {"build", "build", true, true, true, false, true, false},
    {"heat", "heat map", true, true, true, true, true, true},
    {"compare", "compare", true, false, true, true, true, true},
    {"csg", "CSG ladder", false, false, false, false, false, false},
    {"noise", "noise", false, false, false, false, false, false},
    {"graph", "scene graph", false, false, false, false, false, false},
}};

/// Nothing for a name that is no page's.
std::optional<std::size_t> page_named(std::string_view name);

/// What goes along from page to page. What is not given is left to the page.
struct PageState {
  std::string accelerator = "kd-tree", scene = "teapot";
  std::vector<std::string> settings = {};
  int threads = 0;
  std::optional<std::string> ray = std::nullopt, pick = std::nullopt;
  std::optional<double> azimuth = std::nullopt, elevation = std::nullopt, zoom = std::nullopt;
};

/// The words that open a page, in a picture of this size (`1200x900`) unless that is empty. `former`, if there are any, are those that it was left with:
/// they stay where structure, scene and ray are the same.
std::vector<std::string> page_words(const PageInfo& page, const PageState& state, const std::string& size,
                                    const std::vector<std::string>& former = {});

/// The value of an option among words, "--ray=1" or "--ray" "1"; nothing where it is not there.
std::optional<std::string> value_in(const std::vector<std::string>& words, const std::string& option);

}  // namespace sightline::viz
