// SPDX-License-Identifier: Apache-2.0
// Machines, axes and instruments over time; trends of an axis.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "axiometry/app/workbench/equipment_json.h"
#include "axiometry/base/text/text.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using json::Value;
using store::AxisRecord;
using store::InstrumentRecord;
using store::MachineRecord;
using store::Store;
using store::Versioned;

/// What differs between the kinds of assets.
template <typename Asset>
struct KindOf;

template <>
struct KindOf<MachineRecord> {
  static constexpr std::string_view name = "machine";
  static constexpr std::string_view plural = "machines";
  static constexpr auto from = &app::machine_from;
};

template <>
struct KindOf<AxisRecord> {
  static constexpr std::string_view name = "axis";
  static constexpr std::string_view plural = "axes";
  static constexpr auto from = &app::axis_from;
};

template <>
struct KindOf<InstrumentRecord> {
  static constexpr std::string_view name = "instrument";
  static constexpr std::string_view plural = "instruments";
  static constexpr auto from = &app::instrument_from;
};

/// The machines with what is theirs, in their order.
std::vector<app::MachineSummary> summaries(std::vector<Versioned<MachineRecord>> machines,
                                           std::vector<Versioned<AxisRecord>> axes,
                                           std::vector<store::MachineTests> tests,
                                           std::vector<store::AxisLatest> of_axes) {
  std::map<store::Id, std::vector<Versioned<AxisRecord>>> axes_of;
  for (auto& axis : axes) axes_of[axis.value.machine].push_back(std::move(axis));
  std::map<store::Id, store::MachineTests> tests_of;
  for (auto& of_one : tests) tests_of.emplace(of_one.machine, std::move(of_one));
  std::map<store::Id, std::vector<store::AxisLatest>> latest_of;
  for (auto& of_one : of_axes) latest_of[of_one.machine].push_back(std::move(of_one));
  std::vector<app::MachineSummary> all;
  for (auto& machine : machines) {
    const store::Id id = machine.id;
    app::MachineSummary& summary = all.emplace_back(std::move(machine), std::move(axes_of[id]));
    if (auto found = tests_of.find(id); found != tests_of.end()) summary.tests = std::move(found->second);
    summary.of_axes = std::move(latest_of[id]);
  }
  return all;
}

template <typename Asset>
Result<Value> whole_value(const Store&, const Versioned<Asset>& asset) {
  return app::to_json(asset);
}

template <>
Result<Value> whole_value(const Store& store, const Versioned<MachineRecord>& machine) {
  AXIOMETRY_TRY(auto axes, store.all<AxisRecord>());
  AXIOMETRY_TRY(auto tests, store.machine_tests(machine.id));
  AXIOMETRY_TRY(auto of_axes, store.axes_latest(machine.id));
  const auto all = summaries({machine}, std::move(axes), std::move(tests), std::move(of_axes));
  return app::to_json(all.front());
}

template <typename Asset>
Result<Value> listed(const Store& store) {
  AXIOMETRY_TRY(const auto assets, store.all<Asset>());
  Value rows = Value::array();
  for (const auto& asset : assets) rows.push(app::to_json(asset));
  return rows;
}

template <>
Result<Value> listed<MachineRecord>(const Store& store) {
  AXIOMETRY_TRY(auto machines, store.all<MachineRecord>());
  AXIOMETRY_TRY(auto axes, store.all<AxisRecord>());
  AXIOMETRY_TRY(auto tests, store.machine_tests());
  AXIOMETRY_TRY(auto of_axes, store.axes_latest());
  const auto all = summaries(std::move(machines), std::move(axes), std::move(tests), std::move(of_axes));
  Value rows = Value::array();
  for (const auto& summary : all) rows.push(app::to_json(summary));
  return rows;
}

template <typename Asset>
Result<Response> list_assets(Store& store, const Request&) {
  AXIOMETRY_TRY(Value rows, listed<Asset>(store));
  Value object = Value::object();
  object.add(KindOf<Asset>::plural, std::move(rows));
  return json_response(object);
}

