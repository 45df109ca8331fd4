// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "axiometry/store/store.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::testing_support {

/// An archive in a folder of its own, which goes with it.
class Archive {
 public:
  Archive() {
    auto opened = store::Store::open(folder_.file("archive.db"));
    if (!opened) throw std::runtime_error(opened.error().to_string());
    store_ = *std::move(opened);
  }

  store::Store& store() { return *store_; }
  const std::string& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<store::Store> store_;
};

/// A file of the repository's examples.
inline std::string example_file(const std::string& source_folder, const std::string& name) {
  std::ifstream stream(source_folder + "/examples/" + name, std::ios::binary);
  if (!stream) throw std::runtime_error("no example " + name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace axiometry::testing_support
