// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"

namespace dorsum {

void AddCommonOptions(CLI::App* command, Session* session) {
  command->add_flag("--json", session->json, "results as JSON on the standard output");
  command->add_flag("-q,--quiet", session->quiet, "no progress and no warnings");
  command
      ->add_option("--threads", session->threads,
                   "threads, 0 for one per processor; results do not depend on it")
      ->check(CLI::Range(0, 1024));
}

void AddTable(CLI::App* command, OptionTable* table) {
  for (const OptionSpec& spec : table->specs()) {
    const std::string name = spec.name;
    auto* option = command->add_option_function<std::string>(
        "--" + name,
        [table, name](const std::string& value) {
          if (const Status status = table->Set(name, value); !status.ok()) {
            throw CLI::ValidationError(status.error().message);
          }
        },
        spec.help);
    std::string choices;
    for (const std::string& choice : spec.choices) choices += (choices.empty() ? "" : "|") + choice;
    option->type_name(choices.empty() ? "VALUE" : choices)->default_str(OptionTable::ValueText(spec));
    option->group("Stages and tuning");
  }
}

CLI::Validator NumberFrom(double min, double max) {
  const auto text = [](double value) { return CLI::detail::to_string(value); };
  const std::string range = text(min) + " to " + text(max);
  const auto check = [min, max, range](const std::string& value) {
    double number = 0.0;
    const bool fine = CLI::detail::lexical_cast(value, number) && number >= min && number <= max;
    return fine ? std::string() : value + " is no number from " + range;
  };
  return {check, "NUMBER from " + range};
}

Status ReadSettings(const std::string& path, const std::string& section, CLI::App* command,
                    OptionTable* table) {
  if (path.empty()) return {};
  DORSUM_RETURN_IF_ERROR(table->ReadToml(path, section));
  for (const OptionSpec& spec : table->specs()) {
    const CLI::Option* option = command->get_option("--" + spec.name);
    if (option->count() > 0) DORSUM_RETURN_IF_ERROR(table->Set(spec.name, option->results().back()));
  }
  return {};
}

}  // namespace dorsum
