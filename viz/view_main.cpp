/// sightline-view: how a structure divides space, as windows, pictures or data.

#include "viz/run_tool.h"
#include "viz/view.h"

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-view", [&] {
    return sightline::viz::run_view({argv + 1, argv + argc}, SIGHTLINE_DATA_DIR);
  });
}
