#include "viz/web/web_page.h"

#include <stdexcept>

#include "viz/tour_page.h"
#include "viz/web/web_assets.h"
#include "viz/web/web_data.h"

namespace sightline::viz {
namespace {

/// No "</script>" may stand in a script, nor "<!--"; in JSON a "<" may be written so.
std::string safe_in_script(std::string json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

}  // namespace

bool has_web_library() { return !web_assets.library.empty(); }

std::string web_page(const WebModel& model) {
  if (!has_web_library()) {
    throw std::runtime_error(
        "pages need three.js, which was missing when this was built: apt-get install libjs-three, then build anew");
  }
  std::string page;
  const auto add = [&](const auto&... parts) { ((page += parts), ...); };
  add("<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content=\"width=device-width, "
      "initial-scale=1\"><title>Sightline: ",
      escaped(model.scene), "</title><link rel=icon href=\"data:,\">\n<style>", web_assets.style,
      "</style></head>\n<body>\n", web_assets.body);
  add("<script type=\"application/json\" id=data>", safe_in_script(web_data(model).dump()), "</script>\n");
  add("<!-- three.js, and what belongs to it:\n", web_assets.license, "-->\n<script>", web_assets.library,
      "</script>\n<script>", web_assets.script, "</script>\n</body></html>\n");
  return page;
}

}  // namespace sightline::viz
