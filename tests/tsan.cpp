/// Debian's oneTBB is not compiled for the thread sanitizer, which therefore does not see how it orders the tasks it runs and
/// takes each hand-over for a race. Under the thread sanitizer TBB has one thread; the threads that tests start themselves,
/// which query, and complete lazy structures, are watched in full.

#include <tbb/global_control.h>

namespace {
const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
}
