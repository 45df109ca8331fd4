// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace axiometry::python {

/// While it lives, other threads of Python run; its owner must not touch Python. At the end of the program a thread
/// that wants the interpreter back is unwound instead, which no destructor that promises not to throw survives.
class OthersRun {
 public:
  OthersRun() : state_(PyEval_SaveThread()) {}
  OthersRun(const OthersRun&) = delete;
  ~OthersRun() noexcept(false) { PyEval_RestoreThread(state_); }

 private:
  PyThreadState* state_;
};

/// Raises KeyboardInterrupt where Ctrl-C was pressed since it was last asked. The interpreter is not held by the
/// caller.
inline void take_signals() {
  const pybind11::gil_scoped_acquire python;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

}  // namespace axiometry::python
