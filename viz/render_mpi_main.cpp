/// sightline-render-mpi: pictures of scenes, by the ranks of an MPI run.

#include <cstdio>

#include "viz/render_mpi/ranks.h"
#include "viz/render_tool/render_command.h"
#include "viz/run_tool.h"

int main(int argc, char** argv) {
  using namespace sightline;
  render_mpi::Ranks ranks(argc, argv);
  if (!ranks.is_first()) {
    // What goes wrong is rank 0's to tell.
    const bool is_silent = std::freopen("/dev/null", "w", stdout) && std::freopen("/dev/null", "w", stderr);
    ranks.work([&] { return render_tool::source_of_command(argc, argv, SIGHTLINE_DATA_DIR); });
    return is_silent ? success : failure;
  }
  const auto expose = [&](Film& film, const PictureSource& source, const ExposureOptions& options,
                          const std::atomic<bool>& stops) { return ranks.expose(film, source, options, stops); };
  return run_tool("sightline-render", [&] { return render_tool::run(argc, argv, SIGHTLINE_DATA_DIR, expose); });
}
