// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/store_address.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/store/store.h"
#include "cli/archive_proof.h"
#include "cli/failure.h"
#include "cli/flags/store_flags.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store/calibrations.h"
#include "cli/verbs/store/compensations.h"

namespace axiometry::cli {
namespace {

struct StoreArguments {
  std::string address;
  std::string file;
  std::vector<std::string> files;
  std::vector<std::string> seals;
  std::vector<std::string> heads;
  std::string public_key;
  std::string authority;
  std::string key;
  std::string text;
  std::int64_t limit = 50;
  bool change_key = false;
  bool json = false;
};

using Arguments = std::shared_ptr<StoreArguments>;

Result<std::unique_ptr<store::Store>> opened(const StoreArguments& arguments, const store::Opening& opening) {
  return archive_at(arguments.address, opening);
}

constexpr store::Opening to_look{.create = false, .read_only = true};

/// What a program that was killed has begun to write into the file itself, only who may write can take back; while
/// changes stand in the log beside it, who looks shall throw nothing of it away.
Result<std::unique_ptr<store::Store>> opened_to_look(const std::string& address) {
  std::error_code none;
  const auto size_of_log = std::filesystem::file_size(address + "-wal", none);
  return store::Store::open(address, {.create = false, .read_only = !none && size_of_log > 0});
}

json::Value number(std::int64_t value) { return static_cast<double>(value); }

/// "machines" as a line of numbers calls them; what is meant stands behind it where a language is looked up.
std::string counted_name(std::string_view name) {
  constexpr std::string_view meaning = " [counted]";
  std::string said = in_language_asked(fmt::format("{}{}", name, meaning));
  if (said.ends_with(meaning)) said.resize(said.size() - meaning.size());
  return said;
}

Result<int> info(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const std::string address, app::store_address(arguments.address));
  AXIOMETRY_TRY(const auto archive, opened_to_look(address));
  AXIOMETRY_TRY(const store::Counts counts, archive->counts());
  const store::Info about = archive->info();
  const std::pair<const char*, std::int64_t> numbers[] = {{"machines", counts.machines},
                                                          {"axes", counts.axes},
                                                          {"instruments", counts.instruments},
                                                          {"plans", counts.plans},
                                                          {"tests", counts.tests},
                                                          {"calibrations", counts.calibrations},
                                                          {"compensations", counts.compensations},
                                                          {"documents", counts.documents},
                                                          {"content_bytes", counts.content_bytes}};
  if (arguments.json) {
    json::Value root = json::Value::object();
    root.add("kind", about.kind);
    root.add("location", about.location);
    root.add("schema", about.schema);
    root.add("writable", about.obstacle.empty());
    root.add("why_not", about.obstacle.empty() ? json::Value() : json::Value(about.obstacle));
    json::Value& counted = root.add("counts", json::Value::object());
    for (const auto& [name, count] : numbers) counted.add(name, number(count));
    fmt::print("{}\n", json::dump(root));
    return exit_done;
  }
  const std::string access =
      about.obstacle.empty() ? "can be written" : fmt::format("can only be read: {}", about.obstacle);
  fmt::print("{}\n{}, {}, {}\n", report::printable(about.location), about.kind == "sqlite" ? "SQLite" : "PostgreSQL",
             in_language_asked(fmt::format("schema {}", about.schema)), in_language_asked(access));
  for (const auto& [name, count] : numbers)
    fmt::print("  {}{}\n", left(counted_name(name == std::string_view("content_bytes") ? "bytes measured" : name), 16),
               count);
  return exit_done;
}

/// "A 9.6 µm"; of a test of one direction "A↑ 5.2 µm"; "A –" where it has none.
std::string figure_text(const store::TestRow& row, std::string_view letter) {
  constexpr std::pair<std::string_view, std::string_view> senses[] = {{"", ""}, {"_up", "↑"}, {"_down", "↓"}};
  for (const auto& [suffix, arrow] : senses)
    for (const store::FigureRecord& figure : row.figures)
      if (figure.parameter == fmt::format("{}{}", letter, suffix))
        return fmt::format("{}{} {} {}", letter, arrow,
                           format_fixed(figure.value, 1, language::usual_numbers(language_asked())),
                           row.unit == "arcsec" ? "″" : "µm");
  return fmt::format("{} –", letter);
}

Result<int> list(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const std::string address, app::store_address(arguments.address));
  AXIOMETRY_TRY(const auto archive, opened_to_look(address));
  store::TestFilter filter;
  filter.text = arguments.text;
  filter.limit = arguments.limit;
  AXIOMETRY_TRY(const store::TestPage page, archive->tests(filter));
  for (const store::TestRow& row : page.rows)
    fmt::print("{} {} {} {} {} {} {}\n", left(fmt::format("{}", row.id), 7),
               left(report::printable(row.measured_on), 11), left(report::printable(row.machine_name), 24),
               left(report::printable(row.axis_name), 5), left(figure_text(row, "A"), 13),
               left(in_language_asked(row.verdict), 17), report::printable(row.title));
  fmt::print("{}\n", in_language_asked(fmt::format("{} of {}", page.rows.size(), page.total)));
  return exit_done;
}

