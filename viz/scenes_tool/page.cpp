#include "viz/scenes_tool/page.h"

#include <algorithm>

#include "sightline/io/output_file.h"

namespace sightline::scenes_tool {
namespace {

constexpr const char* style =
    R"(body { font: 15px/1.5 system-ui, sans-serif; margin: 2em; color: #222; background: #fafaf8 }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(260px, 1fr)); gap: 1.5em }
figure { margin: 0 } img { width: 100%; border-radius: 4px } code { font-size: 95% } p { margin: 0; color: #666 }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

/// Of a file name, which also says what --scene takes.
std::string file_name(const std::string& spec) {
  std::string name = std::filesystem::path(spec).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '-');
  return name;
}

Image sheet_of(const std::vector<Shown>& list) {
  constexpr int gap = 8, columns = 6;
  const int width = list[0].picture.width, height = list[0].picture.height, count = static_cast<int>(list.size());
  const int rows = (count + columns - 1) / columns;
  Image sheet{columns * (width + gap) + gap, rows * (height + gap) + gap, 3, {}};
  sheet.pixels.assign(std::size_t(sheet.width) * std::size_t(sheet.height) * 3, 1.0f);
  for (int i = 0; i < count; ++i) {
    const Image& picture = list[static_cast<std::size_t>(i)].picture;
    const int left = gap + i % columns * (width + gap), top = gap + i / columns * (height + gap);
    for (int y = 0; y < height; ++y) {
      const auto from = picture.pixels.begin() + std::ptrdiff_t{3} * y * width;
      std::copy(from, from + std::ptrdiff_t{3} * width,
                sheet.pixels.begin() + std::ptrdiff_t{3} * ((top + y) * sheet.width + left));
    }
  }
  return sheet;
}

}  // namespace

void write_page(const std::filesystem::path& folder, const std::vector<Shown>& list) {
  if (list.empty()) return;
  std::string body;
  for (const Shown& each : list) {
    const std::string name = file_name(each.spec) + ".png";
    write_image(folder / name, each.picture);
    body += "<figure><img src=\"" + name + "\" alt=\"" + escaped(each.spec) + "\"><figcaption><code>--scene " +
            escaped(each.spec) + "</code><p>" + escaped(each.description) + "</p><p>" + escaped(each.facts) +
            "</p></figcaption></figure>\n";
  }
  write_image(folder / "sheet.png", sheet_of(list));
  write_text(folder / "index.html",
             "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Sightline's scenes</title>\n<style>" +
                 std::string(style) + "</style>\n<h1>Scenes</h1>\n<main>\n" + body + "</main>\n</html>\n");
}

}  // namespace sightline::scenes_tool
