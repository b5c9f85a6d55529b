#include "viz/pages/one_window.h"

#include <algorithm>

#include "viz/build/replay.h"
#include "viz/command_text.h"
#include "viz/paper.h"

namespace sightline::viz {
namespace {

constexpr double tab_width = 152, tab_left = 8, text_size = 15;
constexpr int samples = 8;  // a pixel

}  // namespace

OneWindow::OneWindow(const PageState& state, std::size_t page, int width, int pixels_down,
                     std::vector<std::string> common, Run run)
    : state_(state),
      common_(std::move(common)),
      run_(std::move(run)),
      page_(page),
      frame_("sightline", width, pixels_down, samples) {
  frame_.set_bar(*this);
  open(page);
  state_.pick.reset();  // of the first page's picture, and of no other
}

double OneWindow::place_of(std::size_t page) const { return tab_left + tab_width * (static_cast<double>(page) + 0.5); }

void OneWindow::draw(Canvas& canvas, int width) const {
  canvas.rectangle({0, 0}, width, height, band);
  canvas.line({0, height - 0.5}, {double(width), height - 0.5}, 1, faint_ink);
  double right = 0;
  for (std::size_t i = 0; i < page_infos.size(); ++i) {
    const double x = tab_left + tab_width * static_cast<double>(i);
    const bool is_shown = i == page_;
    if (is_shown) {
      canvas.rectangle({x, 5}, tab_width - 4, height - 5, {1, 1, 1});
      canvas.rectangle({x, 4}, tab_width - 4, 3, accent);
    }
    const std::string key = "F" + std::to_string(i + 1);
    canvas.text({x + 10, height / 2.0 + 2}, key, {13, soft_ink});
    canvas.text({x + 34, height / 2.0 + 2}, std::string(page_infos[i].title),
                {text_size, is_shown ? ink : soft_ink, Canvas::Align::left, is_shown});
    right = x + tab_width;
  }
  const std::string structure = page_infos[page_].has_structure ? "A: " + state_.accelerator + "    " : "";
  const std::string text = !message_.empty() ? message_ : structure + "H: keys";
  const Canvas::TextStyle style{text_size, message_.empty() ? soft_ink : accent, Canvas::Align::right};
  canvas.text({width - 12.0, height / 2.0 + 2}, canvas.shortened(text, style, width - right - 20), style);
}

void OneWindow::press(double x) {
  const double tab = (x - tab_left) / tab_width;
  if (tab >= 0 && tab < double(page_infos.size())) asked_ = static_cast<std::size_t>(tab);
}

bool OneWindow::answer_key(const std::string& key) {
  if (key.size() == 2 && key[0] == 'F' && key[1] >= '1' && key[1] < '1' + static_cast<char>(page_infos.size())) {
    asked_ = static_cast<std::size_t>(key[1] - '1');
    return true;
  }
  if (key != "a" && key != "A") return false;
  if (!page_infos[page_].has_structure) return true;
  remember();
  state_.accelerator = next_structure();
  asked_ = page_;
  return true;
}

/// In the registry's order; where constructions are shown, of those that can be asked.
std::string OneWindow::next_structure() const {
  std::vector<std::string> names;
  for (const AcceleratorInfo& info : accelerator_infos()) names.emplace_back(info.name);
  if (page_infos[page_].name == "build") {
    const auto replayed = replayed_structures();
    std::erase_if(names, [&](const std::string& name) { return std::ranges::find(replayed, name) == replayed.end(); });
  }
  const auto at = std::ranges::find(names, state_.accelerator.substr(0, state_.accelerator.find(':')));
  return at == names.end() || at + 1 == names.end() ? names.front() : at[1];
}

void OneWindow::ask(const std::string& page) { asked_ = page_named(page); }

void OneWindow::settle() {
  if (!asked_) return;
  const std::size_t page = *asked_;
  asked_.reset();
  remember();
  try {
    open(page);
  } catch (const std::exception& error) {
    message_ = error.what();
    frame_.render();
  }
}

/// What the page is left with.
void OneWindow::remember() {
  const PageInfo& info = page_infos[page_];
  std::vector<std::string> words = words_of(shown().command());
  if (words.empty()) return;
  words.erase(words.begin());  // the program's name
  const auto subcommand = std::ranges::find(words, info.name);
  former_[page_] = {subcommand, words.end()};
  const SharedView view = shown().shared_view();
  if (view.ray) state_.ray = text_of(*view.ray);
  if (view.azimuth) state_.azimuth = view.azimuth;
  if (view.elevation) state_.elevation = view.elevation;
  if (view.zoom) state_.zoom = view.zoom;
}

void OneWindow::open(std::size_t page) {
  const PageInfo& info = page_infos[page];
  const int* size = frame_.window().GetSize();
  const int room = size[1] - WindowBar::height - (info.tells_command ? 0 : WindowFrame::foot_height);
  std::vector<std::string> words = common_;
  const std::vector<std::string> own =
      page_words(info, state_, std::to_string(size[0]) + 'x' + std::to_string(room), former_[page]);
  words.insert(words.end(), own.begin(), own.end());
  const std::size_t before = std::exchange(page_, page);
  message_.clear();
  try {
    run_(words, &frame_);
  } catch (...) {
    page_ = before;
    throw;
  }
}

}  // namespace sightline::viz
