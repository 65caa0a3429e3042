// SPDX-License-Identifier: Apache-2.0
// The tests' own main: a window's tests need an application, and a display to draw on. Where there is none, a
// virtual one is started for as long as the tests run.
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <csignal>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studio/language.h"

#ifdef __SANITIZE_ADDRESS__
// Graphics drivers stay loaded: what only their own variables point to would count as lost without them.
extern "C" int dlclose(void* /*library*/) { return 0; }
#endif

namespace {

// Xvfb on a display of its own choice; 0 where it cannot be started.
pid_t StartDisplay() {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    const std::string number = std::to_string(ends[1]);
    close(ends[0]);
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // however the tests end
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "2600x1700x24", "-nolisten", "tcp",
           static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  std::string name;  // a number and, perhaps later, the end of its line
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) name += c;
  close(ends[0]);
  if (name.empty()) {
    waitpid(child, nullptr, 0);
    return 0;
  }
  setenv("DISPLAY", (":" + name).c_str(), 1);
  return child;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const pid_t display = std::getenv("DISPLAY") == nullptr ? StartDisplay() : 0;
  if (std::getenv("DISPLAY") == nullptr) setenv("QT_QPA_PLATFORM", "offscreen", 1);
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  int failed = 0;
  {
    QApplication application(argc, argv);
    QApplication::setOrganizationName("Dorsum");
    QApplication::setApplicationName("dorsum-studio-test");
    QTemporaryDir settings;  // not those of a person, nor of a test that runs beside this one
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    dorsum::SpeakLanguage(&application, "en");
    failed = RUN_ALL_TESTS();
  }
  if (display > 0) {
    kill(display, SIGTERM);
    waitpid(display, nullptr, 0);
  }
  return failed;
}
