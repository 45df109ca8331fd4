// SPDX-License-Identifier: Apache-2.0
#include "server/workbench_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <memory>
#include <thread>
#include <utility>

#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/workbench/examples/examples.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/broken_contract.h"
#include "axiometry/base/text/number_text.h"
#include "server/access/guard.h"
#include "server/access/security.h"
#include "server/access/security_log.h"
#include "server/http/memory.h"
#include "server/http/transport.h"
#include "server/log.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

constexpr std::size_t token_length_min = 16;
constexpr std::size_t token_length_max = 512;
constexpr std::size_t large_answer = std::size_t{4} << 20;  // bytes

constexpr std::string_view how_to_get_them =
    "; a certificate for a try: openssl req -x509 -newkey rsa:2048 -nodes -days 365 -subj /CN=NAME -addext "
    "subjectAltName=DNS:NAME -keyout key.pem -out certificate.pem; a token: openssl rand -hex 24 > token.txt";

std::string page_address(const TransportOptions& transport, unsigned port) {
  const bool any = transport.listen == "0.0.0.0" || transport.listen == "::";
  const std::string host = any ? "localhost" : transport.listen;
  const bool is_v6 = host.contains(':');
  return fmt::format("{}://{}{}{}:{}/", transport.certificate.empty() ? "http" : "https", is_v6 ? "[" : "", host,
                     is_v6 ? "]" : "", port);
}

void log_answer(const Service::Answered& answered) {
  log_line(fmt::format("{} {} {} {} {} bytes {} ms", log_text(answered.request.peer), log_text(answered.request.method),
                       log_text(answered.request.path), answered.status, answered.bytes,
                       format_fixed(answered.milliseconds, 1)));
}

/// What every request passes and leaves behind.
struct Doors {
  Site site;
  TokenGate token;
  SecurityLog log;
};

Service service_of(const Router& router, Doors& doors, const ServeOptions& options) {
  Service service;
  service.refused = [&router, &doors](const Request& request) -> std::optional<Response> {
    if (auto refused = refused_by_guard(request, doors.site)) return refused;
    if (auto refused = doors.token.refused(request)) return refused;
    return router.refused(request);
  };
  service.peer_of = [&doors](const Request& request) { return doors.token.peer_of(request); };
  service.queue_of = [&router](const Request& request) { return router.queue_of(request); };
  service.keeps = [&router](const Request& request) { return router.keeps(request); };
  service.body_max = [&router](const Request& request) { return router.body_max(request); };
  service.read = [&router](std::shared_ptr<Request> request) {
    Job job = router.read(std::move(request));
    job.answer = [answer = std::move(job.answer)](const std::stop_token& stop) {
      Response response = answer(stop);
      if (response.body.size() > large_answer) give_back_memory();
      return response;
    };
    return job;
  };
  service.finish = [tls = !options.certificate.empty()](Response& response) { add_security_headers(response, tls); };
  service.secured = [&doors](const Request& request, const Response& response) {
    doors.log.tell({response.event, request.peer, request.method, request.path, response.status});
  };
  if (options.log) service.answered = log_answer;
  return service;
}

Result<std::unique_ptr<app::CaptureService>> open_captures(const ServeOptions& options, app::Workbench& workbench) {
  std::string folder = options.capture_folder;
  if (folder.empty()) {
    AXIOMETRY_TRY(folder, app::captures_folder(workbench.archive().info()));
  }
  return app::CaptureService::open({.folder = std::move(folder), .sources = options.sources},
                                   app::keeping_in(workbench));
}

void add_api_routes(Router& router, const Context& context) {
  add_test_routes(router, context);
  add_rule_routes(router, context);
  add_periodic_routes(router, context);
  add_equipment_routes(router, context);
  add_audit_routes(router, context);
  add_plan_routes(router, context);
  add_capture_routes(router, context);
  add_tracking_routes(router);
  add_coordinates_routes(router);
  add_dynamic_routes(router);
  add_motion_routes(router);
  add_calibration_routes(router, context);
  add_compensation_routes(router, context);
  add_volumetric_routes(router);
}

/// Who reads has gone, or a file is as large as it may be: the write fails then and is told, the program goes on.
void fail_instead_of_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

Result<std::vector<PublicAddress>> public_addresses(const ServeOptions& options) {
  std::vector<PublicAddress> addresses;
  for (const std::string& text : options.public_addresses) {
    AXIOMETRY_TRY(auto address, parse_public_address(text));
    addresses.push_back(std::move(address));
  }
  return addresses;
}

}  // namespace

