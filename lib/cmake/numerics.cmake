# The numeric promises: every operation rounds where the source says so.
#   No contraction of a * b + c, and never a fast-math flag.
#   GCC 12's SLP vectorizer drops roundings where float and double mix; it is switched off where the canary shows it.

set(SIGHTLINE_NUMERIC_FLAGS -ffp-contract=off)
if(SIGHTLINE_NATIVE)
  list(APPEND SIGHTLINE_NUMERIC_FLAGS -march=native)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND SIGHTLINE_NUMERIC_FLAGS -march=x86-64-v2) # SSE4.2; without it Highway has one lane, where leaves need four
endif()

if(NOT DEFINED SIGHTLINE_SLP_IS_SOUND AND NOT CMAKE_CROSSCOMPILING)
  set(sound ON)
  foreach(level -O2 -O3)
    foreach(target "" ${SIGHTLINE_NUMERIC_FLAGS})
      try_run(status compiled ${CMAKE_BINARY_DIR}/canary ${CMAKE_CURRENT_LIST_DIR}/slp_canary.cpp
              CMAKE_FLAGS -DCMAKE_BUILD_TYPE=None
              COMPILE_DEFINITIONS ${level} -ffp-contract=off ${target})
      if(NOT compiled OR NOT "${status}" STREQUAL "0")
        set(sound OFF)
      endif()
    endforeach()
  endforeach()
  set(SIGHTLINE_SLP_IS_SOUND ${sound} CACHE BOOL "Superword vectorization keeps every rounding" FORCE)
  message(STATUS "Superword vectorization keeps every rounding: ${sound}")
endif()
if(NOT SIGHTLINE_SLP_IS_SOUND)
  list(APPEND SIGHTLINE_NUMERIC_FLAGS -fno-tree-slp-vectorize)
endif()
