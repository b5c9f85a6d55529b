/// sightline-stability: hard cases of numerics, and what the library answers.

#include <iostream>

#include "tests/hard_cases/hard_cases.h"
#include "tests/stability/command.h"
#include "tests/stability_hunts.h"
#include "viz/run_tool.h"

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-stability", [&] {
    if (sightline::asks_hunts(argc, argv)) {
      return sightline::run_hunts(argc, argv, SIGHTLINE_DATA_DIR, std::cout, std::cerr);
    }
    return sightline::stability::run(sightline::hard::hard_cases(), argc, argv, std::cout, std::cerr);
  });
}
