// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/base/version.h"
#include "axiometry/language/language.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/dynamic.h"
#include "cli/verbs/temperatures.h"

namespace {

constexpr const char* examples = R"(Examples:
  axiometry evaluate test.csv                        summary in the terminal
  axiometry evaluate test.csv --report report.pdf    report for the customer
  axiometry evaluate test.csv --json -               everything for a program
  axiometry evaluate measurements/ --json all.json   a folder, one line per test
  axiometry evaluate test.csv --tolerance A=10um     exit code 3 when A does not conform
  axiometry formats csv-long                         what a file may look like

Exit codes: 0 done, 1 usage, 2 bad input or output, 3 does not conform or a finding is serious, 4 undecided.)";

/// A standard stream that was closed would lend its number to the next file that is opened, and the summary
/// would be written into a report. The wrong way of opening makes its use an error, as it was.
void occupy_closed_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

std::string unknown_word(std::string_view word, const std::vector<std::string_view>& known) {
  const auto near = axiometry::text::nearest(word, known);
  return fmt::format("found {}, expected {}", axiometry::text::quoted(word),
                     near ? fmt::format("perhaps {}", *near) : fmt::format("one of {}", fmt::join(known, ", ")));
}

/// Between the groups of a verb's flags one empty line, where CLI11 leaves two.
class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at; (at = text.find("\n\n\n")) != text.npos;) text.erase(at, 1);
    return text;
  }
};

/// A group of options is a subcommand too, without a name.
bool is_verb(const CLI::App* app) { return !app->get_name().empty(); }

/// Of a word that is no verb, such as that of "store tests", CLI11 would say only that a verb is missing.
std::string unknown_verb(const CLI::App& program, int argc, char** argv) {
  const CLI::App* level = &program;
  for (int k = 1; k < argc && k <= 2; ++k) {
    const auto verbs = level->get_subcommands(is_verb);
    if (verbs.empty()) return "";
    std::vector<std::string_view> known = {"--help", "-h"};
    if (k == 1) known.emplace_back("--version");
    for (const CLI::App* verb : verbs) known.push_back(verb->get_name());
    const std::string_view word = argv[k];
    if (std::ranges::find(known, word) == known.end()) return unknown_word(word, known);
    if (word.starts_with('-')) return "";
    level = level->get_subcommand(std::string(word));
  }
  return "";
}

/// Of a misspelt flag CLI11 does not say which one may be meant, and what stands behind it comes first.
std::string unknown_flag(const CLI::App& program, const std::string& what) {
  const std::size_t at = what.find(" --");
  if (!what.starts_with("The following argument") || at == what.npos) return what;
  const std::string word = what.substr(at + 1, what.find_first_of(" =", at + 1) - at - 1);
  const auto is_given = [](const CLI::App* app) { return is_verb(app) && app->parsed(); };
  const CLI::App* verb = &program;
  for (auto given = verb->get_subcommands(is_given); !given.empty(); given = verb->get_subcommands(is_given))
    verb = given.front();
  std::vector<const CLI::App*> groups = verb->get_subcommands(std::not_fn(is_verb));
  groups.push_back(verb);
  std::vector<std::string> known;
  for (const CLI::App* group : groups)
    for (const CLI::Option* option : group->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const auto near = axiometry::text::nearest(word, std::vector<std::string_view>(known.begin(), known.end()));
  return near ? fmt::format("found {}, expected perhaps {}", axiometry::text::quoted(word), *near) : what;
}

/// Of a text that CLI11 makes no number of it says neither what was expected nor why. Such options are whole numbers,
/// all of them: others are read by our own functions.
std::string not_converted(const std::string& what) {
  using namespace axiometry;
  constexpr std::string_view beginning = "Could not convert: ";
  const std::size_t equals = what.find(" = ");
  if (!what.starts_with(beginning) || equals == std::string::npos) return what;
  const std::string name = what.substr(beginning.size(), equals - beginning.size()), text = what.substr(equals + 3);
  const bool is_negative = text.starts_with('-');
  const bool is_whole = !text.empty() && text.find_first_not_of("0123456789", is_negative ? 1 : 0) == text.npos;
  return fmt::format("{}: found {}, expected {}", name, axiometry::text::quoted(text),
                     !is_whole     ? "a whole number"
                     : is_negative ? "a whole number of 0 or more"
                                   : "a smaller whole number");
}

/// The value of --language, wherever it stands: what is wrong with the call may stand before it. Nothing where it is
/// none, which the verb refuses.
std::optional<axiometry::language::Language> asked_language(int argc, char** argv) {
  constexpr std::string_view flag = "--language";
  std::optional<axiometry::language::Language> asked;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (word == flag && k + 1 < argc) asked = axiometry::language::language_of(argv[k + 1]);
    if (word.starts_with(flag) && word.substr(flag.size()).starts_with('='))
      asked = axiometry::language::language_of(word.substr(flag.size() + 1));
  }
  return asked;
}

