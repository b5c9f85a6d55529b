/// sightline-stability: hard cases of numerics, and what the library answers.

#include <iostream>

#include "tests/hard_cases/hard_cases.h"
#include "tests/stability/command.h"
#include "viz/run_tool.h"

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-stability", [&] {
    return sightline::stability::run(sightline::hard::hard_cases(), argc, argv, std::cout, std::cerr);
  });
}
