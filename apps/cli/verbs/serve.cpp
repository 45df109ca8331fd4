// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/store_address.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/test_records.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "server/workbench_server.h"

namespace axiometry::cli {
namespace {

struct ServeArguments {
  server::ServeOptions options;
  std::string token_file;
  bool quiet = false;
};

constexpr unsigned port_max = 65'535;
constexpr unsigned long long upload_mb_max = store::content_bytes_max >> 20;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Result<std::string> token_of(const std::string& file) {
  if (file.empty()) return environment("AXIOMETRY_TOKEN");
  AXIOMETRY_TRY(const std::string text, app::whole_file(file));
  const std::string token(text::trim(text));
  if (token.empty()) return std::unexpected(Error{"found an empty file, expected a token", file, {}});
  return token;
}

/// Of a file with a secret, where its mode lets in some of those to whom it should be shut.
void tell_of_others(const std::string& file, unsigned shut_to) {
  struct stat status {};
  if (file.empty() || ::stat(file.c_str(), &status) != 0 || (status.st_mode & shut_to) == 0) return;
  tell({fmt::format("found a file that others may read or write (mode {:o}), expected one for its owner only (600)",
                    static_cast<unsigned>(status.st_mode & 0777U)),
        file,
        {}});
}

int exit_code_of(const server::ServeEnd& end) { return end.signal == SIGINT ? exit_interrupted : exit_done; }

/// Threads that still work cannot be ended otherwise; what they were doing is whole in the store or not in it.
[[noreturn]] void cut_off(const server::ServeEnd& end) {
  tell("ended while requests were still being answered; what they had not yet kept is not in the store");
  std::fflush(nullptr);
  std::_Exit(exit_code_of(end));
}

int serve(ServeArguments& arguments) {
  auto token = token_of(arguments.token_file);
  if (!token) return failed(token.error());
  arguments.options.token = *std::move(token);
  constexpr unsigned group_and_all = 066;  // to read or write; what may only be executed tells nothing
  constexpr unsigned all = 06;             // some systems have a group for those who may use keys of TLS
  tell_of_others(arguments.token_file, group_and_all);
  tell_of_others(arguments.options.key, all);
  auto address = app::store_address(arguments.options.store);
  if (!address) return failed(address.error());
  arguments.options.store = *std::move(address);
  const server::ServeObserver observer{
      .ready =
          [&](const std::string& url) {
            fmt::print("Axiometry workbench: {}\n", url);
            std::fflush(stdout);
            if (!arguments.quiet) tell(fmt::format("store {}; Ctrl-C ends", arguments.options.store));
          },
      .notice = [](const std::string& text) { tell(text); },
  };
  const auto end = server::serve(arguments.options, observer, cut_off);
  return end ? exit_code_of(*end) : failed(end.error());
}

void add_reach(const Verb& verb, ServeArguments& arguments) {
  server::ServeOptions& options = arguments.options;
  add_read(verb, {"--port", "N", "Port (8230); 0 for a free one"}, [&options](const std::string& text) -> Result<void> {
    const auto port = parse_count(text);
    if (!port || *port > port_max) return fail(fmt::format("found {}, expected 0 to 65535", text::quoted(text)));
    options.port = static_cast<unsigned>(*port);
    return {};
  });
  verb.add_option("--listen", options.listen,
                  "Address (127.0.0.1). One that others can reach needs --certificate, --key and a token")
      ->type_name("ADDRESS");
  verb.add_option("--certificate", options.certificate, "Certificate and its chain in PEM: serve https")
      ->type_name("FILE");
  verb.add_option("--key", options.key, "Its private key in PEM")->type_name("FILE");
  verb.add_option("--token-file", arguments.token_file,
                  "File that holds a secret of at least 16 characters, asked of everybody (or the environment's "
                  "AXIOMETRY_TOKEN)")
      ->type_name("FILE");
  verb.add_option("--host-name", options.host_names,
                  "A further name by which browsers reach this machine; may be repeated")
      ->type_name("NAME");
  verb.add_option("--public-address", options.public_addresses,
                  "Where a proxy that ends TLS offers this server to browsers: https://calibration.example; needs a "
                  "token. Nothing that a proxy says in headers is trusted; may be repeated")
      ->type_name("URL");
}

}  // namespace

void add_serve(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("serve", "Serve the workbench: a page for the whole test, and its archive");
  auto arguments = std::make_shared<ServeArguments>();
  server::ServeOptions& options = arguments->options;
  verb->add_option("--store", options.store,
                   "Archive: a file, made where there is none, or postgresql://…; without it AXIOMETRY_STORE, else the "
                   "user's own")
      ->type_name("ADDRESS");
  add_reach(*verb, *arguments);
  add_read(*verb, {"--upload-limit", "MB", "Largest file that is taken, in units of 1 048 576 bytes (64)"},
           [&options](const std::string& text) -> Result<void> {
             const auto mb = parse_count(text);
             if (!mb || *mb == 0 || *mb > upload_mb_max)
               return fail(fmt::format("found {}, expected 1 to {}", text::quoted(text), upload_mb_max));
             options.limits.upload_bytes = std::size_t{*mb} << 20;
             options.limits.held_bytes = 4 * options.limits.upload_bytes;
             return {};
           });
  verb->add_option_function<std::vector<std::string>>(
          "--source",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              auto source = app::parse_capture_source(text);
              if (!source) throw UsageError("--source", source.error().message);
              options.sources.push_back(*std::move(source));
            }
          },
          "What captures may listen to: laser=tcp://192.168.1.20:5000 or drive=serial:///dev/ttyACM0?baud=2000000; may "
          "be repeated")
      ->type_name("NAME=ADDRESS")
      ->one_at_a_time();
  verb->add_flag("--examples", options.examples, "Put instructive tests into the archive if it is empty");
  verb->add_flag("--log", options.log, "A line for every request on the standard error");
  verb->add_flag("--quiet,-q", arguments->quiet, "Say nothing but the address and what is wrong");
  verb->callback([arguments, &exit_code] { exit_code = serve(*arguments); });
  verb->footer(R"(Examples:
  axiometry serve                                   the user's own archive on http://127.0.0.1:8230/
  axiometry serve --store tests.db --port 0         an archive in one file, on a free port
  axiometry serve --store postgresql://archive@db.example/axiometry
  axiometry serve --listen 0.0.0.0 --host-name bench.example --certificate cert.pem --key key.pem \
    --token-file token.txt

  axiometry serve --public-address https://calibration.example --token-file token.txt

Prints one line with the address when it answers. Ctrl-C and SIGTERM finish the requests in flight, then end it.)");
}

}  // namespace axiometry::cli
