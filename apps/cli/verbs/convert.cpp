// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>
#include "cli/failure.h"
#include "cli/flags/verb.h"

#include "axiometry/app/convert/convert.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/drawing/utf8.h"
#include "cli/flags/reading_flags.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct ConvertArguments {
  app::ConvertOptions convert;
  bool guess = false;
  std::string save_profile;
};

/// One decision or question beside its key, broken into lines.
void print_items(const std::vector<formats::GuessDecision>& items) {
  constexpr std::size_t key_width = 18;
  constexpr std::size_t indent = key_width + 8;
  constexpr std::size_t width = 100;
  for (const formats::GuessDecision& item : items) {
    const std::string sure = item.value.empty() ? "?" : fmt::format("{:.0f}%", 100.0 * item.confidence);
    const std::string reason = in_language_asked(item.reason);
    const std::string said =
        item.value.empty() ? reason : fmt::format("{} ({})", report::printable(item.value), reason);
    fmt::print("  {}{}  {}\n", left(item.key, key_width), right(sure, 4), wrapped(said, width, indent));
  }
}

/// The first rows below the names of the columns.
void print_preview(const formats::Guess& guess) {
  constexpr std::size_t most_rows = 6;
  std::vector<std::vector<std::string>> rows = guess.preview;
  rows.resize(std::min(most_rows, rows.size()));
  if (!guess.names.empty()) rows.insert(rows.begin(), guess.names);
  constexpr std::size_t most_columns = 12;
  constexpr std::size_t widest = 24;
  std::vector<std::size_t> widths(most_columns, 0);
  for (auto& row : rows) {
    if (row.size() > most_columns) row.resize(most_columns);
    for (std::size_t c = 0; c < row.size(); ++c) {
      row[c] = report::printable(row[c]);
      widths[c] = std::max(widths[c], std::min(widest, display_width(row[c])));
    }
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) line += "  " + right(row[c], widths[c]);
    fmt::print("{}\n", line);
  }
}

int show_guess(const ConvertArguments& arguments) {
  const auto guess = app::guess_file(arguments.convert.input);
  if (!guess) return failed(guess.error());
  std::string found = fmt::format("{} from line {}", counted(guess->row_count, "row"), guess->first_line);
  if (guess->questions.empty()) found += fmt::format(", least confidence {:.0f}%", 100.0 * guess->confidence());
  fmt::print("{}\n", in_language_asked(found));
  print_preview(*guess);
  fmt::print("\n{}\n", in_language_asked("What it is taken for"));
  print_items(guess->decisions);
  if (!guess->questions.empty()) {
    fmt::print("\n{}\n", in_language_asked("Open, to be answered in a profile"));
    print_items(guess->questions);
  }
  if (!arguments.save_profile.empty())
    if (auto saved = app::save_profile(guess->profile, arguments.save_profile, arguments.convert.input); !saved)
      return failed(saved.error());
  return guess->questions.empty() ? exit_done : exit_bad_input;
}

int run_conversion(const ConvertArguments& arguments) {
  const auto left_behind = app::convert(arguments.convert);
  if (!left_behind) return failed(left_behind.error());
  for (const std::string& sentence : *left_behind) tell({sentence, arguments.convert.input, {}});
  return exit_done;
}

void check_arguments(const ConvertArguments& arguments) {
  if (!arguments.guess && !arguments.save_profile.empty())
    throw UsageError("--save-profile", "found it without --guess, expected both");
  if (arguments.guess) {
    if (!arguments.convert.output.empty())
      throw UsageError("OUT", "found an output beside --guess, expected one of the two");
    return;
  }
  if (arguments.convert.output.empty()) throw MissingOption("OUT");
  if (auto format = app::format_to_write(arguments.convert.to, arguments.convert.output); !format)
    throw UsageError(format.error().message);
}

}  // namespace

void add_convert(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("convert",
                                     "Write a measured test in another format, or guess at a file of unknown layout");
  auto arguments = std::make_shared<ConvertArguments>();
  app::ConvertOptions& convert = arguments->convert;
  verb->add_option("IN", convert.input, "Measured test: a file, or - for the standard input")->required();
  verb->add_option("OUT", convert.output, "File to write, or - for the standard output");
  verb->add_option("--to", convert.to,
                   "Format to write: json, csv-long or csv-wide (by the extension: json or csv-long)")
      ->type_name("ID")
      ->group("Output");
  verb->add_option("--format", convert.format,
                   "Read as this format instead of recognising it (see 'axiometry formats')")
      ->type_name("ID")
      ->group("Input");
  verb->add_option("--profile", convert.profile, "Read a table of any layout after this import profile")
      ->type_name("FILE")
      ->group("Input");
  add_metadata_flag(
      *verb, convert.metadata,
      "Metadata over what the file says, such as machine.name='Mill 5' (keys: 'axiometry formats metadata')");
  verb->add_flag("--guess", arguments->guess,
                 "Show what the columns of a table would be taken for; exit code 2 while "
                 "something is open")
      ->group("Guess");
  verb->add_option("--save-profile", arguments->save_profile, "Keep the guess as an import profile")
      ->type_name("FILE")
      ->group("Guess");
  verb->callback([arguments, &exit_code] {
    check_arguments(*arguments);
    exit_code = arguments->guess ? show_guess(*arguments) : run_conversion(*arguments);
  });
  verb->footer(R"(Examples:
  axiometry convert test.csv test.json
  axiometry convert psi_stage.dat stage.csv --set axis.name=X
  axiometry convert strange.txt --guess --save-profile strange-profile.json
  axiometry convert strange.txt test.json --profile strange-profile.json
  axiometry convert test.json - --to csv-wide)");
}

}  // namespace axiometry::cli
