/// Debian's oneTBB is built without the thread sanitizer, which therefore does not see how it synchronizes: what happens inside
/// of it, and the hand-over of tasks, is not reported. Races between our own threads are.

extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libtbb.so\n"
         "race:tbb::detail\n";
}
