#pragma once
/// Scenes that differ by one effect.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sightline/render/effect.h"
#include "sightline/render/render_settings.h"
#include "sightline/scene/scene.h"

namespace sightline::bench {

/// A scene, and the rung that it stands on: the same scene without an effect.
struct Rung {
  std::string name, over;        ///< Stands on none where empty.
  std::optional<Effect> effect;  ///< What it is there for, and counts.
  Effects adds;                  ///< All that are simulated here and not below.
  std::string what;
  std::shared_ptr<const Scene> scene;
  std::uint32_t samples = 1;
  bool has_instances = false;  ///< Meshes are not put into one.

  RenderSettings settings(int width, int height, Level level) const;
};

inline constexpr std::string_view base_rung = "hard shadow", again_rung = "hard shadow again";

/// A ball, a smaller one and a box on a floor, gray, under a point light: and one change of that for each effect, most
/// of them of the ball, which takes a fifth of the picture. A rung comes behind the one that it stands on. Images are
/// those of `data_dir`/scenes/images.
std::vector<Rung> make_ladder(const std::filesystem::path& data_dir);

}  // namespace sightline::bench
