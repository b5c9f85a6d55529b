#pragma once

#include <functional>

#include "viz/interactive_window.h"
#include "viz/pages/page_words.h"

namespace sightline::viz {

/// All pages in one frame, under a bar that switches between them. A page is what its subcommand shows; it is left as
/// the command line that it tells, and opened again by that.
class OneWindow : public WindowBar {
 public:
  using Run = std::function<int(const std::vector<std::string>&, WindowFrame*)>;

  /// `common` are words before the subcommand. \throws what opening the page throws
  OneWindow(const PageState& state, std::size_t page, int width, int height, std::vector<std::string> common, Run run);

  void run() { frame_.run(); }

  /// What is shown.
  std::size_t page() const { return page_; }
  const InteractiveWindow& shown() const { return *frame_.kept().window; }
  const PageState& state() const { return state_; }
  const std::string& message() const { return message_; }
  WindowFrame& frame() { return frame_; }
  /// Where in the bar a page's name is, in pixels from the left.
  double place_of(std::size_t page) const;

 private:
  void draw(Canvas& canvas, int width) const override;
  void press(double x) override;
  bool answer_key(const std::string& key) override;
  void ask(const std::string& page) override;
  void settle() override;

  void remember();
  void open(std::size_t page);
  std::string next_structure() const;

  PageState state_;
  std::vector<std::string> common_;
  Run run_;
  std::size_t page_;
  std::optional<std::size_t> asked_;  ///< A page that is to be shown.
  std::array<std::vector<std::string>, page_infos.size()> former_;
  std::string message_;  ///< Why something that was asked for is not shown.
  WindowFrame frame_;
};

}  // namespace sightline::viz