Result<void> check_exposure(const ServeOptions& options) {
  AXIOMETRY_TRY(const bool is_loopback, server::is_loopback(options.listen));
  if (options.certificate.empty() != options.key.empty())
    return fail(fmt::format("found --{} alone, expected --certificate and --key together",
                            options.key.empty() ? "certificate" : "key"));
  if (!options.token.empty() && options.token.size() < token_length_min)
    return fail(
        fmt::format("found a token of {} characters, expected at least {}", options.token.size(), token_length_min));
  if (options.token.size() > token_length_max)
    return fail(
        fmt::format("found a token of {} characters, expected at most {}", options.token.size(), token_length_max));
  AXIOMETRY_TRY(const auto addresses, public_addresses(options));
  const auto reached = std::ranges::find(addresses, false, &PublicAddress::is_local);
  if (reached != addresses.end() && options.token.empty())
    return fail(
        fmt::format("found the public address {}, which others can reach, without a token, expected --token-file or "
                    "the environment's AXIOMETRY_TOKEN; a token: openssl rand -hex 24 > token.txt",
                    reached->origin));
  if (is_loopback) return {};
  if (options.certificate.empty())
    return fail(
        fmt::format("found the address {}, which others can reach, without TLS, expected --certificate and "
                    "--key{}",
                    options.listen, how_to_get_them));
  if (options.token.empty())
    return fail(
        fmt::format("found the address {}, which others can reach, without a token, expected --token-file or "
                    "the environment's AXIOMETRY_TOKEN{}",
                    options.listen, how_to_get_them));
  return {};
}

Result<ServeEnd> serve(const ServeOptions& options, const ServeObserver& observer,
                       const std::function<void(const ServeEnd&)>& cut_off) {
  AXIOMETRY_TRY_VOID(check_exposure(options));
  const ContractsThrow in_its_request;
  fail_instead_of_signals();
  const bool tls = !options.certificate.empty();
  const TransportOptions transport_options{.listen = options.listen,
                                           .port = options.port,
                                           .certificate = options.certificate,
                                           .key = options.key,
                                           .limits = options.limits};
  AXIOMETRY_TRY(const auto transport, Transport::listen(transport_options));
  AXIOMETRY_TRY(const auto store, store::Store::open(options.store));
  if (const store::Info info = store->info(); !info.writable)
    observer.notice(fmt::format("{}: can be read, not written: {}", info.location, info.why_not));

  const unsigned port = transport->port();
  AXIOMETRY_TRY(auto addresses, public_addresses(options));
  Doors doors{.site = make_site({.tls = tls,
                                 .listen = options.listen,
                                 .port = port,
                                 .names = options.host_names,
                                 .public_addresses = std::move(addresses)}),
              .token = TokenGate({.token = options.token, .tls = tls, .port = port}),
              .log = SecurityLog(log_line)};
  app::Workbench workbench(*store);
  if (options.examples) AXIOMETRY_TRY_VOID(app::add_examples(workbench));
  AXIOMETRY_TRY(const auto captures, open_captures(options, workbench));
  for (const std::string& recording : captures->without_order())
    observer.notice(
        fmt::format("{}: found no order beside it that can be read, expected one; 'axiometry capture --plan "
                    "PLAN --from {}' plays it",
                    recording, recording));
  Router router;
  add_service_routes(router, {.store = *store, .token = doors.token, .upload_bytes = options.limits.upload_bytes});
  add_session_routes(router, doors.token);
  add_api_routes(router, {.store = *store, .workbench = workbench, .captures = *captures});
  add_page_routes(router, page_files());
  router.expect(QueryNames(openapi_files().front().bytes));

  const Service service = service_of(router, doors, options);
  std::jthread warming;
  const auto end = transport->run(service, [&] {
    observer.ready(page_address(transport_options, port));
    warming = std::jthread([&store = *store, &observer](const std::stop_token& stop) {
      try {
        if (const auto warmed = store.warm_up(stop); !warmed) observer.notice(warmed.error().to_string());
      } catch (const std::exception& exception) {
        log_failure("warming up the archive", exception);
      }
    });
  });
  const ServeEnd result{.signal = end.signal, .all_answered = end.all_answered};
  if (result.all_answered) return result;
  doors.log.tell_left_out();
  cut_off(result);
  return result;
}

}  // namespace axiometry::server
