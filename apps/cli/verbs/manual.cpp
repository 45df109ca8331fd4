// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "axiometry/base/version.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/recording.h"
#include "axiometry/language/language.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

std::string roff(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += "\\&";
      result += c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string option_entry(const CLI::Option& option) {
  std::string names;
  for (const std::string& s : option.get_snames()) names += (names.empty() ? "-" : ", -") + s;
  for (const std::string& l : option.get_lnames()) names += (names.empty() ? "--" : ", --") + l;
  const bool positional = names.empty();
  if (positional) names = option.get_name(true);
  const bool value = !positional && option.get_items_expected_max() > 0;
  return fmt::format(".TP\n.B {}{}\n{}\n", roff(names), value ? " \\fI" + roff(option.get_type_name()) + "\\fR" : "",
                     roff(option.get_description()));
}

std::string verb_section(const CLI::App& verb) {
  std::string text = fmt::format(".SS {}\n{}.\n", roff(verb.get_name()), roff(verb.get_description()));
  for (const CLI::Option* option : verb.get_options())
    if (option != verb.get_help_ptr()) text += option_entry(*option);
  return text;
}

std::string parameter_section() {
  std::string text = ".SH PARAMETERS\nKeys in JSON, CSV, tolerance tables and \\-\\-tolerance.\n";
  for (const auto& p : iso230_2::parameters)
    text += fmt::format(".TP\n.B {}\n{} ({}), clause {}.\n", roff(p.key), roff(p.title), p.symbol, p.clause);
  return text;
}

std::string formats_section() {
  std::string text = ".SH FORMATS\nRecognised by content; \\-\\-format forces one.\n";
  for (const formats::Format* format : formats::format_table())
    text += fmt::format(".TP\n.B {}\n{}.\n", roff(format->id), roff(format->title));
  for (const formats::Recording* recording : formats::recording_table())
    text += fmt::format(".TP\n.B {}\n{}; a continuous recording.\n", roff(recording->id), roff(recording->title));
  return text;
}

std::string manual(const CLI::App& program) {
  std::string text = fmt::format(".TH AXIOMETRY 1 \"\" \"axiometry {}\" \"User Commands\"\n", version);
  text += ".SH NAME\naxiometry \\- positioning tests of machine tool axes after ISO 230\\-2\n";
  text +=
      ".SH SYNOPSIS\n.B axiometry evaluate\n.I FILE\\fR...\n[\\fIoptions\\fR]\n.br\n.B axiometry\n.I "
      "verb\n[\\fIoptions\\fR]\n";
  text += ".SH DESCRIPTION\n" + roff(program.get_description()) + "\n.SH VERBS\n";
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
    text += verb_section(*verb);
  text += parameter_section() + formats_section();
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\nDone.\n.TP\n.B 1\nThe command line is wrong.\n.TP\n.B 2\nAn input cannot be read or "
      "an output cannot be written.\n"
      ".TP\n.B 3\nA parameter does not conform to its tolerance, or an expectation of a case is not met.\n"
      ".TP\n.B 4\nNo parameter is known not to conform, but the uncertainty leaves one undecided, or there are "
      "tolerances of a test and none of them could be judged. Of several codes the lowest one but 0 is given.\n";
  text += ".SH ENVIRONMENT\n.TP\n.B AXIOMETRY_LANGUAGE\n" +
          roff(fmt::format("Language ({}) in which every verb tells in the terminal what is wrong; --language of a "
                           "verb comes first.",
                           language::tags_of_languages())) +
          "\n.TP\n.B NO_COLOR\nNo colour in the terminal when set.\n";
  text += ".SH EXAMPLES\n.nf\n" + roff(program.get_subcommand("evaluate")->get_footer()) + "\n.fi\n";
  return text;
}

}  // namespace

void add_manual(const Verb& program, int& exit_code) {
  const Verb verb = program.add_subcommand("manual", "Print the manual page (roff): axiometry manual | man -l -");
  verb->callback([program, &exit_code] {
    fmt::print("{}", manual(program.app()));
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