template <typename Asset>
Result<Response> add(Store& store, const Request& request) {
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const auto edit, KindOf<Asset>::from(body));
  AXIOMETRY_TRY(const auto asset, store.add(edit.value, by_of(request, edit.reason)));
  AXIOMETRY_TRY(const Value value, whole_value(store, asset));
  return kept_response(value, {.id = asset.id, .version = asset.version}, 201);
}

template <typename Asset>
Result<Response> get_asset(Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, KindOf<Asset>::name));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const auto asset, store.get<Asset>(id, version));
  AXIOMETRY_TRY(const Value value, whole_value(store, asset));
  return json_response(value);
}

template <typename Asset>
Result<Response> change(Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, KindOf<Asset>::name));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const auto edit, KindOf<Asset>::from(body));
  if (!edit.base_version)
    return fail("found a change without base_version, expected the version it rests on", body.at());
  AXIOMETRY_TRY(const auto asset, store.change(id, *edit.base_version, edit.value, by_of(request, edit.reason)));
  AXIOMETRY_TRY(const Value value, whole_value(store, asset));
  return kept_response(value, {.id = asset.id, .version = asset.version});
}

template <typename Asset>
Result<Response> versions(Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, KindOf<Asset>::name));
  AXIOMETRY_TRY(const auto all, store.versions<Asset>(id));
  Value object = Value::object();
  Value& rows = object.add("versions", Value::array());
  for (const auto& asset : all) rows.push(app::to_json(asset));
  return json_response(object);
}

template <typename Asset, typename Add>
void add_routes_of(const Add& add_route) {
  const std::string path = fmt::format("/api/{}", KindOf<Asset>::plural);
  add_route("GET", path, list_assets<Asset>);
  add_route("POST", path, add<Asset>, Weight::edit);
  add_route("GET", path + "/{id}", get_asset<Asset>);
  add_route("PUT", path + "/{id}", change<Asset>, Weight::edit);
  add_route("GET", path + "/{id}/versions", versions<Asset>);
}

/// Those that are asked for; all where none is, so that tests of one direction have theirs too.
Result<std::vector<std::string>> parameters_of(const Request& request) {
  std::vector<std::string> keys;
  const auto asked = request.parameter("parameters");
  if (!asked) {
    for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters) keys.emplace_back(parameter.key);
    return keys;
  }
  for (const std::string_view key : text::split(*asked, ',')) {
    const auto* parameter = iso230_2::find_parameter(text::trim(key));
    if (parameter == nullptr)
      return fail(fmt::format("found the parameter {}, expected some of A, E, R, B and their like", text::quoted(key)));
    if (std::ranges::find(keys, parameter->key) == keys.end()) keys.emplace_back(parameter->key);
  }
  return keys;
}

Result<Response> trend(Store& store, const Request& request) {
  constexpr std::int64_t limit_usual = 500;
  constexpr std::int64_t limit_max = 10'000;
  AXIOMETRY_TRY(const store::Id id, id_of(request, "axis"));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", limit_max));
  AXIOMETRY_TRY(const auto parameters, parameters_of(request));
  AXIOMETRY_TRY(auto axis, store.get<AxisRecord>(id));
  AXIOMETRY_TRY(auto machine, store.get<MachineRecord>(axis.value.machine));
  AXIOMETRY_TRY(auto points, store.trend(id, parameters, limit.value_or(limit_usual)));
  return json_response(app::to_json(app::AxisTrend{std::move(axis), std::move(machine.value.name), std::move(points)}));
}

}  // namespace

void add_equipment_routes(Router& router, const Context& context) {
  const auto add_route = adder(router, context.store);
  add_routes_of<MachineRecord>(add_route);
  add_routes_of<AxisRecord>(add_route);
  add_routes_of<InstrumentRecord>(add_route);
  add_route("GET", "/api/axes/{id}/trend", trend);
}

}  // namespace axiometry::server
