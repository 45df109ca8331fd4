// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <utility>

#include "axiometry/base/result.h"

/// What may fail in the library raises axiometry.Error in Python.
namespace axiometry::python {

/// An Error as an exception; its text is what the command line says.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <typename T>
T taken(Result<T>&& result) {
  if (!result) throw Failure(result.error().to_string());
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

/// Of what was made from values of Python: lines and columns of a text that nobody wrote are left out.
template <typename T>
T taken_without_place(Result<T>&& result) {
  if (!result) throw Failure(result.error().message);
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

}  // namespace axiometry::python
