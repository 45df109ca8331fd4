// SPDX-License-Identifier: Apache-2.0
#include "server/work/request_queues.h"

#include <utility>

namespace axiometry::server {

RequestQueues::RequestQueues(const Options& options)
    : light_(options.light), edits_(options.edits), heavy_(options.heavy) {}

WorkerPool& RequestQueues::of(Load load) {
  if (load == Load::light) return light_;
  return load == Load::edit ? edits_ : heavy_;
}

std::optional<RequestQueues::Place> RequestQueues::submit(Load load, const std::string& who,
                                                          std::function<void()> task) {
  const auto ticket = of(load).submit(who, std::move(task), load == Load::lone);
  if (!ticket) return {};
  return Place{load, *ticket};
}

bool RequestQueues::withdraw(const Place& place) { return of(place.load).withdraw(place.ticket); }

}  // namespace axiometry::server
