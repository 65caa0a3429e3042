// SPDX-License-Identifier: Apache-2.0
#include "studio/library_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "studio/library_texts.h"

namespace dorsum {
namespace {

struct Pattern {
  const char* text;
  QStringList parts;  // before, between and after its values
  bool is_name;       // its value is one word

  bool begins() const { return !parts.front().isEmpty(); }
  qsizetype length() const { return parts.join("").size(); }  // without values
};

Pattern MakePattern(const char* text) {
  static const QRegularExpression place("%[1-9]");
  const QString english = QString::fromUtf8(text);
  QStringList parts = english.split(place);
  const bool is_name = parts.size() == 2 && !parts.front().isEmpty() && english.count(' ') <= 2;
  return {text, std::move(parts), is_name};
}

// In the order in which none takes for a value what another one says: those that begin with words of their
// own, then those that have the most.
const std::vector<Pattern>& Patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> made;
    for (const auto& texts : {LibraryTextsOfUse(), LibraryErrorsOfFiles(), LibraryErrorsOfDevices(),
                              LibraryErrorsOfCaptures(), LibraryErrorsOfCampaigns()}) {
      for (const char* text : texts) made.push_back(MakePattern(text));
    }
    std::stable_sort(made.begin(), made.end(), [](const Pattern& a, const Pattern& b) {
      return std::pair(a.begins(), a.length()) > std::pair(b.begins(), b.length());
    });
    return made;
  }();
  return all;
}

// The values in `english`, each as short as it can be; none where it is another text. By hand, since some
// hundred regular expressions take half a second to be made.
std::optional<QStringList> ValuesIn(const QString& english, const Pattern& pattern) {
  const QStringList& parts = pattern.parts;
  if (parts.size() == 1) return english == parts.front() ? std::optional(QStringList()) : std::nullopt;
  if (!english.startsWith(parts.front()) || !english.endsWith(parts.back())) return std::nullopt;
  QStringList values;
  qsizetype from = parts.front().size();
  const qsizetype end = english.size() - parts.back().size();
  for (qsizetype i = 1; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    const qsizetype to = last ? end : english.indexOf(parts[i], from + 1);
    if (to <= from || to > end) return std::nullopt;
    values.append(english.mid(from, to - from));
    from = to + parts[i].size();
  }
  if (pattern.is_name && values.front().contains(' ')) return std::nullopt;
  return values;
}

std::optional<QString> Find(const QString& english) {
  for (const Pattern& pattern : Patterns()) {
    const std::optional<QStringList> values = ValuesIn(english, pattern);
    if (!values) continue;
    const QString form = QCoreApplication::translate("library", pattern.text);
    QString said;
    for (qsizetype i = 0; i < form.size(); ++i) {
      const int value = form[i] == '%' && i + 1 < form.size() ? form[i + 1].digitValue() : -1;
      if (value < 1 || value > values->size()) {
        said += form[i];
        continue;
      }
      said += Find(values->at(value - 1)).value_or(values->at(value - 1));
      ++i;
    }
    return said;
  }
  return std::nullopt;
}

}  // namespace

QString InOwnWords(const std::string& english) {
  const QString text = QString::fromStdString(english);
  return Find(text).value_or(text);
}

QString ClausesInOwnWords(const std::string& english) {
  const QString text = QString::fromStdString(english);
  QStringList said;
  for (const QString& clause : text.split("; ")) {
    const auto found = Find(clause);
    if (!found) return Find(text).value_or(text);
    said.append(*found);
  }
  return said.join("; ");
}

bool IsKnownText(const std::string& english) {
  const QString text = QString::fromStdString(english);
  if (Find(text)) return true;
  for (const QString& clause : text.split("; ")) {
    if (!Find(clause)) return false;
  }
  return true;
}

}  // namespace dorsum
