/// sightline-accuracy: what accuracy costs, choice beside choice. See bench/README.md.

#include "viz/accuracy/charts.h"

int main(int argc, char** argv) {
  return sightline::bench::run_accuracy_command(argc, argv, sightline::viz::draw_accuracy_charts);
}
