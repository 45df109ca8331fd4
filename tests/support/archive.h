// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "axiometry/store/store.h"

namespace axiometry::testing_support {

/// An archive in a folder of its own, which goes with it.
class Archive {
 public:
  Archive() : folder_(testing::TempDir() + "archive.XXXXXX") {
    if (::mkdtemp(folder_.data()) == nullptr) throw std::runtime_error("cannot make a folder for an archive");
    auto opened = store::Store::open(folder_ + "/archive.db");
    if (!opened) throw std::runtime_error(opened.error().to_string());
    store_ = *std::move(opened);
  }
  ~Archive() {
    store_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  store::Store& store() { return *store_; }
  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
  std::unique_ptr<store::Store> store_;
};

/// A file of the repository's examples.
inline std::string example_file(const std::string& source_folder, const std::string& name) {
  std::ifstream stream(source_folder + "/examples/" + name, std::ios::binary);
  if (!stream) throw std::runtime_error("no example " + name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace axiometry::testing_support