/// What AXIOMETRY_LANGUAGE asks for in all calls; what is none of the languages is told.
std::optional<axiometry::language::Language> usual_language() {
  const char* const tag = std::getenv("AXIOMETRY_LANGUAGE");
  if (tag == nullptr || *tag == '\0') return {};
  const auto language = axiometry::language::chosen_language(tag);
  if (language) return *language;
  axiometry::cli::tell("AXIOMETRY_LANGUAGE: " + language.error().message);
  return {};
}

/// A flag that some verbs took and others refused would be a surprise.
void add_language_where_none_is(CLI::App& verb) {
  const auto below = verb.get_subcommands(is_verb);
  for (CLI::App* const one : below) add_language_where_none_is(*one);
  if (below.empty() && verb.get_option_no_throw("--language") == nullptr) axiometry::cli::add_language(verb);
}

int run(int argc, char** argv) {
  using namespace axiometry::cli;
  const auto asked = asked_language(argc, argv);
  if (const auto language = asked ? asked : usual_language()) tell_faults_in(*language);
  int exit_code = exit_done;
  CLI::App program("Tests how truly a machine tool's axes move: ISO 230-2 from the measured file to the report.",
                   "axiometry");
  program.formatter(std::make_shared<HelpText>());  // what is added below takes it over
  program.set_version_flag("--version", fmt::format("axiometry {}", axiometry::version), "Print the version and exit");
  program.set_help_flag("--help,-h", "Print this help and exit");
  program.require_subcommand(1);
  const Verb verbs(program);
  add_evaluate(verbs, exit_code);
  add_uncertainty(verbs, exit_code);
  add_plan(verbs, exit_code);
  add_nc(verbs, exit_code);
  add_capture(verbs, exit_code);
  add_convert(verbs, exit_code);
  add_periodic(verbs, exit_code);
  add_straightness(verbs, exit_code);
  add_squareness(verbs, exit_code);
  add_angles(verbs, exit_code);
  add_dynamic(verbs, exit_code);
  add_compare_rules(verbs, exit_code);
  add_compensate(verbs, exit_code);
  add_simulate(verbs, exit_code);
  add_air(verbs, exit_code);
  add_temperatures(verbs, exit_code);
  add_tracking(verbs, exit_code);
  add_volumetric(verbs, exit_code);
  add_formats(verbs, exit_code);
  add_licenses(verbs, exit_code);
  add_schema(verbs, exit_code);
  add_check(verbs, exit_code);
  add_serve(verbs, exit_code);
  add_store(verbs, exit_code);
  add_bench(verbs, exit_code);
  add_completion(verbs, exit_code);
  add_manual(verbs, exit_code);
  add_language_where_none_is(program);
  program.footer(examples);  // behind the verbs: each takes over what is there when it is made, and has its own or none
  try {
    if (const std::string fault = unknown_verb(program, argc, argv); !fault.empty()) throw CLI::ValidationError(fault);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      program.exit(error);
    } else {
      fmt::print(stderr, "axiometry: {}\n{}\n", told_fault(unknown_flag(program, not_converted(error.what()))),
                 told_fault("Try 'axiometry --help' or 'axiometry VERB --help'."));
      return exit_usage;
    }
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return failed({"cannot write", "(standard output)", {}});
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  occupy_closed_standard_streams();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // out of memory and the like; our own faults are Results
    std::fprintf(stderr, "axiometry: %s\n", error.what());
    return axiometry::cli::exit_bad_input;
  }
}
