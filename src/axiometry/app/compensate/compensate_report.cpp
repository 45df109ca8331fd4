// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/report/compensation.h"

namespace axiometry::app {
namespace {

using iso230_2::AxisParameters;
using json::Value;

Value parameter_values(const AxisParameters& parameters) {
  Value values = Value::object();
  for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters)
    if (const auto& value = parameters.*parameter.member)
      values.add(std::string(parameter.key), value->in_native());
    else
      values.add(std::string(parameter.key), Value());
  return values;
}

Value means_to_json(const iso230_2::Evaluation& evaluation) {
  Value rows = Value::array();
  for (const iso230_2::PositionResult& p : evaluation.positions) {
    Value& row = rows.push(Value::object());
    row.add("target", p.target.in_native());
    row.add("up", p.mean_up ? Value(p.mean_up->in_native()) : Value());
    row.add("down", p.mean_down ? Value(p.mean_down->in_native()) : Value());
  }
  return rows;
}

Value periodic_to_json(const compensation::PeriodicPart& part, compensation::Periodic choice) {
  Value value = Value::object();
  value.add("period", part.period);
  value.add("choice", choice == compensation::Periodic::leave ? "leave" : "keep");
  for (const auto& [name, direction] : {std::pair("up", Direction::up), std::pair("down", Direction::down)}) {
    const auto& fit = part.directions[static_cast<std::size_t>(direction)];
    if (!fit) {
      value.add(name, Value());
      continue;
    }
    Value& found = value.add(name, Value::object());
    found.add("amplitude", fit->amplitude);
    found.add("u", fit->amplitude_u);
    found.add("chance", fit->chance);
    found.add("significant", part.is_significant(direction));
  }
  return value;
}

void add_expanded(Value& row, const std::optional<iso230_2::ExpandedUncertainty>& u) {
  row.add("u", u ? Value(u->u.in_native()) : Value());
  row.add("U", u ? Value(u->U.in_native()) : Value());
  row.add("k", u ? Value(u->k) : Value());
}

Value compensated_to_json(const std::optional<compensation::CompensatedMean>& mean) {
  if (!mean) return {};
  Value row = Value::object();
  row.add("residual", mean->residual);
  row.add("rounding", mean->rounding);
  row.add("u_mean", mean->mean ? Value(mean->mean->u.in_native()) : Value());
  row.add("s", number_or_null(mean->s));
  add_expanded(row, mean->approach);
  return row;
}

Value known_to_json(const compensation::CompensatedPositions& known) {
  Value value = Value::object();
  value.add("at_targets", number_or_null(known.at_targets));
  value.add("anywhere", number_or_null(known.anywhere));
  value.add("zero", known.zero);
  Value& targets = value.add("targets", Value::array());
  for (const compensation::CompensatedTarget& target : known.targets) {
    Value& row = targets.push(Value::object());
    row.add("target", target.target.in_native());
    row.add("up", compensated_to_json(target.up));
    row.add("down", compensated_to_json(target.down));
  }
  for (const auto& [name, d] : {std::pair("up", std::size_t{0}), std::pair("down", std::size_t{1})}) {
    Value& between = value.add(std::string("between_") + name, Value::object());
    between.add("q", number_or_null(known.between_targets[d]));
    Value& gaps = between.add("gaps", Value::array());
    for (const compensation::CompensatedGap& gap : known.gaps[d]) {
      Value& row = gaps.push(Value::object());
      row.add("from", gap.from.in_native());
      row.add("to", gap.to.in_native());
      row.add("residual", gap.residual);
      add_expanded(row, gap.approach);
    }
  }
  Value& notes = value.add("notes", Value::array());
  for (const std::string& note : known.notes) notes.push(note);
  return value;
}

report::KnownPositions known_for_report(const compensation::CompensatedPositions& known) {
  report::KnownPositions shown{{}, known.zero, known.at_targets, known.anywhere, known.notes};
  const auto side = [](const std::optional<compensation::CompensatedMean>& mean) -> std::optional<report::KnownMean> {
    if (!mean) return std::nullopt;
    return report::KnownMean{mean->residual,
                             mean->approach ? std::optional(mean->approach->U.in_native()) : std::nullopt};
  };
  for (const compensation::CompensatedTarget& target : known.targets)
    shown.targets.push_back({target.target, side(target.up), side(target.down)});
  return shown;
}

Value limits_to_json(const nc::AxisTable& control) {
  Value limits = Value::object();
  limits.add("points", control.limits.points > 0 ? Value(control.limits.points) : Value());
  limits.add("step", control.limits.step_native > 0.0 ? Value(control.limits.step_native) : Value());
  limits.add("equidistant", control.limits.equidistant);
  limits.add("curves", curves_name(control.curves));
  limits.add("linear", control.limits.linear && !control.limits.cross_only);
  limits.add("rotary", control.limits.rotary && !control.limits.cross_only);
  return limits;
}

/// Names of the options that the control has a use for in the table of a test, which moves no other axis.
Value options_to_json(const nc::AxisTable& control) {
  Value names = Value::array();
  for (const nc::NamedTableOption& option : nc::named_table_options())
    if (control.uses.*option.used && option.used != &nc::AxisTableUses::output_axis) names.push(Value(option.name));
  return names;
}

Value verified_to_json(const nc::AxisTable& control) {
  Value verified = Value::object();
  verified.add("verified", control.verified);
  verified.add("inferred", control.inferred);
  return verified;
}

}  // namespace

