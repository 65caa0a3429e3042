// SPDX-License-Identifier: Apache-2.0
#include "cli/session.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace dorsum {
namespace {

std::atomic<bool> interrupted{false};  // a signal handler can reach nothing else
static_assert(std::atomic<bool>::is_always_lock_free);

spdlog::logger& Log() {
  static const auto kLogger = [] {
    auto logger = spdlog::stderr_color_mt("dorsum");
    logger->set_pattern("dorsum: %^%l%$: %v");
    return logger;
  }();
  return *kLogger;
}

}  // namespace

int ExitCode(ErrorCode code) {
  switch (code) {
    case ErrorCode::kAnswerIsNo:
      return 1;
    case ErrorCode::kUsage:
      return 2;
    case ErrorCode::kBadInput:
      return 3;
    case ErrorCode::kDevice:
      return 4;
    case ErrorCode::kInternal:
      return 5;
    case ErrorCode::kCancelled:
      return 130;
  }
  return 5;
}

void CatchInterrupts() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
  // A file that may not grow further is a failed write, to be told, and not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
}

Context Session::MakeContext() {
  Context context;
  context.threads = threads;
  context.cancel = &interrupted;
  if (!quiet && !json && isatty(STDERR_FILENO) != 0) {
    context.progress = [this](std::string_view stage, double fraction) {
      constexpr std::size_t kBar = 24;
      const auto full = static_cast<std::size_t>(kBar * std::clamp(fraction, 0.0, 1.0));
      const std::string bar = std::string(full, '#') + std::string(kBar - full, '-');
      std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %.*s", bar.c_str(), 100.0 * fraction,
                   static_cast<int>(stage.size()), stage.data());
      std::fflush(stderr);
      progress_shown_ = true;
    };
  }
  return context;
}

void Session::EndProgress() {
  if (progress_shown_) std::fputs("\r\033[K", stderr);
  progress_shown_ = false;
}

void Session::Warn(const std::vector<std::string>& warnings) {
  EndProgress();
  if (quiet) return;
  for (const std::string& warning : warnings) Log().warn(warning);
}

void Session::Print(const std::string& text, const Json& result) {
  EndProgress();
  // Names of files may hold any bytes; those that are not UTF-8 are replaced, since dump() would throw.
  const std::string out = json ? result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n" : text;
  std::fwrite(out.data(), 1, out.size(), stdout);
}

int Session::Finish() {
  EndProgress();
  if (std::fflush(stdout) != 0 && error_.message.empty())
    error_ = BadInput("cannot write to the standard output");
  if (error_.message.empty()) return 0;
  Log().error(error_.message);
  return ExitCode(error_.code);
}

}  // namespace dorsum
