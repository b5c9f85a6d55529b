/// Debian's oneTBB and OpenImageIO are not compiled for the thread sanitizer, which therefore does not see how they
/// order the tasks that they run, and takes each hand-over for a race. Under the thread sanitizer each has one thread;
/// the threads that tests start themselves, which query, and complete lazy structures, are watched in full.

#include <OpenImageIO/imageio.h>
#include <tbb/global_control.h>

namespace {
const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
const bool is_set = OIIO::attribute("threads", 1);
}  // namespace
