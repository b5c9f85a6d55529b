/// The chart of a family's failures, as an SVG that needs nothing else.

#include <array>
#include <cstdio>

#include "tests/hard_cases/families_report.h"

namespace sightline::hard {
namespace {

// In pixels.
constexpr double width = 720, left = 64, right = 16, top = 44, plot_height = 240, row_height = 20;
constexpr double plot_width = width - left - right, bottom = top + plot_height;

/// Told apart by color and by dashes, so that one of both is enough. Okabe and Ito, "Color Universal Design", 2008.
struct Style {
  const char* color;
  const char* dashes;
  double thickness;
};
constexpr std::array<Style, 5> level_styles{
    {{"#e69f00", "8 4", 2}, {"#56b4e9", "2 3", 3}, {"#009e73", "10 3 2 3", 2}, {"#0072b2", "", 2}, {"#0072b2", "", 2}}};
constexpr std::array<Style, 3> naive_styles{
    {{"#d55e00", "", 1.5}, {"#cc79a7", "6 2 1 2 1 2", 1.5}, {"#000000", "1 4", 1.5}}};

Style style_of(const FamilyLine& line, std::size_t naive_number) {
  if (line.is_naive) return naive_styles[naive_number % naive_styles.size()];
  for (const LevelInfo& info : level_infos) {
    if (info.name == line.name) return level_styles[static_cast<std::size_t>(info.level)];
  }
  return level_styles.back();
}

template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[512];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return formatted("<text x='%.1f' y='%.1f' text-anchor='%s'>", x, y, anchor) + escaped(text) + "</text>\n";
}

class Chart {
 public:
  explicit Chart(const FamilyResult& result) : result_(result) {}

  std::string svg() const {
    std::string body = text_at(left, 24, "start", result_.name + ": share of answers that are wrong");
    body += axes();
    std::size_t naive = 0, row = 0;
    for (const FamilyLine& line : result_.lines) {
      const Style style = style_of(line, naive);
      naive += line.is_naive;
      body += curve(line, style) + legend(line, style, row++);
    }
    const double height = bottom + 56 + row_height * static_cast<double>(result_.lines.size());
    return formatted(
               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' role='img' "
               "font-family='sans-serif' font-size='13'>\n<title>",
               width, height) +
           escaped(result_.name + ": " + result_.help) + "</title>\n" +
           formatted("<rect width='%.0f' height='%.0f' fill='#ffffff'/>\n", width, height) + body + "</svg>\n";
  }

 private:
  double x_of(int k) const {
    const int span = std::max(1, result_.hardest() - result_.easiest);
    return left + plot_width * (k - result_.easiest) / span;
  }
  static double y_of(double share) { return bottom - plot_height * share; }

  std::string axes() const {
    std::string text;
    for (int percent = 0; percent <= 100; percent += 25) {
      const double y = y_of(percent / 100.0);
      text +=
          formatted("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#dddddd'/>\n", left, y, width - right, y);
      text += text_at(left - 8, y + 4, "end", std::to_string(percent) + " %");
    }
    const int span = result_.hardest() - result_.easiest, step = span <= 16 ? 1 : span <= 32 ? 2 : 5;
    for (int k = result_.easiest; k <= result_.hardest(); ++k) {
      if (k % step != 0) continue;
      text += formatted("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#333333'/>\n", x_of(k), bottom, x_of(k),
                        bottom + 4);
      text += text_at(x_of(k), bottom + 18, "middle", std::to_string(k));
    }
    text += formatted("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#333333'/>\n", left, bottom, width - right,
                      bottom);
    return text + text_at(left + plot_width / 2, bottom + 38, "middle", result_.unit + "; harder to the right");
  }

  std::string curve(const FamilyLine& line, const Style& style) const {
    std::string points;
    for (std::size_t i = 0; i < line.counts.size(); ++i) {
      if (line.counts[i].asked == 0) continue;
      points +=
          formatted("%.1f,%.1f ", x_of(result_.easiest + static_cast<int>(i)), y_of(line.counts[i].wrong_share()));
    }
    return "<polyline fill='none' points='" + points + "'" + stroke(style) + "/>\n";
  }

  static std::string stroke(const Style& style) {
    return formatted(" stroke='%s' stroke-width='%.1f' stroke-dasharray='%s'", style.color, style.thickness,
                     style.dashes);
  }

  static std::string legend(const FamilyLine& line, const Style& style, std::size_t row) {
    const double y = bottom + 60 + row_height * static_cast<double>(row);
    const FamilyLine::Count total = line.total();
    return formatted("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'", left, y - 4, left + 44, y - 4) + stroke(style) +
           "/>\n" +
           text_at(left + 52, y, "start",
                   (line.is_naive ? "naive: " : "") + line.name + ", " + std::to_string(total.wrong) + " wrong of " +
                       std::to_string(total.asked));
  }

  const FamilyResult& result_;
};

}  // namespace

std::string failure_chart_svg(const FamilyResult& result) { return Chart(result).svg(); }

}  // namespace sightline::hard
