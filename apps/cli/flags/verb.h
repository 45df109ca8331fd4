// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Verbs and their options without CLI11, whose headers take longer to compile than all that a verb does: they are
/// included by verb.cpp, and by what looks at the whole command line (main, completion, manual). Verb and Flag are
/// handles, copied freely; what they stand for lives as long as the program's command line.
namespace axiometry::cli {

/// What is wrong with the command line; thrown by what reads an option and by callbacks of verbs.
struct UsageError : std::runtime_error {
  explicit UsageError(const std::string& message) : std::runtime_error(message) {}
  UsageError(const std::string& option, const std::string& message) : std::runtime_error(option + ": " + message) {}
};

/// "OUT is required".
struct MissingOption : UsageError {
  explicit MissingOption(const std::string& option) : UsageError(option + " is required") {}
};

/// Values of an option that takes as many as there are.
inline constexpr int any_number = 1 << 29;

/// An option of a verb. Each of these that changes it gives it back.
class Flag {
 public:
  Flag(CLI::Option* option = nullptr) : option_(option) {}
  const Flag* operator->() const { return this; }

  Flag type_name(const std::string& name) const;  ///< name of its value, in the help
  Flag group(const std::string& title) const;     ///< title under which it stands in the help
  Flag required() const;
  Flag check(const std::function<std::string(const std::string&)>& fault_of) const;  ///< "" where nothing is wrong
  Flag check_range(int lowest, int highest) const;
  Flag check_among(const std::vector<std::string>& words) const;
  Flag expected(int values) const;
  Flag expected(int least, int most) const;
  Flag take_all() const;          ///< keeps all values of an option that is given again
  Flag one_at_a_time() const;     ///< takes one value each time the option is given
  Flag trigger_on_parse() const;  ///< its function runs where it stands, not at the end
  Flag excludes(Flag other) const;
  Flag needs(Flag other) const;

  std::size_t count() const;  ///< how often it was given
  std::string get_name() const;
  std::vector<std::string> results() const;
  bool operator==(const Flag&) const = default;

 private:
  CLI::Option* option_;
};

class Verb {
 public:
  Verb(CLI::App& app) : app_(&app) {}
  const Verb* operator->() const { return this; }
  const Verb& operator*() const { return *this; }

  Verb add_subcommand(const std::string& name, const std::string& description) const;
  Verb add_option_group(const std::string& title) const;

  /// Instantiated in verb.cpp for the types that there are.
  template <typename Target>
  Flag add_option(const std::string& name, Target& target, const std::string& description) const;
  /// For a text, or all texts, of an option; what it throws of UsageError ends the command line.
  template <typename Text>
  Flag add_option_function(const std::string& name, const std::function<void(const Text&)>& take,
                           const std::string& description) const;
  Flag add_flag(const std::string& name, bool& target, const std::string& description) const;
  /// How often it was given; less than 0 where its negation was.
  Flag add_flag_function(const std::string& name, const std::function<void(std::int64_t)>& given,
                         const std::string& description) const;
  Flag add_flag_callback(const std::string& name, const std::function<void()>& given,
                         const std::string& description) const;

  /// Runs when the verb was given.
  void callback(const std::function<void()>& run) const;
  void footer(const std::string& text) const;
  void require_subcommand(int least, int most) const;
  bool has_chosen_subcommand() const;

  Flag get_option(const std::string& name) const;
  std::optional<Flag> find_option(const std::string& name) const;
  std::size_t count(const std::string& name) const;
  std::string get_name() const;
  CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

/// Of an option that leaves the others of its verb without a use, such as --list: throws UsageError where it was given
/// and one that is not among `beside` too.
void check_alone(const Verb& verb, const std::string& name, const std::vector<std::string>& beside = {});

/// The names of the options that a verb has so far, those of its groups too.
std::vector<std::string> option_names(const Verb& verb);

}  // namespace axiometry::cli
