/// sightline-render: pictures of scenes.

#include "viz/render_tool/render_command.h"
#include "viz/run_tool.h"

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-render",
                             [&] { return sightline::render_tool::run(argc, argv, SIGHTLINE_DATA_DIR); });
}
