#include "tests/stability/json.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace sightline::stability {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> verdict_names{"exact", "within_bound", "wrong"};
constexpr std::array<std::string_view, 6> oracle_names{"rationals",   "sturm_chains", "more_digits",
                                                       "closed_form", "brute_force",  "metamorphic"};

std::string_view name_of(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

/// JSON has no other numbers than finite ones.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json json_of(const std::optional<hard::Example>& example) {
  if (!example) return nullptr;
  return {{"inputs", example->inputs}, {"expected", example->expected}, {"got", example->got}};
}

Json json_of(std::span<const Answers> all) {
  Json list = Json::array();
  for (const Answers& one : all) {
    Json entry{{"who", one.who}, {"level", one.level ? Json(info_of(*one.level).name) : Json(nullptr)}};
    entry["verdict"] = name_of(one.tally.verdict());
    entry["asked"] = one.tally.asked();
    for (const Verdict verdict : {Verdict::exact, Verdict::within_bound, Verdict::wrong}) {
      entry[std::string(name_of(verdict))] = one.tally.count(verdict);
    }
    entry["worst_error"] = number(one.tally.worst_error());
    entry["first"] = json_of(one.tally.first());
    entry["first_wrong"] = json_of(one.tally.first_wrong());
    list.push_back(std::move(entry));
  }
  return list;
}

Json json_of(const CaseReport& report) {
  const HardCase& own = *report.hard_case;
  Json entry{{"id", own.id},
             {"group", own.group},
             {"inputs", own.inputs},
             {"expected", own.expected},
             {"why", own.why},
             {"oracle", oracle_names[static_cast<std::size_t>(own.oracle)]},
             {"reference", own.reference.empty() ? Json(nullptr) : Json(own.reference)},
             {"policy", own.is_policy}};
  entry["verdicts"] = Json::object();
  for (std::size_t column = 0; column < column_count; ++column) {
    const std::optional<Cell> cell = cell_of(report, column);
    entry["verdicts"][std::string(column_name(column))] = cell ? Json(name_of(cell->verdict)) : Json(nullptr);
  }
  const std::optional<double> rate = naive_rate(report);
  entry["naive_rate"] = rate ? Json(*rate) : Json(nullptr);
  entry["keeps_promises"] = keeps_promises(report);
  entry["failed"] = report.error.empty() ? Json(nullptr) : Json(report.error);
  entry["seconds"] = report.seconds;
  entry["answers"] = json_of(report.answers);
  entry["naive"] = json_of(report.naive);
  return entry;
}

Json json_of(const Provenance& own) {
  return {{"processor", own.processor},
          {"hardware_threads", own.hardware_threads},
          {"system", own.system},
          {"compiler", own.compiler},
          {"flags", own.flags},
          {"build_type", own.build_type},
          {"assertions", own.has_assertions}};
}

Json json_of(const Summary& summary) {
  Json json{{"cases", summary.cases},
            {"policies", summary.policies},
            {"failed", summary.failed},
            {"wrong_at_default", summary.wrong_at_default},
            {"wrong_policies", summary.wrong_policies}};
  for (std::size_t column = 0; column < column_count; ++column) {
    Json& own = json["columns"][std::string(column_name(column))];
    for (const Verdict verdict : {Verdict::exact, Verdict::within_bound, Verdict::wrong}) {
      own[std::string(name_of(verdict))] = summary.columns[column].cases[static_cast<std::size_t>(verdict)];
    }
    own["not_applicable"] = summary.columns[column].not_applicable;
  }
  return json;
}

}  // namespace

std::string json_text(const Report& report, const Provenance& provenance) {
  Json json{{"schema", "sightline-stability 1"}, {"date", provenance.date}, {"version", provenance.version}};
  json["machine"] = json_of(provenance);
  json["share"] = report.share;
  json["seeds"] = "fixed, in the source of each case";
  json["seconds"] = report.seconds;
  json["keeps_promises"] = keeps_promises(report);
  json["summary"] = json_of(summary_of(report));
  json["cases"] = Json::array();
  for (const CaseReport& one : report.cases) json["cases"].push_back(json_of(one));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace sightline::stability