json::Value nodes_to_json(const AxisCorrection& correction) {
  Value nodes = Value::array();
  for (std::size_t k = 0; k < correction.positions().size(); ++k) {
    Value& node = nodes.push(Value::object());
    node.add("position", correction.positions()[k]);
    node.add("up", correction.values(Direction::up)[k]);
    node.add("down", correction.values(Direction::down)[k]);
  }
  return nodes;
}

json::Value control_to_json(const nc::AxisTable& control) {
  Value value = Value::object();
  value.add("id", control.id);
  value.add("title", control.title);
  value.add("extension", control.extension);
  value.add("limits", limits_to_json(control));
  value.add("options", options_to_json(control));
  value.add("read_step", control.uses.told_step);
  value.add("cross", control.uses.output_axis);
  value.add("sign", control.sign);
  value.add("turned_sign", control.turned_sign);
  value.add("backlash", control.backlash);
  value.add("loading", control.loading);
  value.add("verified", control.verified);
  value.add("inferred", control.inferred);
  return value;
}

Experiment present(const CompensatedAxis& done, const report::Options& options, std::string_view notes) {
  const AxisKind kind = done.options.kind;
  Value root = Value::object();
  root.add("control", done.control->id);
  root.add("axis", done.options.axis);
  root.add("kind", axis_kind_name(kind));
  root.add("unit", deviation_unit_key(kind));
  root.add("sign", nc::sign_of(*done.control, done.options));
  root.add("turned_sign", done.options.turned_sign);
  root.add("table", nodes_to_json(done.applied));
  if (done.existing) root.add("existing", nodes_to_json(*done.existing));
  root.add("before", parameter_values(done.before.parameters));
  root.add("predicted", parameter_values(done.predicted.parameters));
  if (done.expected) {
    Value& expected = root.add("expected_retest", Value::object());
    expected.add("median", parameter_values(done.expected->median));
    expected.add("percent_95", parameter_values(done.expected->percent_95));
    expected.add("trials", done.expected->trials);
  }
  root.add("known_to_within", known_to_json(done.known));
  root.add("least_squares", parameter_values(done.fitted));
  root.add("interpolated", parameter_values(done.interpolated));
  root.add("scatter", parameter_values(done.scatter));
  root.add("before_means", means_to_json(done.before));
  root.add("predicted_means", means_to_json(done.predicted));
  root.add("periodic", done.periodic ? periodic_to_json(*done.periodic, done.periodic_choice) : Value());
  root.add("smoothing", done.smoothing > 0.0 ? Value(done.smoothing) : Value());
  if (done.retest) {
    Value& retest = root.add("retest", Value::object());
    retest.add("parameters", parameter_values(done.retest->evaluation.parameters));
    retest.add("means", means_to_json(done.retest->evaluation));
    retest.add("source", source_to_json(done.retest->test.provenance));
    if (const auto& effect = done.retest->effect) {
      retest.add("share", effect->whole.share);
      retest.add("u", effect->whole.u);
      retest.add("explained", effect->whole.explained);
      retest.add("compared", effect->compared);
    }
  }
  root.add("limits", limits_to_json(*done.control));
  root.add("verified", verified_to_json(*done.control));
  root.add("findings", findings_value(done.findings));
  root.add("source", source_to_json(done.test.provenance));
  root.add("program", program_to_json());
  const nc::AxisTable& c = *done.control;
  const report::KnownPositions known = known_for_report(done.known);
  const report::CompensationSubject subject{
      done.test,
      {c.title, nc::sign_of(c, done.options), c.loading, c.verified, c.inferred, c.limits.rolls_over},
      done.applied,
      done.existing ? &*done.existing : nullptr,
      done.before,
      done.predicted,
      done.expected ? &done.expected->percent_95 : nullptr,
      done.retest ? &done.retest->evaluation : nullptr,
      done.retest ? &done.retest->test.provenance : nullptr,
      done.scatter,
      known,
      done.findings,
      done.smoothing,
      notes};
  return {report::compose(subject, options), std::move(root)};
}

}  // namespace axiometry::app
