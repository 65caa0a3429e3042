// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "base/options.h"
#include "cli/session.h"

namespace dorsum {

// Each adds one command to the program: its options, and what to do when it is chosen.
void AddSimulate(CLI::App* app, Session* session);
void AddBoard(CLI::App* app, Session* session);
void AddCalibrate(CLI::App* app, Session* session);
void AddCapture(CLI::App* app, Session* session);
void AddDoctor(CLI::App* app, Session* session);
void AddStudio(CLI::App* app, Session* session);
void AddReconstruct(CLI::App* app, Session* session);
void AddStripes(CLI::App* app, Session* session);
void AddEvaluate(CLI::App* app, Session* session);
void AddDesign(CLI::App* app, Session* session);
void AddCampaign(CLI::App* app, Session* session);

// The options that every command has.
void AddCommonOptions(CLI::App* command, Session* session);

// Every entry of a table as an option --NAME of the command, in the group "Stages and tuning". The table must
// outlive the parsing.
void AddTable(CLI::App* command, OptionTable* table);

// Accepts finite numbers from `min` to `max`; CLI::Range lets NaN pass.
CLI::Validator NumberFrom(double min, double max);

// Reads [section] of the settings file before the command line's own values, which win.
Status ReadSettings(const std::string& path, const std::string& section, CLI::App* command,
                    OptionTable* table);

}  // namespace dorsum
