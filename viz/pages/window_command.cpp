#include "viz/pages/window_command.h"

#include <algorithm>

#include "viz/pages/one_window.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(All pages in one window. The same without the word window.

F1 to F8, or a click on the bar: partitions, walk, build, heat, compare, csg, noise and graph, each as the subcommand of
that name shows it. Scene, structure, ray and camera go along. A takes the next structure, S writes the picture and
prints the command line that does, H shows all keys. The line at the bottom is a command line that shows the same.

With --out, the file of one page, as its subcommand writes it: no display is needed.

Examples
  sightline-view
  sightline-view --scene dragon:3 --accel bih
  sightline-view --page walk --pick 500,400
  sightline-view --page noise --out noise.png)";

constexpr int lowest_width = 1200, lowest_height = 751;  // all pages can be read

}  // namespace

WindowCommand::WindowCommand(CLI::App& program, const std::string& data_folder, Run run)
    : command_(program.add_subcommand("window", about)),
      data_(data_folder),
      usual_data_(data_folder),
      run_(std::move(run)),
      structure_(*command_),
      camera_(*command_) {
  command_->fallthrough();
  command_->add_option("--page", page_, "The first page; default partitions, or walk where a ray is given")
      ->option_text("NAME");
  auto* ray = command_->add_option("--ray", ray_, "Origin and direction")->option_text("OX,OY,OZ,DX,DY,DZ");
  command_->add_option("--pick", pick_, "The ray through a pixel of the first page's picture instead")
      ->option_text("X,Y")
      ->excludes(ray);
  command_->add_option("--size", size_, "Of the window in pixels, from 1200x751, or of the file; default 1600x1000")
      ->option_text("WIDTHxHEIGHT");
  add_outs(*command_, outs_, ".png, or what else the page writes,");
}

int WindowCommand::run() const {
  const bool has_ray = !ray_.empty() || !pick_.empty();
  const std::string name = !page_.empty() ? page_ : has_ray ? "walk" : "partitions";
  const auto page = page_named(name);
  if (!page) {
    std::string names;
    for (const PageInfo& info : page_infos) names += (names.empty() ? "" : ", ") + std::string(info.name);
    refuse("--page", name, "one of " + names);
  }
  const PageInfo& info = page_infos[*page];
  if (has_ray && !info.has_ray)
    refuse(ray_.empty() ? "--pick" : "--ray", ray_ + pick_, "a page of one ray: walk, heat or compare");
  structure_.structure();
  camera_.check();
  PageState state;
  state.accelerator = structure_.accelerators();
  state.scene = structure_.scene();
  state.settings = structure_.settings();
  state.threads = structure_.threads();
  if (!ray_.empty()) parse_ray("--ray", ray_), state.ray = ray_;
  if (!pick_.empty()) state.pick = pick_;
  if (camera_.has_azimuth()) state.azimuth = camera_.azimuth();
  if (camera_.has_elevation()) state.elevation = camera_.elevation();
  if (command_->count("--zoom")) state.zoom = camera_.zoom();
  std::vector<std::string> common;
  if (data_ != usual_data_) common = {"--data", data_};
  const PictureSize size = outs_.empty() ? parse_size(size_, {lowest_width, lowest_height}) : parse_size(size_);
  if (!outs_.empty()) {
    std::vector<std::string> words = common;
    const auto own = page_words(info, state, command_->count("--size") ? size_ : "");
    words.insert(words.end(), own.begin(), own.end());
    for (const std::string& out : outs_) words.insert(words.end(), {"--out", out});
    return run_(words, nullptr);
  }
  if (!has_display()) throw ScreenError("no display to open a window on; write a file instead: --out FILE.png");
  OneWindow(state, *page, size.width, size.height, common, run_).run();
  return 0;
}

}  // namespace sightline::viz
