// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/error_model.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/volumetric/field_points.h"
#include "axiometry/app/volumetric/result_model.h"
#include "python/native/interpreter.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

namespace axiometry::python {
namespace {

namespace py = pybind11;
using app::KeptModel;
using volumetric::ErrorModel;
using Numbers = py::array_t<double, py::array::c_style>;

constexpr double untold = std::numeric_limits<double>::quiet_NaN();

/// Whether Ctrl-C has been pressed is asked once for so many points.
constexpr py::ssize_t block = 256;

/// Displacements (n, 3) in µm and their covariances (n, 3, 3) in µm², NaN where the readings do not tell a component.
/// `approach`: which way each axis came, +1, −1, or 0 for the mean of both.
py::tuple displacement(const KeptModel& kept, const Numbers& points, const std::string& tool,
                       const volumetric::Approaches& approach) {
  const ErrorModel& model = kept.model;
  const Vector3 offset = model.machine().tools[taken(app::tool_of_model(model, tool))].offset_mm;
  const py::ssize_t count = points.shape(0);
  Numbers errors(std::vector<py::ssize_t>{count, 3}), covariances(std::vector<py::ssize_t>{count, 3, 3});
  const double* from = points.data();
  double *error_to = errors.mutable_data(), *covariance_to = covariances.mutable_data();
  {
    const OthersRun others_run;
    for (py::ssize_t p = 0; p < count; ++p, from += 3) {
      if (p % block == 0) take_signals();
      const Vector3 at{from[0], from[1], from[2]};
      if (auto inside = app::check_inside(model, at); !inside)
        throw Failure(fmt::format("point {}: {}", p, inside.error().message));
      const volumetric::ToolPointError error = model.at(at, offset, approach);
      for (std::size_t i = 0; i < 3; ++i) {
        *error_to++ = error.error_um[i].value_or(untold);
        for (std::size_t k = 0; k < 3; ++k)
          *covariance_to++ = error.error_um[i] && error.error_um[k] ? error.covariance_um2[i][k] : untold;
      }
    }
  }
  return py::make_tuple(errors, covariances);
}

volumetric::ErrorMotion motion_named(const std::string& name) {
  if (const auto motion = volumetric::error_motion_named(name)) return *motion;
  throw Failure(fmt::format("found the error '{}', expected one as EXX, EYX or EAX", name));
}

/// Values and standard uncertainties of one error motion, NaN where the readings do not tell it.
py::tuple motion(const KeptModel& kept, const std::string& name, const Numbers& positions, double approach) {
  const volumetric::ErrorMotion error = motion_named(name);
  Numbers values(positions.size()), uncertainties(positions.size());
  const double* from = positions.data();
  double *value_to = values.mutable_data(), *u_to = uncertainties.mutable_data();
  for (py::ssize_t i = 0; i < positions.size(); ++i) {
    if (i % block == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
    taken(app::check_inside(kept.model, error.axis, from[i]));
    const auto estimate = kept.model.motion(error, from[i], approach);
    value_to[i] = estimate ? estimate->value : untold;
    u_to[i] = estimate ? estimate->u : untold;
  }
  return py::make_tuple(values, uncertainties);
}

py::tuple squareness(const KeptModel& kept, const std::string& name) {
  for (std::size_t k = 0; k < volumetric::squareness_names.size(); ++k) {
    if (volumetric::squareness_names[k] != name) continue;
    const auto estimate = kept.model.squareness(static_cast<volumetric::Squareness>(k));
    return py::make_tuple(estimate ? estimate->value : untold, estimate ? estimate->u : untold);
  }
  throw Failure(fmt::format("found the squareness '{}', expected C0Y, B0Z or A0Z", name));
}

py::list findings_of(const KeptModel& kept) {
  py::list findings;
  for (const NamedFinding& finding : kept.against)
    findings.append(py::make_tuple(finding.id, finding.serious, finding.message));
  return findings;
}

py::dict tools_of(const KeptModel& kept) {
  py::dict tools;
  for (const volumetric::Tool& tool : kept.model.machine().tools)
    tools[py::str(tool.name)] = py::make_tuple(tool.offset_mm.x, tool.offset_mm.y, tool.offset_mm.z);
  return tools;
}

py::list ranges_of(const KeptModel& kept) {
  py::list ranges;
  for (std::size_t a = 0; a < volumetric::axis_count; ++a) {
    const auto& basis = kept.model.coefficients().basis(a);
    ranges.append(py::make_tuple(basis.lower_mm(), basis.upper_mm()));
  }
  return ranges;
}

}  // namespace

void add_error_model(py::module_& module) {
  py::class_<KeptModel>(module, "ErrorModel")
      .def_property_readonly("findings", &findings_of)
      .def_property_readonly("tools", &tools_of)
      .def_property_readonly("ranges", &ranges_of)
      .def("displacement", &displacement)
      .def("motion", &motion)
      .def("squareness", &squareness);
  module.def("error_model_of_file", [](const std::string& file) { return taken(app::kept_model(file)); });
  module.def("error_model_of_text",
             [](const std::string& text) { return taken(app::kept_model(app::GivenFile{.name = "", .bytes = text})); });
}

}  // namespace axiometry::python