/// Each file as a whole; the first that cannot be read ends it, and those in front of it are kept.
Result<int> add(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const auto archive, opened(arguments, {}));
  app::Workbench workbench(*archive);
  for (const std::string& name : arguments.files) {
    AXIOMETRY_TRY(const std::string bytes, app::whole_file(name));
    const app::Upload upload{.name = std::filesystem::path(name).filename().string(), .bytes = bytes};
    AXIOMETRY_TRY(const app::Received received,
                  app::in_file(workbench.receive(std::span(&upload, 1), {"import", "axiometry store add"}), name));
    for (const app::ReceivedTest& test : received.tests) {
      fmt::print("test {}: {}\n", test.id, report::printable(test.title));
      for (const std::string& remark : test.remarks) fmt::print("{}\n", in_language_asked("noted: ", remark));
    }
    if (const auto& same = received.same_content; !same.empty())
      fmt::print("{}\n", in_language_asked("noted: ", fmt::format("the same bytes are kept as test {} already",
                                                                 fmt::join(same, ", "))));
    std::fflush(stdout);  // what is said is kept, even if the next one ends this process
  }
  return exit_done;
}

/// The usual mistake, where no --store is given, is to name the store itself.
Result<int> backup(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const std::string address, app::store_address(arguments.address));
  const auto refused_with_call = [&](Error error) {
    if (!arguments.address.empty()) return std::unexpected(std::move(error));
    error.message = fmt::format("{}; the call is: axiometry store backup NEW_FILE --store {}", error.message,
                                store::Store::open(arguments.file, to_look) ? arguments.file : "STORE");
    return std::unexpected(std::move(error));
  };
  const auto archive = opened_to_look(address);
  std::error_code ignored;
  const bool exists = std::filesystem::exists(arguments.file, ignored);
  if (!archive) return exists ? refused_with_call(archive.error()) : std::unexpected(archive.error());
  const auto made = (*archive)->backup(arguments.file);
  if (!made)
    return made.error().kind == ErrorKind::conflict ? refused_with_call(made.error()) : std::unexpected(made.error());
  AXIOMETRY_TRY(const auto copy, store::Store::open(arguments.file, to_look));
  AXIOMETRY_TRY(const store::Counts counts, copy->counts());
  for (const std::string& lost : made->missing_indexes)
    fmt::print("{}\n", in_language_asked("noted: ", fmt::format("{}; 'axiometry store restore' makes it anew", lost)));
  for (const auto* notes : {&made->extras, &made->notes})
    for (const std::string& note : *notes) fmt::print("{}\n", in_language_asked("noted: ", note));
  fmt::print("{}: {}\n", report::printable(arguments.file),
             in_language_asked(fmt::format("tests {}, machines {}; prove it with: axiometry store verify {}",
                                           counts.tests, counts.machines, arguments.file)));
  return exit_done;
}

Result<int> restore(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const std::string address, app::store_address(arguments.address));
  AXIOMETRY_TRY(const store::Restored restored, store::Store::restore(arguments.file, address));
  AXIOMETRY_TRY(const auto archive, store::Store::open(address, {.create = false}));
  for (const std::string& left : restored.left_behind) fmt::print("left behind: {}\n", report::printable(left));
  fmt::print("{}: tests {}, machines {}, from {}\n", report::printable(archive->info().location), restored.counts.tests,
             restored.counts.machines, report::printable(arguments.file));
  return exit_done;
}

Result<int> verify(const StoreArguments& arguments) {
  StoreArguments asked = arguments;
  if (!asked.file.empty()) asked.address = asked.file;
  AXIOMETRY_TRY(const auto archive, opened(asked, {.create = false, .read_only = true, .damaged_log = true}));
  return verify_archive(*archive,
                        {arguments.seals, arguments.public_key, arguments.json, arguments.heads, arguments.authority});
}

