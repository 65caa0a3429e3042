// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace dorsum {

// What the libraries say is English. The sentences that a person meets in the window - what to arrange for a
// calibration, verdicts, figures, findings, help, errors - are known here (library_texts.h), with the values
// that stand in them, and are given in the window's language. Others come back as they are.
QString InOwnWords(const std::string& english);

// The same of several clauses joined by "; ": all of them, or the English.
QString ClausesInOwnWords(const std::string& english);

// Whether a text is one of those known.
bool IsKnownText(const std::string& english);

}  // namespace dorsum
