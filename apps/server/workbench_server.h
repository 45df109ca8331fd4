// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/base/result.h"
#include "server/limits.h"

/// The workbench: store, use cases and routes behind the transport. The one place where they are put together.
namespace axiometry::server {

struct ServeOptions {
  std::string store;                 ///< file or "postgresql://…"
  std::string listen = "127.0.0.1";  ///< address
  unsigned port = 8230;              ///< 0: a free one
  std::string certificate{};         ///< PEM files; both or none
  std::string key{};
  std::string token{};                          ///< empty: none is asked for, on this machine only
  std::vector<std::string> host_names{};        ///< further names by which the server is reached
  std::vector<std::string> public_addresses{};  ///< addresses where a proxy offers it: "https://calibration.example"
  Limits limits{};
  std::vector<app::CaptureSource> sources{};  ///< sources that captures may listen to, beside the simulator
  std::string capture_folder{};               ///< folder for what captures hear, until it is in the store
  bool examples = false;                      ///< put instructive tests into a store that is empty
  bool log = false;                           ///< a line on the standard error for every request
};

/// What is told while it runs.
struct ServeObserver {
  std::function<void(const std::string& address)> ready;  ///< the address of the page: "http://127.0.0.1:8230/"
  std::function<void(const std::string& text)> notice;    ///< what the user must know: a store that cannot be written
};

/// Why the options would put the archive within everybody's reach: an address beyond this machine without TLS or
/// without a token of at least 16 characters, or a public address without a token. Also fails on half a pair of
/// certificate and key, and on an address or a public address that is none.
Result<void> check_exposure(const ServeOptions& options);

/// How it ended.
struct ServeEnd {
  int signal = 0;
  bool all_answered = true;
};

/// Serves until SIGINT or SIGTERM. Fails as check_exposure(), Store::open() and Transport::listen() do. When requests
/// are still being answered five seconds after the signal, this ends the process by `cut_off`.
Result<ServeEnd> serve(const ServeOptions& options, const ServeObserver& observer,
                       const std::function<void(const ServeEnd&)>& cut_off);

}  // namespace axiometry::server
