#include "viz/accuracy/charts.h"
namespace sightline::viz {
void draw_accuracy_charts(const bench::AccuracyReport&, const std::string&) {}
}