Result<int> seal(const StoreArguments& arguments) {
  AXIOMETRY_TRY(const auto archive, opened(arguments, to_look));
  return seal_archive(*archive, {arguments.file, arguments.key, arguments.change_key, arguments.authority});
}

constexpr const char* store_examples = R"(Examples:
  axiometry store backup copy.db --store tests.db        while others go on working
  axiometry store verify copy.db                         what is in it is as it was written
  axiometry store seal today.seal --store tests.db       sign the end of the audit trail; keep the file elsewhere
  axiometry store verify tests.db --seal today.seal      nothing from before that day is missing
  axiometry store seal today.seal --store tests.db --time-stamp http://timestamp.example/tsr
  axiometry store verify tests.db --seal today.seal --authority roots.pem   and when the seal was there
  axiometry store verify tests.db --head 17:3f2a9c0b1d2e4f56    the trail is still that of a report on paper
  axiometry store restore copy.db --store postgresql://archive@db.example/axiometry
  axiometry store add run1.csv run2.csv --store tests.db
  axiometry store calibrate lengths.csv --plan seven.json --store tests.db      lines, with their files
  axiometry store calibrate lengths.csv --machine machine.json --store tests.db the 21 errors

Exit codes: 0 done, 1 wrong use, 2 bad input or output, 3 verify found problems, or a table or calibration must be
looked at before it is used.)";

}  // namespace

void add_store(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("store", "Back up, restore and verify the archive of tests, and look into it");
  verb->require_subcommand(1, 1);
  verb->footer(store_examples);
  const auto fresh = [] { return std::make_shared<StoreArguments>(); };
  Arguments made = fresh();
  store_verb(*verb, {"backup", "Write a backup of the archive into a new file"}, exit_code, made, backup)
      ->add_option("FILE", made->file, "New file; an existing one is never replaced")
      ->required();
  made = fresh();
  store_verb(*verb, {"restore", "Fill an empty or new archive from a backup, once that is verified"}, exit_code, made,
             restore)
      ->add_option("FILE", made->file, "Backup")
      ->required();
  made = fresh();
  Verb verified = store_verb(*verb,
                             {"verify",
                              "Read all of an archive or a backup and say what is not as it was "
                              "written"},
                             exit_code, made, verify);
  verified->add_option("FILE", made->file, "Backup or archive; that of --store when missing");
  verified->add_option("--seal", made->seals, "Seal from which the audit trail must go on; may be given again")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
  verified
      ->add_option("--head", made->heads,
                   "Entry from which the audit trail must go on, as an issued report says it; may be given again")
      ->type_name("N:HEX")
      ->expected(1)
      ->take_all();
  verified->add_option("--public-key", made->public_key, "Key of whom the seals must be: 64 hexadecimal digits")
      ->type_name("KEY");
  verified
      ->add_option("--authority", made->authority,
                   "Certificates (PEM) of authorities of which each seal must have a time stamp, in SEAL.tsr")
      ->type_name("FILE");
  verified->add_flag("--json", made->json, "Print JSON");
  made = fresh();
  Verb sealing = store_verb(*verb,
                            {"seal",
                             "Sign the end of the audit trail, so that who keeps the file elsewhere can see when "
                             "something is missing there"},
                            exit_code, made, seal);
  sealing
      ->add_option("FILE", made->file,
                   "Seal; one that is there is replaced only by one of the same key, where the trail goes on from it")
      ->required();
  sealing
      ->add_option("--time-stamp", made->authority,
                   "Have the seal stamped by the authority at this address (RFC 3161), into FILE.tsr")
      ->type_name("URL");
  sealing->add_flag("--change-key", made->change_key, "Replace a seal of another key, too");
  sealing
      ->add_option("--key", made->key,
                   "File of the private key, made where there is none (ARCHIVE.key; of a server among the user's data)")
      ->type_name("FILE");
  made = fresh();
  store_verb(*verb, {"info", "Say where the archive is and how much is in it"}, exit_code, made, info)
      ->add_flag("--json", made->json, "Print JSON");
  made = fresh();
  Verb listed = store_verb(*verb, {"list", "List tests, the newest first"}, exit_code, made, list);
  listed->add_option("--text", made->text, "Only those with these words in title, file, machine or axis");
  listed->add_option("--limit", made->limit, "How many (50)")->check_range(1, 1000);
  made = fresh();
  store_verb(*verb, {"add", "Put files of tests into the archive"}, exit_code, made, add)
      ->add_option("FILE", made->files, "Files of tests, in any format that is read")
      ->required();
  add_store_calibrations(*verb, exit_code);
  add_store_compensations(*verb, exit_code);
}

}  // namespace axiometry::cli
