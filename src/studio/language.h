// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

class QCoreApplication;

namespace dorsum {

struct Language {
  QString code;  // ISO 639: "de"
  QString name;  // in itself
};

// That the window speaks.
const std::vector<Language>& Languages();

// The code that a person chose, empty for the desktop's language; what is stored and unknown counts as empty.
QString ChosenLanguage();
void ChooseLanguage(const QString& code);  // from the next start on

// The first of the desktop's languages ("de-AT") that the window speaks; English where there is none.
QString LanguageOf(const QStringList& desktop);

// Lets the application speak the language from now on, Qt's own dialogs too where Qt's translations are
// installed, and write numbers as that language does. False if it has no texts. Before any window is made.
bool SpeakLanguage(QCoreApplication* application, const QString& code);

// The one that was chosen, else the desktop's.
void SpeakChosenLanguage(QCoreApplication* application);

}  // namespace dorsum
