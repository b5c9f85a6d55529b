#include "labs/runner/pictures.h"

#include <nlohmann/json.hpp>

#include "bench/run_program.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {

bool draw_picture(const Workshop& workshop, const Drawing& drawing, const std::filesystem::path& picture,
                  std::string& problem) {
  std::filesystem::path data = picture;
  data.replace_extension(".json");
  write_text(data, nlohmann::json(drawing).dump() + "\n");
  const auto viewer = workshop.program("sightline-view");
  if (!std::filesystem::exists(viewer)) {
    problem = "no picture: the viewer is not built";
    return false;
  }
  const auto log = std::filesystem::path(data).replace_extension(".log");
  const bool is_drawn = bench::run_program({viewer, "drawing", data, "--out", picture}, log) == 0;
  problem = is_drawn ? "" : "no picture: " + bench::text_in(log).substr(0, 200);
  std::filesystem::remove(log);
  return is_drawn;
}

}  // namespace sightline::labs
