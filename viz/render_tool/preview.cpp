#include "viz/render_tool/preview.h"

#include <unistd.h>

#include <iostream>
#include <stdexcept>

#include "sightline/render/film_image.h"

namespace sightline::render_tool {

Preview::Preview(const FilmState& film, double exposure) : exposure_(exposure) {
  const std::filesystem::path viewer = viz::program_folder() / "sightline-view";
  if (access(viewer.c_str(), X_OK) != 0) {
    std::cerr << "sightline-render: no preview: ./sightline view builds sightline-view, which shows it\n";
    return;
  }
  try {
    std::string folder = (std::filesystem::temp_directory_path() / "sightline-preview-XXXXXX").string();
    if (!mkdtemp(folder.data())) throw std::runtime_error("no temporary folder can be made");
    file_ = std::filesystem::path(folder) / "preview.png";
    leftovers_.emplace(std::vector{file_}, std::vector<std::filesystem::path>{folder});
    show(film);
    window_.emplace(viewer, std::vector<std::string>{"picture", file_.string(), "--follow"});
  } catch (const std::exception& error) {
    std::cerr << "sightline-render: no preview: " << error.what() << '\n';
  }
}

void Preview::show(const FilmState& film) { write_layers(file_, picture_of(film, exposure_)); }

}  // namespace sightline::render_tool
