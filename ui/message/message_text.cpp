// SPDX-License-Identifier: BSD-3-Clause
#include "ui/message/message_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

QString textOf(const CountArgument& count) {
  // Of bytes and points, which are never below 0.
  if (count.is_grouped) return QLocale().toString(static_cast<qulonglong>(count.value));
  return QString::number(count.value);
}

QString textOf(const NumberArgument& number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const char form = number.form == NumberArgument::Form::significant ? 'g' : 'f';
  QString digits = locale.toString(number.value, form, number.digits);
  if (number.form == NumberArgument::Form::trimmed && digits.contains(locale.decimalPoint())) {
    while (digits.endsWith(locale.zeroDigit())) digits.chop(1);
    if (digits.endsWith(locale.decimalPoint())) digits.chop(1);
  }
  const std::string_view unit = unitText(number.unit);
  return digits + QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
}

QString textOf(const PathArgument& path) {
  return QString::fromStdString(path.bytes);
}

QString textOf(const NameArgument& name) {
  return QString::fromStdString(name.text);
}

QString textOf(const TextArgument& text) {
  return QString::fromStdString(text.text);
}

QString textOf(const WordsArgument& words) {
  QStringList list;
  for (const Message& word : words.list) list << messageText(word);
  const bool sentences = words.form == WordsArgument::Form::sentences;
  QString text = list.join(sentences ? QStringLiteral(" ") : QStringLiteral(", "));
  const bool is_clause = words.form == WordsArgument::Form::clause;
  // A full stop in Latin and in Devanagari.
  if (is_clause && (text.endsWith('.') || text.endsWith(QChar(0x0964)))) text.chop(1);
  return text;
}

QString filled(const char* sentence, const Message& message) {
  // Words of others; they have no translation.
  if (message.id == MessageId::quoted) return QString::fromStdString(englishText(message));
  const QString translated = QCoreApplication::translate(kMessageContext, sentence);
  // Nothing has the form of one in Hindi; what is not translated counts as English does.
  const bool zero_is_one =
      QLocale().language() == QLocale::Hindi && translated != QString::fromUtf8(sentence);
  const QString chosen =
      withForms(translated, [&](int place) { return isOne(message, place, zero_is_one); });
  return filledSentence(chosen, [&](int number) {
    return std::visit([](const auto& part) { return textOf(part); },
                      message.arguments.at(static_cast<std::size_t>(number) - 1));
  });
}

}  // namespace

QString messageText(const Message& message) {
  return filled(rowOf(message.id).screen, message);
}

QString messageText(const std::vector<Message>& sentences) {
  return textOf(WordsArgument::sentences(sentences));
}

QString spokenMessage(const Message& message) {
  const MessageRow& row = rowOf(message.id);
  return filled(row.spoken[0] == '\0' ? row.screen : row.spoken, message);
}

}  // namespace relievo
