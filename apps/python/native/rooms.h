// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

/// The parts of axiometry._native, each of which adds its functions and types. What they mean for who uses Python
/// stands in the docstrings of apps/python/axiometry, the only caller.
namespace axiometry::python {

void add_parameters(pybind11::module_& module);   ///< clause 3 of arrays of readings
void add_tests(pybind11::module_& module);        ///< tests, their evaluation and reports
void add_propagation(pybind11::module_& module);  ///< uncertainty of any measurement model
void add_error_model(pybind11::module_& module);  ///< the 21 errors of a machine

}  // namespace axiometry::python
