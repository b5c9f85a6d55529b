#pragma once
/// Files that CMake has put into the program: this folder's, and three.js where it is installed.

#include <string_view>

namespace sightline::viz {

struct WebAssets {
  std::string_view style, body, library, license, script;
};
extern const WebAssets web_assets;

}  // namespace sightline::viz
