// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "axiometry/base/result.h"
#include "axiometry/store/store.h"
#include "cli/failure.h"
#include "cli/flags/verb.h"

/// What the verbs below `store` have in common.
namespace axiometry::cli {

/// The archive of --store; an empty address: that of the environment, else among the user's data.
Result<std::unique_ptr<store::Store>> archive_at(const std::string& address, const store::Opening& opening);

Flag add_store_flag(const Verb& verb, std::string& address);

struct VerbText {
  const char* name;
  const char* description;
};

/// A verb with --store that runs with its arguments, whose member is `address`; a failure is printed.
template <typename Arguments>
Verb store_verb(const Verb& store, VerbText text, int& exit_code, const std::shared_ptr<Arguments>& arguments,
                Result<int> (*run)(const Arguments&)) {
  Verb verb = store.add_subcommand(text.name, text.description);
  add_store_flag(verb, arguments->address);
  verb.callback([arguments, run, &exit_code] {
    const auto code = run(*arguments);
    exit_code = code ? *code : failed(code.error());
  });
  return verb;
}

}  // namespace axiometry::cli
