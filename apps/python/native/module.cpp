// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include "axiometry/base/version.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

PYBIND11_MODULE(_native, module) {
  namespace py = pybind11;
  using namespace axiometry;
  py::register_exception<python::Failure>(module, "Error", PyExc_ValueError);
  module.attr("version") = version;
  python::add_parameters(module);
  python::add_tests(module);
  python::add_propagation(module);
  python::add_error_model(module);
}
