// SPDX-License-Identifier: Apache-2.0
#include "studio/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <memory>

// In the global namespace, where rcc puts it.
static void LoadTexts() { Q_INIT_RESOURCE(translations); }

namespace dorsum {
namespace {

constexpr const char* kKey = "studio/language";
constexpr const char* kEnglish = "en";

bool IsSpoken(const QString& code) {
  const auto& all = Languages();
  return std::any_of(all.begin(), all.end(), [&](const Language& language) { return language.code == code; });
}

}  // namespace

const std::vector<Language>& Languages() {
  static const std::vector<Language> all = {
      {kEnglish, "English"}, {"de", "Deutsch"}, {"cs", QString::fromUtf8("Čeština")}};
  return all;
}

QString ChosenLanguage() {
  const QString code = QSettings().value(kKey).toString();
  return IsSpoken(code) ? code : QString();
}

void ChooseLanguage(const QString& code) {
  QSettings settings;
  if (code.isEmpty()) {
    settings.remove(kKey);
  } else {
    settings.setValue(kKey, code);
  }
}

QString LanguageOf(const QStringList& desktop) {
  for (const QString& name : desktop) {
    QString code = name.section(QLatin1Char('-'), 0, 0).section(QLatin1Char('_'), 0, 0);
    if (IsSpoken(code)) return code;
  }
  return kEnglish;
}

bool SpeakLanguage(QCoreApplication* application, const QString& code) {
  LoadTexts();
  auto own = std::make_unique<QTranslator>(), of_qt = std::make_unique<QTranslator>();
  if (!own->load(":/translations/dorsum_" + code + ".qm")) return false;
  qDeleteAll(application->findChildren<QTranslator*>(Qt::FindDirectChildrenOnly));  // of the language before
  if (of_qt->load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(of_qt.get());
    of_qt.release()->setParent(application);
  }
  QCoreApplication::installTranslator(own.get());
  own.release()->setParent(application);
  const QLocale locale(code);
  if (QLocale().language() != locale.language()) QLocale::setDefault(locale);
  return true;
}

void SpeakChosenLanguage(QCoreApplication* application) {
  const QString chosen = ChosenLanguage();
  SpeakLanguage(application, chosen.isEmpty() ? LanguageOf(QLocale::system().uiLanguages()) : chosen);
}

}  // namespace dorsum
